#!/usr/bin/env python3
# SPDX-License-Identifier: MPL-2.0
"""Opens what tests/cli/vtk_reader.cpp wrote with every XDMF reader that this VTK has, and checks it.

    vtk_reader_check.py FOLDER          checks FOLDER/fields.xdmf
    vtk_reader_check.py --list          the readers that are there

Exit code 0: all that could be checked is right; 1: something is wrong; 77: no reader is there.
Debian builds python3-vtk9 without XDMF; python3-paraview and VTK's own wheels have it.
"""
import importlib
import math
import sys

CELLS = (7, 5, 3)
ORIGIN = (1e-3, -2e-3, 5e-4)
SPACING = (1e-6, 2e-6, 4e-6)
TIMES = (0.0, 0.25)
PLACES = ((0, 0, 0), (6, 0, 0), (0, 4, 0), (0, 0, 2), (3, 1, 2))


def readers():
    found = {}
    for module, name in (("vtkIOXdmf2", "vtkXdmfReader"), ("vtkIOXdmf3", "vtkXdmf3Reader")):
        try:
            found[name] = getattr(importlib.import_module("vtkmodules." + module), name)
        except (ImportError, AttributeError):
            pass
    return found


def same(found, wanted, what):
    found, wanted = tuple(found), tuple(wanted)
    if not all(math.isclose(a, b, rel_tol=1e-6, abs_tol=1e-12) for a, b in zip(found, wanted)) or len(found) != len(wanted):
        raise AssertionError(f"{what}: found {found}, wanted {wanted}")


def leaf(data):
    """The image in whatever nest of blocks the reader returns."""
    while data.IsA("vtkCompositeDataSet"):
        iterator = data.NewIterator()
        iterator.InitTraversal()
        data = iterator.GetCurrentDataObject()
    return data


def cell_at(data, place):
    """Found by position, so that a grid with exchanged axes cannot pass."""
    import vtk
    centre = [ORIGIN[a] + (place[a] + 0.5) * SPACING[a] for a in range(3)]
    return data.FindCell(centre, None, 0, 1e-14, vtk.reference(0), [0, 0, 0], [0.0] * 8)


def check(data, time):
    data = leaf(data)
    same(data.GetDimensions(), [n + 1 for n in CELLS], "dimensions")
    bounds = [v for a in range(3) for v in (ORIGIN[a], ORIGIN[a] + CELLS[a] * SPACING[a])]
    same(data.GetBounds(), bounds, "bounds")
    pressure = data.GetCellData().GetArray("pressure")
    velocity = data.GetCellData().GetArray("velocity")
    if pressure is None or velocity is None:
        raise AssertionError("pressure or velocity is not among the cell data")
    same([pressure.GetNumberOfComponents(), velocity.GetNumberOfComponents()], [1, 3], "components")
    same([pressure.GetNumberOfTuples()], [math.prod(CELLS)], "values")
    for i, j, k in PLACES:
        cell = cell_at(data, (i, j, k))
        value = 100 * time + i + 10 * j + 100 * k
        same([pressure.GetTuple1(cell)], [value], f"pressure in cell {i, j, k} at t = {time}")
        same(velocity.GetTuple3(cell), (i + 0.5, -j, time + k), f"velocity in cell {i, j, k} at t = {time}")


def check_xdmf(make, folder):
    import vtk
    reader = make()
    reader.SetFileName(folder + "/fields.xdmf")
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(vtk.vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    same(times, TIMES, "time steps")
    for time in TIMES:
        reader.UpdateTimeStep(time)
        check(reader.GetOutputDataObject(0), time)


def main():
    found = readers()
    if sys.argv[1:] == ["--list"]:
        print(" ".join(found))
        return 0 if found else 77
    for name, make in found.items():
        check_xdmf(make, sys.argv[1])
        print(f"{name}: ok")
    return 0 if found else 77


if __name__ == "__main__":
    sys.exit(main())
