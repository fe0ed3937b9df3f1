# SPDX-License-Identifier: MPL-2.0
"""Runs a command and says what it cost, as GNU time sees it."""
import dataclasses
import pathlib
import re
import subprocess


@dataclasses.dataclass
class Cost:
    wall: float = 0.0  # [s]
    cpu: float = 0.0  # [s] user + system: what other users of the machine do not disturb
    memory: float = 0.0  # [MB] largest resident set

    def __add__(self, other: "Cost") -> "Cost":
        return Cost(self.wall + other.wall, self.cpu + other.cpu, max(self.memory, other.memory))

    def scaled(self, share: float) -> "Cost":
        return Cost(self.wall * share, self.cpu * share, self.memory)


def _seconds(clock: str) -> float:
    total = 0.0
    for part in clock.split(":"):
        total = 60 * total + float(part)
    return total


def run(command: list, log: pathlib.Path, folder: pathlib.Path = pathlib.Path(".")) -> Cost:
    """Runs `command` in `folder`, its output in `log`. Raises with the log's end when it fails."""
    report = log.with_suffix(".time")
    with open(log, "w") as out:
        done = subprocess.run(["/usr/bin/time", "-v", "-o", report.resolve(), *map(str, command)],
                              cwd=folder, stdout=out, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        tail = "\n".join(log.read_text().splitlines()[-15:])
        raise RuntimeError(f"{command[0]} failed, see {log}:\n{tail}")
    text = report.read_text()

    def value(name: str) -> str:
        return re.search(name + r".*?: ([\d:.]+)\n", text)[1]

    return Cost(_seconds(value(r"Elapsed \(wall clock\) time \(h:mm:ss or m:ss\)")),
                float(value("User time")) + float(value("System time")),
                float(value("Maximum resident set size")) / 1024)
