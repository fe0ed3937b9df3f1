# SPDX-License-Identifier: MPL-2.0
"""Runs the same spheres through LIGGGHTS and porefines, in turn, and prints particle-steps per second.

CPU: all CPU seconds of a run on one rank, reading the file included. Clock: the timed steps alone.
Both are in double precision, Hertz with tangential history, e = 0.9, mu = 0.5, E = 5 MPa, step 20 ns.
"""
import argparse
import os
import pathlib
import re
import subprocess
import tempfile

import cases

WALL = "fix {name} all wall/gran model hertz tangential history primitive type 1 {axis}plane {at}\n"


def settling(side):
    return "fix g all gravity 2000 vector 0 0 -1\n" + WALL.format(name="z1", axis="z", at=0) + \
        WALL.format(name="z2", axis="z", at=side)


def pore_extra(folder):
    text = f"fix grains all mesh/surface file {folder}/pore.stl type 1 precision 1e-12 curvature 1e-5\n"
    text += "fix gw all wall/gran model hertz tangential history mesh n_meshes 1 meshes grains\n"
    for name, at in (("x", (0, 8e-4)), ("y", (0, 6e-4)), ("z", (0, 1.6e-5))):
        for k in (0, 1):
            text += WALL.format(name=f"{name}{k}", axis=name, at=at[k])
    return text + "fix g all gravity 2000 vector 1 0 -0.3\n"


def timed(command, ranks):
    """Output and CPU seconds of a program on some ranks."""
    if ranks > 1:
        command = ["mpirun", "--oversubscribe", "-n", str(ranks), *command]
    before = os.times()
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    after = os.times()
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(command)}\n{done.stdout[-2000:]}\n{done.stderr[-2000:]}")
    return done.stdout, after.children_user - before.children_user


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--quick", action="store_true", help="a tenth of the steps")
    parser.add_argument("--ranks", default="1 2")
    parser.add_argument("--cases", default="box4000 box50000 settling13000 settling50000 pore4000")
    parser.add_argument("-o", "--output", default=None)
    given = parser.parse_args()
    folder = pathlib.Path(given.output or tempfile.mkdtemp(prefix="dem_speed_"))
    folder.mkdir(parents=True, exist_ok=True)
    few = 10 if given.quick else 1
    plan = {"box4000": (4000, 20000), "box50000": (200, 2000), "settling13000": (20000, 5000),
            "settling50000": (12000, 2000), "pore4000": (5000, 10000)}
    print(f"{'case':14} ranks  LIGGGHTS CPU  clock   porefines CPU  clock   ratio CPU  clock  [M particle-steps/s]")
    for case in given.cases.split():
        kind, count = re.match(r"([a-z]+)(\d+)", case).groups()
        warm, steps = (n // few for n in plan[case])
        data = f"{folder}/{case}.data"
        if kind == "pore":
            triangles = cases.pore(str(folder), int(count))
            print(f"# {triangles} triangles")
            data, mode, extra, boundary = f"{folder}/pore.data", f"{folder}/pore.pgm", pore_extra(folder), "f f f"
        else:
            side = cases.box(data, int(count), 0.5 if kind == "box" else 0.4)
            mode = "periodic" if kind == "box" else "settling"
            extra, boundary = ("", "p p p") if kind == "box" else (settling(side), "p p f")
        script = folder / f"{case}.in"
        script.write_text(cases.INPUT.format(boundary=boundary, data=data, extra=extra, warm=warm, steps=steps))
        for ranks in map(int, given.ranks.split()):
            work = int(count) * steps * 1e-6
            total = int(count) * (steps + warm) * 1e-6
            out, cpu = timed(["liggghts", "-in", str(script), "-log", "none"], ranks)
            clock = work / float(re.findall(r"Loop time of ([\d.]+)", out)[-1])
            theirs = (total / cpu, clock)
            out, cpu = timed([os.environ["DEM_SPEED"], data, mode, str(steps), str(warm)], ranks)
            ours = (total / cpu, float(re.search(r"([\d.]+) by the clock", out)[1]))
            print(f"{case:14} {ranks:5} {theirs[0]:13.1f} {theirs[1]:6.1f} {ours[0]:15.1f} {ours[1]:6.1f}"
                  f" {ours[0] / theirs[0]:11.2f} {ours[1] / theirs[1]:6.2f}", flush=True)
            print("#", out.strip(), flush=True)


main()
