# SPDX-License-Identifier: MPL-2.0
"""porefines' coupled step against the thesis's kind of step. Started by compare.sh.

The thesis's solver (CFDEMcoupling's cfdemSolverIB) makes in each step: a PISO step, the particles rigid in
it, one Poisson solve more, and 20 substeps of LIGGGHTS. Each part is measured with Debian's packages on the
same voxels with as many particles; searching and marking the particles' cells is given to it for nothing.
"""
import argparse
import json
import os
import pathlib
import re
import subprocess

import cases
import measured
import piso
import pore_image
import porefines_run
from setting import Setting

SUBSTEPS = 20
# cfdemSolverIB settles a 10 um sphere monotonically up to a step of 1e-6 s, rings at 5e-6 s, diverges at 1e-4 s
# (spec/baselines.md): a sixth of its response time d^2/(18 nu), which is how it is carried to other diameters.
STABLE_STEP, AT_DIAMETER = 1e-6, 10e-6


def arguments() -> argparse.Namespace:
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--steps", type=int, default=20, help="of each code that are timed (20)")
    p.add_argument("--particles", type=int, default=60)
    p.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("out/coupled"))
    return p.parse_args()


def liggghts_substeps(folder: pathlib.Path, count: int) -> float:
    """CPU seconds of SUBSTEPS substeps."""
    steps = 20000
    data = folder / "spheres.data"
    cases.box(data, count, 0.1)
    (folder / "in.box").write_text(cases.INPUT.format(
        boundary="p p p", data=data.resolve(), extra="", warm=0, steps=steps))
    done = subprocess.run(["liggghts", "-in", "in.box"], cwd=folder, capture_output=True, text=True,
                          check=True)
    loop = float(re.findall(r"Loop time of ([\d.e+-]+)", done.stdout)[-1])
    return loop / steps * SUBSTEPS


def porefines_case(folder: pathlib.Path, pore, s: Setting, diameter: float, count: int) -> None:
    case = porefines_run.write_case(folder, pore, s)
    text = case.read_text().split("\n", 1)[1]  # its first line asks for no output
    case.write_text(f"""{text}
[run]
end_time = "1 s"

[[particles]]
diameter = "{1e6 * diameter:.9g} um"
count    = {count}

[[output]]
kind  = "summary"
every = "1 s"
""")


def run_porefines(program: str, folder: pathlib.Path, end: float,
                  travel: float = 0.5) -> tuple[float, dict]:
    """CPU seconds and summary of a run to `end` [s]."""
    out = folder / "out"
    cost = measured.run([program, "run", folder / "case.toml", "-o", out, f"run.end_time={end:.9g} s",
                         f"coupling.travel={travel}"],
                        folder / "run.log")
    return cost.cpu, json.loads((out / "summary.json").read_text())


def compare(args: argparse.Namespace) -> None:
    s = Setting(pixel=2e-6, layers=8, length=400e-6, width=300e-6)
    diameter = 6 * s.pixel
    program, folder = os.environ["PF"], args.output
    folder.mkdir(parents=True, exist_ok=True)
    pore = pore_image.make(program, folder, s.pixel, s.length, s.width)
    cells = int(pore.sum()) * s.layers
    print(f"{cells} fluid cells, {args.particles} particles of 6 cells; load {os.getloadavg()[0]:.1f} on "
          f"{os.cpu_count()} cores")

    step = STABLE_STEP * (diameter / AT_DIAMETER) ** 2
    two = piso.seconds_per_step(folder / "piso2", pore, s, step, args.steps, 2)
    three = piso.seconds_per_step(folder / "piso3", pore, s, step, args.steps, 3)
    contacts = liggghts_substeps(folder, args.particles)
    theirs = two + max(three - two, 0) + contacts
    print(f"thesis's kind of step, {step:.2g} s long: PISO {two:.3f} s + Poisson {three - two:.3f} s + "
          f"{SUBSTEPS} substeps {contacts:.2g} s = {theirs:.3f} s of CPU")

    porefines_case(folder / "porefines", pore, s, diameter, args.particles)
    _, first = run_porefines(program, folder / "porefines", 1e-9)
    volume = cells * s.pixel**3
    turnover = volume / first["flow_rate_m3_s"]  # [s] of one pore volume
    print(f"a pore volume takes {turnover:.3g} s; with the thesis's steps {turnover / step * theirs:.3g} s of CPU")
    for travel in (0.5, 1):  # cells a step: places right to 0.007 and 0.02 cells after 11 cells of way
        short, a = run_porefines(program, folder / "porefines", 0.02 * turnover, travel)
        longer, b = run_porefines(program, folder / "porefines", 0.06 * turnover, travel)
        ours = (longer - short) / (b["steps"] - a["steps"])
        our_step = (b["time_s"] - a["time_s"]) / (b["steps"] - a["steps"])
        print(f"\nporefines, {travel} cells a step = {our_step:.2g} s: {ours:.3f} s of CPU a step, "
              f"{b['cycles_per_solve']:.1f} cycles; a pore volume {turnover / our_step * ours:.3g} s")
        print(f"cost of a step, theirs to ours:         {theirs / ours:8.2f}")
        print(f"cost of a pore volume, theirs to ours:  {theirs / step / (ours / our_step):8.0f}   "
              f"(wanted: 300 or more)")


compare(arguments())
