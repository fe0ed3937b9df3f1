# SPDX-License-Identifier: MPL-2.0
"""The output folder of a run."""

import dataclasses
import functools
import json
import pathlib
import tomllib

import numpy as np

from . import fields as _fields
from .tables import MissingOutput, read_table

_READINGS = "only runs with fines in a flow write it"


@dataclasses.dataclass(frozen=True)
class Run:
    """Files of a run, each read when it is first asked for and then kept."""

    folder: pathlib.Path

    def _table(self, name, advice):
        return read_table(self.folder / name, advice)

    @functools.cached_property
    def summary(self):
        """summary.json: dict of numbers and texts; None where a value was not finite."""
        return json.loads((self.folder / "summary.json").read_text())

    @functools.cached_property
    def case(self):
        """case.toml with every default filled in: nested dict, quantities as text with their SI unit."""
        with (self.folder / "case.toml").open("rb") as file:
            return tomllib.load(file)

    @functools.cached_property
    def series(self):
        """series.csv: one row per sample."""
        return self._table("series.csv", "steady runs have no series; others always write it")

    @functools.cached_property
    def tracks(self):
        """tracks.csv: one row per particle and time, in order of time, then id."""
        return self._table("tracks.csv", 'add [[output]] kind = "tracks" to the case')

    def frames(self):
        """Time by time: pairs (time [s], Table of the particles then)."""
        times, starts = np.unique(self.tracks["time_s"], return_index=True)
        ends = np.append(starts[1:], self.tracks.rows)
        for time, start, end in zip(times, starts, ends):
            yield float(time), self.tracks.where(slice(start, end))

    def track(self, particle):
        """The way of one particle: Table in order of time."""
        chosen = self.tracks["id"] == particle
        if not chosen.any():
            raise KeyError(f"no particle {particle} in {self.folder}/tracks.csv")
        return self.tracks.where(chosen)

    @functools.cached_property
    def clogging(self):
        """clogging.csv: one row per event; ids of the fines that block are text with blanks between."""
        return self._table("clogging.csv", _READINGS)

    @functools.cached_property
    def throats(self):
        """throats.csv: the row is the id."""
        return self._table("throats.csv", _READINGS)

    @functools.cached_property
    def pores(self):
        """pores.csv: the row is the id."""
        return self._table("pores.csv", _READINGS)

    @functools.cached_property
    def throat_pressures(self):
        """throats_pressure.csv: one row per sample and throat."""
        return self._table("throats_pressure.csv", _READINGS)

    def retention(self):
        """retention.csv as profiles: dict of arrays [sample, bin]; "time_s" and "pore_volumes" [sample], "x_m" [bin]."""
        table = self._table("retention.csv", _READINGS)
        times = np.unique(table["time_s"])
        profiles = {name: values.reshape(len(times), -1) for name, values in table.items()}
        profiles["time_s"] = times
        profiles["pore_volumes"] = profiles["pore_volumes"][:, 0]
        profiles["x_m"] = profiles["x_m"][0]
        return profiles

    @functools.cached_property
    def field_times(self):
        """[s] of the steps whose fields were written."""
        count = len(_fields.steps(self.folder))
        return np.array([_fields.read_fields(self.folder, step, names=[]).time for step in range(count)])

    def fields(self, step=-1, names=None):
        """Fields of a step, the last one if not said; names: these alone. Read anew at every call."""
        return _fields.read_fields(self.folder, step, names)

    @functools.cached_property
    def agreement(self):
        """agreement.json of `porefines compare`, in the folder or in compare/ below it."""
        for path in (self.folder / "agreement.json", self.folder / "compare" / "agreement.json"):
            if path.exists():
                return json.loads(path.read_text())
        raise MissingOutput(f"{self.folder} has no agreement.json: porefines compare RUN TRACKS -o RUN/compare writes it")


def read(folder):
    """Opens the output folder of a run. Raises MissingOutput where there is none."""
    folder = pathlib.Path(folder)
    if not (folder / "summary.json").exists():
        raise MissingOutput(f"{folder} is no folder of a finished run: summary.json is missing")
    return Run(folder)
