# SPDX-License-Identifier: MPL-2.0
"""The fluid part of a step of the thesis's solver: pisoFoam, first-order Euler, LUST, to 1e-6."""
import pathlib
import re
import shutil

import numpy as np

import measured
import openfoam_run
from setting import Setting

FIRST = 10  # steps that are not counted: the flow starts from rest


def _write_numerics(case: pathlib.Path, step: float, steps: int, correctors: int) -> None:
    write = openfoam_run._write
    write(case, "system/controlDict", "dictionary", f"""application pisoFoam;
startFrom startTime; startTime 0; stopAt endTime; endTime {steps * step:.9g}; deltaT {step:.9g};
writeControl timeStep; writeInterval 1000000; writeFormat binary; timePrecision 12;
""")
    write(case, "system/fvSchemes", "dictionary", """ddtSchemes { default Euler; }
gradSchemes { default Gauss linear; }
divSchemes
{
  default none;
  div(phi,U) Gauss LUST grad(U);
  div((nuEff*dev2(T(grad(U))))) Gauss linear;
}
laplacianSchemes { default Gauss linear uncorrected; }
interpolationSchemes { default linear; }
snGradSchemes { default uncorrected; }
""")
    write(case, "system/fvSolution", "dictionary", f"""solvers
{{
  p      {{ solver GAMG; smoother GaussSeidel; tolerance 1e-6; relTol 0; }}
  pFinal {{ $p; }}
  U      {{ solver smoothSolver; smoother symGaussSeidel; tolerance 1e-6; relTol 0; }}
}}
PISO {{ nCorrectors {correctors}; nNonOrthogonalCorrectors 0; }}
""")


def seconds_per_step(folder: pathlib.Path, pore: np.ndarray, s: Setting, step: float, steps: int,
                     correctors: int) -> float:
    """CPU seconds on one core."""
    shutil.rmtree(folder, ignore_errors=True)
    openfoam_run.write_case(folder, pore, s)
    _write_numerics(folder, step, steps + FIRST, correctors)
    openfoam_run.mesh_voxels(folder)
    measured.run(["pisoFoam"], folder / "pisoFoam.log", folder)
    text = (folder / "pisoFoam.log").read_text()
    clock = [float(t) for t in re.findall(r"ExecutionTime = ([\d.]+) s", text)]
    return (clock[-1] - clock[FIRST - 1]) / (len(clock) - FIRST)
