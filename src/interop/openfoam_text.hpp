// SPDX-License-Identifier: MPL-2.0
// Dictionaries of OpenFOAM that are the same for every case, but for a word or
// two.
#pragma once

#include <string>

namespace porefines::interop {

/// @param {} a point in the fluid. Settings: the cross-checks of the thesis's
/// stack, bench/openfoam/snappy.py.
inline constexpr auto foam_snappy =
    R"(castellatedMesh true; snap true; addLayers false;
geometry {{ grains.stl {{ type triSurfaceMesh; name grains; }} }}
castellatedMeshControls
{{
  maxLocalCells 20000000; maxGlobalCells 40000000; minRefinementCells 0; maxLoadUnbalance 0.1;
  nCellsBetweenLevels 2; features (); refinementRegions {{}} resolveFeatureAngle 30;
  refinementSurfaces {{ grains {{ level (0 0); patchInfo {{ type wall; }} }} }}
  locationInMesh ({}); allowFreeStandingZoneFaces true;
}}
snapControls
{{
  nSmoothPatch 3; tolerance 2.0; nSolveIter 30; nRelaxIter 5; nFeatureSnapIter 10;
  implicitFeatureSnap true; explicitFeatureSnap false; multiRegionFeatureSnap false;
}}
addLayersControls
{{
  relativeSizes true; layers {{}} expansionRatio 1; finalLayerThickness 0.3; minThickness 0.1;
  nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3;
  nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
  minMedianAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;
}}
meshQualityControls
{{
  maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-30;
  minTetQuality 1e-30; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
  minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
}}
mergeTolerance 1e-6;
)";

/// @param {} ddt scheme, "bounded " for a steady one. Thesis: Euler, linear,
/// LUST.
inline constexpr auto foam_schemes = R"(ddtSchemes {{ default {}; }}
gradSchemes {{ default Gauss linear; }}
divSchemes
{{
  default none;
  div(phi,U) {}Gauss LUST grad(U);
  div((nuEff*dev2(T(grad(U))))) Gauss linear;
}}
laplacianSchemes {{ default Gauss linear corrected; }}
interpolationSchemes {{ default linear; }}
snGradSchemes {{ default corrected; }}
)";

/// Thesis: GAMG for pressure, BiCGStab for velocity, PISO, 1e-6.
inline constexpr auto foam_solution = R"(solvers
{
  p { solver GAMG; smoother GaussSeidel; tolerance 1e-8; relTol 0.01; }
  pFinal { $p; tolerance 1e-6; relTol 0; }
  U { solver PBiCGStab; preconditioner DILU; tolerance 1e-8; relTol 0.01; }
  UFinal { $U; tolerance 1e-6; relTol 0; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-6; U 1e-6; } }
PISO { nCorrectors 2; nNonOrthogonalCorrectors 1; momentumPredictor yes; pRefCell 0; pRefValue 0; }
relaxationFactors { fields { p 1.0; } equations { U 0.9; } }
)";

/// @param {} mesher, solver, L nu / A
inline constexpr auto foam_run_script = R"sh(#!/bin/sh
# Meshes, solves, prints the permeability. Debian: apt-get install openfoam; export WM_PROJECT_DIR=/usr/share/openfoam
set -eu
cd "$(dirname "$0")"
blockMesh > blockMesh.log
{} > snappyHexMesh.log
{} > solver.log
last() {{ tail -n 1 postProcessing/"$1"/0/surfaceFieldValue.dat | awk '{{print $2}}'; }}
awk -v q="$(last flow)" -v a="$(last before_begin)" -v b="$(last after_begin)" -v c="$(last before_end)" \
  -v d="$(last after_end)" 'BEGIN {{ printf "permeability_m2 %.9g\n", {:.12g} * q / (a + b - c - d) * 2 }}'
)sh";

/// chmod +x
void make_executable(const std::string& path);

}  // namespace porefines::interop
