# SPDX-License-Identifier: MPL-2.0
"""One synthetic pore image for both codes: True = pore, rows along y, columns along x (the flow)."""
import pathlib
import subprocess

import numpy as np
from PIL import Image

BUFFER = 20e-6  # [m] open fluid before and after the grains, so that openings cut no grain


def make(program: str, folder: pathlib.Path, pixel: float, length: float, width: float) -> np.ndarray:
    """Irregular grains of about 80 um, porosity about 0.55, no throat under 16 um."""
    path = folder / "grains.png"
    um = lambda x: f"{1e6 * x:.6g} um"
    subprocess.run([program, "generate", "micromodel", "--size", um(length - 2 * BUFFER), um(width),
                    "--pixel-size", um(pixel), "--porosity", "0.55", "--grain", "80 um",
                    "--throat", "16 um", "--cemented", "0", "--seed", "7", "-o", str(path)],
                   check=True, stdout=subprocess.DEVNULL)
    grains = np.asarray(Image.open(path).convert("L")) > 127
    columns = int(round(BUFFER / pixel))
    return percolating(np.pad(grains, ((0, 0), (columns, columns)), constant_values=True))


def percolating(pore: np.ndarray) -> np.ndarray:
    """Pores that the inlet reaches: a closed pocket would make the pressure system singular.

    The open columns at both ends are joined by whatever percolates.
    """
    reached = np.zeros_like(pore)
    reached[:, 0] = pore[:, 0]
    while True:
        grown = reached.copy()
        grown[1:] |= reached[:-1]
        grown[:-1] |= reached[1:]
        grown[:, 1:] |= reached[:, :-1]
        grown[:, :-1] |= reached[:, 1:]
        grown &= pore
        if np.array_equal(grown, reached):
            break
        reached = grown
    if not reached[:, -1].any():
        raise RuntimeError("no pore connects inlet and outlet")
    return reached


def write(pore: np.ndarray, path: pathlib.Path) -> None:
    Image.fromarray(np.where(pore, 255, 0).astype(np.uint8)).save(path)
