# SPDX-License-Identifier: MPL-2.0
"""The case in porefines: written, run on one rank, read back."""
import json
import pathlib

import numpy as np

import measured
import pore_image
from setting import Setting


def write_case(folder: pathlib.Path, pore: np.ndarray, s: Setting) -> pathlib.Path:
    folder.mkdir(parents=True, exist_ok=True)
    pore_image.write(pore, folder / "pore.png")
    case = folder / "case.toml"
    case.write_text(f"""output = []   # summary.json alone; the second run writes fields and pictures too

[geometry]
source     = "pore.png"
pixel_size = "{1e6 * s.pixel:.9g} um"
depth      = "{1e6 * s.depth:.9g} um"
surface    = "voxel"

[grid]
cell_size = "{1e6 * s.pixel:.9g} um"

[fluid]
density   = "{s.density} kg/m^3"
viscosity = "{s.density * s.kinematic_viscosity} Pa s"

[flow]
inlet     = {{ face = "x-", pressure = "{s.density * s.kinematic_drop} Pa" }}
outlet    = {{ face = "x+", pressure = "0 Pa" }}
walls     = ["z-", "z+"]
slip      = ["y-", "y+"]
reservoir = "0 um"
""")
    full = folder / "full.toml"
    full.write_text(case.read_text().replace("output = []", "#", 1))
    return case


def run(program: str, folder: pathlib.Path, case: str, *overrides: str) -> tuple[measured.Cost, dict]:
    out = folder / f"out_{case}"
    cost = measured.run([program, "run", folder / f"{case}.toml", *overrides, "-o", out],
                        folder / f"{case}.log")
    return cost, json.loads((out / "summary.json").read_text())
