# SPDX-License-Identifier: MPL-2.0
"""CSV tables of a run."""

import csv
import pathlib

import numpy as np


class MissingOutput(FileNotFoundError):
    """The run did not write this; the message says which key of the case asks for it."""


class Table(dict):
    """Columns of a table by name: 1D arrays of one length, float64, or str where a value is no number.

    A dict, so that `pandas.DataFrame(table)` works. len(table) is the number of columns, table.rows that of rows.
    """

    @property
    def rows(self):
        return len(next(iter(self.values()))) if self else 0

    def where(self, chosen):
        """The rows that a mask or an index array chooses, as a table."""
        return Table({name: values[chosen] for name, values in self.items()})


def _column(words):
    try:
        return np.array(words, dtype=np.float64)
    except ValueError:
        return np.array(words, dtype=str)


def read_table(path, advice):
    """Reads a CSV file. A last line that is cut short, as a killed run leaves it, is passed over.

    advice: what to tell when the file is not there.
    Numbers read back to the same double: porefines writes the shortest text that does.
    """
    path = pathlib.Path(path)
    if not path.exists():
        raise MissingOutput(f"{path} is not there: {advice}")
    with path.open(newline="") as file:
        lines = csv.reader(file)
        names = next(lines, [])
        rows = [row for row in lines if len(row) == len(names)]
    columns = zip(*rows) if rows else [()] * len(names)
    return Table({name: _column(words) for name, words in zip(names, columns)})
