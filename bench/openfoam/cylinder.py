#!/usr/bin/python3
# SPDX-License-Identifier: MPL-2.0
"""porefines against OpenFOAM's pisoFoam: cylinder at Re 100 in the thesis's domain, the same uniform grid and
the same steps on both sides, CPU seconds per step on one core.

    bench/openfoam/cylinder.py [cells per diameter, default 16] [folder]

pisoFoam: the thesis's settings (Euler, LUST, two correctors, GAMG and PBiCGStab to 1e-6) on the staircase of the grid.
porefines: BDF2, LUST, velocity and pressure to 1e-6. Cost = difference of two runs of different length, so that set-up
drops out; CPU time, so that a busy machine weighs the same on both.
PF names the program. Needs openfoam, python3-numpy.
"""
import json
import os
import pathlib
import re
import resource
import shutil
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parents[2]
STEP = 0.4  # of a cell at the inlet's speed: Courant number about 0.8 at the cylinder's shoulders
LENGTHS = (30, 90)  # steps


def head(kind: str, name: str) -> str:
    return f"FoamFile {{ version 2.0; format ascii; class {kind}; object {name}; }}\n"


def cpu(words, folder) -> float:
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    with open(folder / (pathlib.Path(words[0]).name + ".log"), "w") as log:
        subprocess.run(words, cwd=folder, check=True, stdout=log, stderr=subprocess.STDOUT)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def foam_case(case: pathlib.Path, n: int, steps: int) -> None:
    for d in ("0", "constant", "system"):
        (case / d).mkdir(parents=True, exist_ok=True)
    write = lambda name, kind, body: (case / name).write_text(head(kind, pathlib.Path(name).name) + body)
    nx, ny, h = 63 * n // 2, 25 * n, 1 / n
    x, y = (np.arange(nx) + 0.5) * h - 11.5, (np.arange(ny) + 0.5) * h - 12.5
    fluid = np.flatnonzero(np.hypot(x[None, :], y[:, None]).ravel() > 0.5)
    write("constant/fluid.cellSet", "cellSet", f"{len(fluid)}\n(\n" + "\n".join(map(str, fluid)) + "\n)\n")
    corners = " ".join(f"({a} {b} {c})" for c in (0, h) for a, b in ((0, 0), (31.5, 0), (31.5, 25), (0, 25)))
    write("system/blockMeshDict", "dictionary", f"""scale 1; vertices ({corners});
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} 1) simpleGrading (1 1 1)); edges ();
boundary (inlet {{type patch; faces ((0 4 7 3));}} outlet {{type patch; faces ((1 2 6 5));}}
sides {{type patch; faces ((0 1 5 4) (3 7 6 2));}} cylinder {{type wall; faces ();}} flat {{type empty; faces ((0 3 2 1) (4 5 6 7));}});
mergePatchPairs ();
""")
    write("0/U", "volVectorField", """dimensions [0 1 -1 0 0 0 0]; internalField uniform (1 0.02 0);
boundaryField { inlet {type fixedValue; value uniform (1 0 0);} outlet {type zeroGradient;} sides {type slip;}
cylinder {type noSlip;} flat {type empty;} }
""")
    write("0/p", "volScalarField", """dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;
boundaryField { "(inlet|sides|cylinder)" {type zeroGradient;} outlet {type fixedValue; value uniform 0;} flat {type empty;} }
""")
    write("constant/transportProperties", "dictionary", "transportModel Newtonian; nu [0 2 -1 0 0 0 0] 0.01;\n")
    write("constant/turbulenceProperties", "dictionary", "simulationType laminar;\n")
    dt = STEP / n
    write("system/controlDict", "dictionary", f"""application pisoFoam; startFrom startTime; startTime 0; stopAt endTime;
endTime {dt * steps:.10g}; deltaT {dt:.10g}; writeControl timeStep; writeInterval 100000000; timePrecision 10;
""")
    write("system/fvSchemes", "dictionary", """ddtSchemes {default Euler;} gradSchemes {default Gauss linear;}
divSchemes {default none; div(phi,U) Gauss LUST grad(U); div((nuEff*dev2(T(grad(U))))) Gauss linear;}
laplacianSchemes {default Gauss linear corrected;} interpolationSchemes {default linear;} snGradSchemes {default corrected;}
""")
    write("system/fvSolution", "dictionary", """solvers { p {solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0.01;}
pFinal {$p; relTol 0;} U {solver PBiCGStab; preconditioner DILU; tolerance 1e-6; relTol 0;} }
PISO {nCorrectors 2; nNonOrthogonalCorrectors 0; pRefCell 0; pRefValue 0;}
""")


def openfoam(folder: pathlib.Path, n: int):
    times = []
    for steps in LENGTHS:
        case = folder / f"foam_{steps}"
        foam_case(case, n, steps)
        cpu(["blockMesh"], case)
        sets = case / "constant/polyMesh/sets"  # blockMesh empties it
        sets.mkdir(exist_ok=True)
        shutil.copy(case / "constant/fluid.cellSet", sets / "fluid")
        cpu(["subsetMesh", "-overwrite", "fluid", "-patch", "cylinder"], case)
        times.append(cpu(["pisoFoam"], case))
        log = (case / "pisoFoam.log").read_text()
    courant = re.findall(r"Courant Number mean: \S+ max: (\S+)", log)
    return (times[1] - times[0]) / (LENGTHS[1] - LENGTHS[0]), float(courant[-1])


def porefines(folder: pathlib.Path, n: int):
    case = folder / "porefines"
    case.mkdir(parents=True, exist_ok=True)
    diameter, speed = 0.2e-3, 0.5
    h, dt = diameter / n, STEP / n * diameter / speed
    program = os.environ.get("PF", str(ROOT / "build/release/porefines"))
    times = []
    for steps in LENGTHS:
        times.append(cpu([program, "run", str(ROOT / "cases/cylinder/case.toml"), "-o", str(case / str(steps)),
                          f"grid.cell_size={h:.12g} m", f'geometry.size=["6.3 mm", "5 mm", "{h:.12g} m"]',
                          f"run.end_time={dt * steps:.12g} s", f"flow.time_step={dt:.12g} s", "flow.scheme=lust",
                          "flow.courant=2", 'output=[{ kind = "summary", every = "1 s" }]', "flow.disturbance=0.02"], case))
    summary = json.loads((case / str(LENGTHS[1]) / "summary.json").read_text())
    return (times[1] - times[0]) / (LENGTHS[1] - LENGTHS[0]), summary["courant"]


def main() -> None:
    n = int(sys.argv[1]) if len(sys.argv) > 1 else 16
    folder = pathlib.Path(sys.argv[2] if len(sys.argv) > 2 else "out/bench_cylinder").resolve()
    folder.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("WM_PROJECT_DIR", "/usr/share/openfoam")
    cells = 63 * n // 2 * 25 * n
    ours, our_courant = porefines(folder, n)
    theirs, their_courant = openfoam(folder, n)
    print(f"{cells} cells, {n} per diameter")
    print(f"porefines  {ours:.4f} s a step, {1e6 * ours / cells:.3f} us a cell, Courant number {our_courant:.2f}")
    print(f"pisoFoam   {theirs:.4f} s a step, {1e6 * theirs / cells:.3f} us a cell, Courant number {their_courant:.2f}")
    print(f"ratio      {theirs / ours:.1f}")


main()
