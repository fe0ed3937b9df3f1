# SPDX-License-Identifier: MPL-2.0
"""Fields of a run: cell values on a regular grid."""

import dataclasses
import pathlib

import numpy as np

from .tables import MissingOutput

_ADVICE = 'add [[output]] kind = "fields" to the case, with every = "..." for more than the last moment'


@dataclasses.dataclass(frozen=True)
class Fields:
    """One moment. Arrays are [z, y, x] and [z, y, x, component]; the index runs as in the HDF5 file.

    Cell (k, j, i) has its centre at origin + (i + 1/2, j + 1/2, k + 1/2) spacing, in the coordinates of the sample
    (reservoirs of open fluid lie before 0).
    """

    time: float  # [s]
    origin: np.ndarray  # [m] x, y, z of the low corner of the grid
    spacing: np.ndarray  # [m]
    values: dict  # by name: velocity [m/s], pressure [Pa], solid_fraction, and what else the file holds

    @property
    def velocity(self):
        return self.values["velocity"]

    @property
    def pressure(self):
        return self.values["pressure"]

    @property
    def solid_fraction(self):
        return self.values["solid_fraction"]

    @property
    def speed(self):
        """|u| [m/s], shape [z, y, x]."""
        return np.sqrt(np.sum(self.velocity.astype(np.float64) ** 2, axis=-1))

    def centres(self, axis):
        """[m] of the cells along axis 0 (x), 1 (y) or 2 (z)."""
        count = self.solid_fraction.shape[2 - axis]
        return self.origin[axis] + (np.arange(count) + 0.5) * self.spacing[axis]


def _h5py():
    try:
        import h5py
    except ImportError:
        raise ImportError("fields are HDF5 files: install h5py (Debian: apt-get install python3-h5py)") from None
    return h5py


def steps(folder):
    """Paths of the steps that a run wrote, in order of time."""
    return sorted(pathlib.Path(folder).glob("fields_[0-9]*.h5"))


def read_fields(folder, step=-1, names=None):
    """Reads a step; -1 is the last one. names: read these alone."""
    files = steps(folder)
    if not files:
        raise MissingOutput(f"{folder} holds no fields: {_ADVICE}")
    if not -len(files) <= step < len(files):
        raise IndexError(f"step {step}: {folder} has {len(files)} steps, 0 to {len(files) - 1}")
    with _h5py().File(files[step], "r") as file:
        chosen = names if names is not None else list(file.keys())
        return Fields(
            time=float(np.ravel(file.attrs["time_s"])[0]),
            origin=np.array(file.attrs["origin_m"]),
            spacing=np.array(file.attrs["spacing_m"]),
            values={name: file[name][...] for name in chosen},
        )
