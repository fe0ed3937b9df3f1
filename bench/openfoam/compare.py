# SPDX-License-Identifier: MPL-2.0
"""porefines against OpenFOAM on the same voxels, one core each. Started by compare.sh."""
import argparse
import os
import pathlib
import shutil

import measured
import openfoam_run
import pore_image
import porefines_run
import snappy
from setting import Setting

LOOSE = 1e-3  # flow.tolerance at which porefines knows k to OpenFOAM's 0.1 %: checked in every run


def arguments() -> argparse.Namespace:
    p = argparse.ArgumentParser(description=__doc__)
    p.add_argument("--large", action="store_true", help="2 um cells, about 575,000 fluid cells "
                   "(default: 4 um, about 70,000)")
    p.add_argument("--snappy", action="store_true", help="also mesh with snappyHexMesh")
    p.add_argument("--runs", type=int, default=3, help="repeat both, report the fastest (3)")
    p.add_argument("-o", "--output", type=pathlib.Path, default=pathlib.Path("out/openfoam"))
    return p.parse_args()


def fastest(runs: list) -> measured.Cost:
    return min(runs, key=lambda cost: cost.cpu)


def run_openfoam(folder: pathlib.Path, pore, s: Setting) -> dict:
    """Mesh, then iterate until the flow has converged; afterwards, when was it good enough?"""
    shutil.rmtree(folder, ignore_errors=True)
    openfoam_run.write_case(folder, pore, s)
    mesh = openfoam_run.mesh_voxels(folder)
    whole = openfoam_run.solve(folder)
    flow, time = openfoam_run.history(folder)
    n = openfoam_run.settled(flow)
    saved = (time[-1] - time[n]) / whole.cpu  # share of the run after that iteration
    return {"mesh": mesh, "to_permeability": whole.scaled(1 - saved), "whole": mesh + whole,
            "iteration": n + 1, "iterations": len(flow), "cells": openfoam_run.cells(folder),
            "permeability": s.permeability(flow[-1], pore), "drift": abs(flow[-1] / flow[-11] - 1)}


def table(of: dict, pf: dict) -> None:
    ofs, pfs = of["mesh"] + of["to_permeability"], pf["solve"]
    row = "{:<44}{:>12}{:>12}{:>9}".format
    line = lambda name, a, b, form: print(row(name, form.format(a), form.format(b),
                                              f"{a / b:.1f} x" if b > 0 else "-"))
    print(row("one core, fastest of the runs", "OpenFOAM", "porefines", "ratio"))
    line("CPU time, start to permeability [s]", ofs.cpu, pfs.cpu, "{:.2f}")
    line("wall time, start to permeability [s]", ofs.wall, pfs.wall, "{:.2f}")
    line("CPU time, both until k is good to 0.1 % [s]", ofs.cpu, pf["loose"].cpu, "{:.2f}")
    line("wall time, both until k is good to 0.1 % [s]", ofs.wall, pf["loose"].wall, "{:.2f}")
    line("  ... porefines with fields and pictures [s]", ofs.wall, pf["full"].wall, "{:.2f}")
    line("peak memory [MB]", ofs.memory, pfs.memory, "{:.0f}")
    line("memory per fluid cell [B]", 2**20 * ofs.memory / of["cells"],
         2**20 * pfs.memory / pf["cells"], "{:.0f}")
    mine, theirs = (r["permeability"] / 9.869233e-13 for r in (pf, of))
    print(row("permeability [darcy]", f"{theirs:.4f}", f"{mine:.4f}", f"{mine / theirs - 1:+.2%}"))


def report(of: dict, pf: dict) -> None:
    print(f"\nfluid cells: OpenFOAM {of['cells']}, porefines {pf['cells']}")
    table(of, pf)
    print(f"OpenFOAM: mesh {of['mesh'].wall:.2f} s; k within {openfoam_run.WITHIN:.1%} of its last "
          f"value from iteration {of['iteration']} on, of {of['iterations']}; its last 10 change k "
          f"by {of['drift']:.1e}.")
    print(f"porefines: residual below 1e-6 in {pf['cycles']} cycles; set-up, solve and results "
          f"{pf['inside']:.2f} s by its own clock; Re = {pf['reynolds']:.2g}. With "
          f"flow.tolerance = {LOOSE} k differs from that by {pf['loose_error']:+.4%}.")
    difference = pf["permeability"] / of["permeability"] - 1
    print(f"permeabilities differ by {difference:+.2%}: both take walls on voxel faces, but put "
          "pressure and velocity at different points of a cell.")


def compare(args: argparse.Namespace) -> None:
    s = Setting(2e-6, 8) if args.large else Setting()
    program = os.environ["PF"]
    folder = args.output / ("large" if args.large else "small")
    folder.mkdir(parents=True, exist_ok=True)
    pore = pore_image.make(program, folder, s.pixel, s.length, s.width)
    ny, nx = pore.shape
    print(f"{nx} x {ny} x {s.layers} voxels of {1e6 * s.pixel:g} um, porosity {pore.mean():.3f}, "
          f"{int(pore.sum()) * s.layers} fluid; load {os.getloadavg()[0]:.1f} on "
          f"{os.cpu_count()} cores")
    porefines_run.write_case(folder / "porefines", pore, s)
    theirs, ours, loose, full, summary, rough = [], [], [], [], {}, {}
    for _ in range(args.runs):  # in turns, so that other users of the machine disturb both
        cost, summary = porefines_run.run(program, folder / "porefines", "case")
        ours.append(cost)
        cost, rough = porefines_run.run(program, folder / "porefines", "case",
                                        f"flow.tolerance={LOOSE}")
        loose.append(cost)
        full.append(porefines_run.run(program, folder / "porefines", "full")[0])
        theirs.append(run_openfoam(folder / "openfoam", pore, s))
    of = min(theirs, key=lambda r: r["whole"].cpu)
    loose_error = rough["permeability_m2"] / summary["permeability_m2"] - 1
    if abs(loose_error) > openfoam_run.WITHIN:
        raise RuntimeError(f"flow.tolerance = {LOOSE} leaves k {loose_error:+.2%} off")
    report(of, {"solve": fastest(ours), "full": fastest(full), "loose": fastest(loose),
                "loose_error": loose_error, "cells": summary["fluid_cells"],
                "permeability": summary["permeability_m2"], "cycles": summary["solver_cycles"],
                "inside": summary["wall_time_s"], "reynolds": summary["reynolds"]})
    if args.snappy:
        snappy.compare(program, folder, pore, s)


compare(arguments())
