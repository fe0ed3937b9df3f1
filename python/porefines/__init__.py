# SPDX-License-Identifier: MPL-2.0
"""Runs of porefines as numpy arrays.

    import porefines
    run = porefines.read("out/fines")
    run.summary["permeability_ratio"]       # a number of summary.json
    run.series["pore_volumes"]              # a column of series.csv, one value per sample
    run.fields().velocity[k, j, i]          # [m/s] of the last step, components x y z

Everything is in SI and keeps the names of the files. What a run did not write raises MissingOutput, which
says what to add to the case. Needs numpy; fields also need h5py (Debian: python3-numpy, python3-h5py).
"""

from .fields import Fields
from .run import Run, read
from .tables import MissingOutput, Table

DARCY = 9.869233e-13  # m^2

__all__ = ["DARCY", "Fields", "MissingOutput", "Run", "Table", "read"]
