# SPDX-License-Identifier: MPL-2.0
"""The case in OpenFOAM: simpleFoam, SIMPLEC with GAMG, on the voxels or on a snapped mesh.

x is the flow, y lateral (slip), z the depth (no slip). Pressures are kinematic.
"""
import pathlib
import re
import shutil

import numpy as np

import measured
from setting import Setting

WITHIN = 1e-3  # of the converged permeability


def _write(case: pathlib.Path, name: str, kind: str, body: str) -> None:
    path = case / name
    path.parent.mkdir(parents=True, exist_ok=True)
    head = f"FoamFile {{ version 2.0; format ascii; class {kind}; object {path.stem}; }}\n"
    path.write_text(head + body)


def _box(case: pathlib.Path, pore: np.ndarray, s: Setting) -> None:
    (ny, nx), nz = pore.shape, s.layers
    x, y, z = nx * s.pixel, ny * s.pixel, nz * s.pixel
    corners = " ".join(f"({a:.9g} {b:.9g} {c:.9g})" for c in (0, z)
                       for a, b in ((0, 0), (x, 0), (x, y), (0, y)))
    _write(case, "system/blockMeshDict", "dictionary", f"""scale 1;
vertices ({corners});
blocks (hex (0 1 2 3 4 5 6 7) ({nx} {ny} {nz}) simpleGrading (1 1 1));
edges ();
boundary
(
  inlet  {{ type patch; faces ((0 4 7 3)); }}
  outlet {{ type patch; faces ((1 2 6 5)); }}
  sides  {{ type patch; faces ((0 1 5 4) (3 7 6 2)); }}
  plates {{ type wall;  faces ((0 3 2 1) (4 5 6 7)); }}
  grains {{ type wall;  faces (); }}
);
mergePatchPairs ();
""")
    cells = np.flatnonzero(np.broadcast_to(pore, (nz, ny, nx)))
    text = "\n".join(map(str, cells))
    _write(case, "constant/pore.cellSet", "cellSet", f"{len(cells)}\n(\n{text}\n)\n")


def _fields(case: pathlib.Path, s: Setting) -> None:
    _write(case, "0/p", "volScalarField", f"""dimensions [0 2 -2 0 0 0 0];
internalField uniform {s.kinematic_drop / 2};
boundaryField
{{
  inlet  {{ type fixedValue; value uniform {s.kinematic_drop}; }}
  outlet {{ type fixedValue; value uniform 0; }}
  "(sides|plates|grains)" {{ type zeroGradient; }}
}}
""")
    _write(case, "0/U", "volVectorField", """dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
  "(inlet|outlet)"  { type zeroGradient; }
  sides             { type slip; }
  "(plates|grains)" { type noSlip; }
}
""")
    _write(case, "constant/transportProperties", "dictionary",
           f"transportModel Newtonian;\nnu [0 2 -1 0 0 0 0] {s.kinematic_viscosity};\n")
    _write(case, "constant/turbulenceProperties", "dictionary", "simulationType laminar;\n")


def _control(case: pathlib.Path) -> None:
    _write(case, "system/controlDict", "dictionary", """application simpleFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime 2000; deltaT 1;
writeControl timeStep; writeInterval 1000000; writeFormat binary; writePrecision 12;
timeFormat general; timePrecision 12; runTimeModifiable false;
functions
{
  flow
  {
    type surfaceFieldValue; libs (fieldFunctionObjects); log false; writeFields false;
    regionType patch; name outlet; operation sum; fields (phi);
    writeControl timeStep; writeInterval 1;
  }
}
""")


def _numerics(case: pathlib.Path, snapped: bool) -> None:
    normal = "corrected" if snapped else "uncorrected"
    _write(case, "system/fvSchemes", "dictionary", f"""ddtSchemes {{ default steadyState; }}
gradSchemes {{ default Gauss linear; }}
divSchemes
{{
  default none;
  div(phi,U) bounded Gauss linearUpwind grad(U);
  div((nuEff*dev2(T(grad(U))))) Gauss linear;
}}
laplacianSchemes {{ default Gauss linear {normal}; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default {normal}; }}
""")
    _write(case, "system/fvSolution", "dictionary", """solvers
{
  p { solver GAMG; smoother GaussSeidel; tolerance 1e-8; relTol 0.01; }
  U { solver PBiCGStab; preconditioner DILU; tolerance 1e-8; relTol 0.01; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 0; residualControl { p 1e-6; U 1e-6; } }
relaxationFactors { fields { p 1.0; } equations { U 0.9; } }
""")


def write_case(case: pathlib.Path, pore: np.ndarray, s: Setting, snapped: bool = False) -> None:
    _box(case, pore, s)
    _fields(case, s)
    _control(case)
    _numerics(case, snapped)


def mesh_voxels(case: pathlib.Path) -> measured.Cost:
    """blockMesh makes the whole box, subsetMesh keeps the pore."""
    block = measured.run(["blockMesh"], (case / "blockMesh.log"), case)
    sets = case / "constant/polyMesh/sets"  # blockMesh empties it
    sets.mkdir(exist_ok=True)
    shutil.copy(case / "constant/pore.cellSet", sets / "pore")
    return block + measured.run(["subsetMesh", "-overwrite", "pore", "-patch", "grains"],
                                case / "subsetMesh.log", case)


def solve(case: pathlib.Path) -> measured.Cost:
    return measured.run(["simpleFoam"], case / "simpleFoam.log", case)


def history(case: pathlib.Path) -> tuple[np.ndarray, np.ndarray]:
    """Flow rate [m^3/s] and solver time so far [s CPU] after every iteration."""
    data = case / "postProcessing/flow/0/surfaceFieldValue.dat"
    flow = np.loadtxt(data, comments="#", ndmin=2)[:, 1]
    log = (case / "simpleFoam.log").read_text()
    time = np.array([float(t) for t in re.findall(r"ExecutionTime = ([\d.]+) s", log)])
    n = min(len(flow), len(time))
    return flow[:n], time[:n]


def settled(flow: np.ndarray) -> int:
    """First iteration after which the flow rate stays within WITHIN of its last value."""
    outside = np.flatnonzero(np.abs(flow / flow[-1] - 1) > WITHIN)
    return int(outside[-1]) + 1 if len(outside) else 0


def cells(case: pathlib.Path) -> int:
    note = (case / "constant/polyMesh/owner").read_text(errors="replace")[:2000]
    return int(re.search(r"nCells:\s*(\d+)", note)[1])
