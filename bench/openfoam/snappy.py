# SPDX-License-Identifier: MPL-2.0
"""The same pores meshed by snappyHexMesh from the smooth grain surface that porefines writes."""
import pathlib
import shutil
import subprocess

import numpy as np

import measured
import openfoam_run
from setting import Setting

CONTROLS = """
castellatedMesh true; snap true; addLayers false;
geometry { grains.stl { type triSurfaceMesh; name grains; } }
castellatedMeshControls
{
  maxLocalCells 20000000; maxGlobalCells 40000000; minRefinementCells 0; maxLoadUnbalance 0.1;
  nCellsBetweenLevels 2; features (); refinementRegions {}; resolveFeatureAngle 30;
  refinementSurfaces { grains { level (0 0); patchInfo { type wall; } } }
  locationInMesh (%s); allowFreeStandingZoneFaces true;
}
snapControls
{
  nSmoothPatch 3; tolerance 2.0; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10;
  implicitFeatureSnap true; explicitFeatureSnap false; multiRegionFeatureSnap false;
}
addLayersControls
{
  relativeSizes true; layers {} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1;
  nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3;
  nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
  minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;
}
meshQualityControls
{
  maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-30;
  minTetQuality 1e-30; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
  minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
}
mergeTolerance 1e-6;
"""


def _stretch(stl: pathlib.Path, s: Setting) -> None:
    """Lets the grains reach two cells through top and bottom: no surface lies on the box."""
    lines = []
    for line in stl.read_text().splitlines():
        words = line.split()
        if words and words[0] == "vertex":
            z = float(words[3])
            z += -2 * s.pixel if z < s.depth / 2 else 2 * s.pixel
            line = f"vertex {words[1]} {words[2]} {z:.9g}"
        lines.append(line)
    stl.write_text("\n".join(lines) + "\n")


def compare(program: str, folder: pathlib.Path, pore: np.ndarray, s: Setting) -> None:
    case = folder / "snappy"
    shutil.rmtree(case, ignore_errors=True)
    openfoam_run.write_case(case, pore, s, snapped=True)
    stl = case / "constant/triSurface/grains.stl"
    stl.parent.mkdir(parents=True)
    ours = measured.run([program, "inspect", folder / "porefines/pore.png", "--pixel-size",
                         f"{1e6 * s.pixel:.9g} um", "--depth", f"{1e6 * s.depth:.9g} um",
                         "--stl", stl, "-o", case / "inspect"], case / "inspect.log")
    _as_text(stl)
    _stretch(stl, s)
    inside = f"{2.37 * s.pixel:.9g} {pore.shape[0] * s.pixel / 2 + 0.41 * s.pixel:.9g} {s.depth * 0.513:.9g}"
    openfoam_run._write(case, "system/snappyHexMeshDict", "dictionary", CONTROLS % inside)
    cost = measured.run(["blockMesh"], case / "blockMesh.log", case)
    cost += measured.run(["snappyHexMesh", "-overwrite"], case / "snappyHexMesh.log", case)
    print(f"snappyHexMesh: {openfoam_run.cells(case)} cells in {cost.wall:.1f} s, "
          f"{cost.memory:.0f} MB; porefines needs no mesh (its STL and inspection: {ours.wall:.1f} s)")


def _as_text(stl: pathlib.Path) -> None:
    """surfaceConvert needs nothing else; binary STL in, text STL out."""
    if stl.read_bytes()[:6] != b"solid " or b"\0" in stl.read_bytes()[:2000]:
        text = stl.with_name("text.stl")
        subprocess.run(["surfaceConvert", str(stl), str(text)], check=True, stdout=subprocess.DEVNULL)
        text.replace(stl)
