// SPDX-License-Identifier: MPL-2.0
// A case for the thesis's engines, to check one against the other.
#pragma once

#include <string>
#include <vector>

#include "config/case.hpp"
#include "geom/build.hpp"
#include "geom/stl.hpp"
#include "sim/domain.hpp"

namespace porefines::interop {

/// The grains as triangles [m], in the sample's coordinates; empty without
/// grains.
///
/// Images: their smooth surface, as porefines solves on; 2D ones and cylinders
/// are extruded and reach `beyond` [m] through both plates, so that no triangle
/// lies in a face of the box. Circles become polygons of 128 corners, spheres
/// icospheres of 5120 triangles, both of the right volume.
[[nodiscard]] std::vector<geom::Triangle> grain_triangles(const config::Case& the_case,
                                                          const geom::Sample& sample, Real beyond);

/// Text STL: "solid grains". @throws RunError
void write_text_stl(const std::string& path, const std::vector<geom::Triangle>& triangles);

/// An OpenFOAM case: blockMeshDict, snappyHexMeshDict, grains.stl, fields,
/// schemes, Allrun.
///
/// Steady flow (SIMPLEC, simpleFoam) for creeping flow and steady = true;
/// otherwise Euler and PISO (pisoFoam) as in the thesis; LUST, GAMG for
/// pressure, PBiCGStab for velocity, 1e-6. The background mesh has porefines'
/// own cells, reservoirs included. Pressures are kinematic. postProcessing/ has
/// the flow rate and the pressures where the sample begins and ends; `Allrun`
/// prints the permeability from them, k = nu (Q/A) L / (dp/rho).
/// @throws InputError  a periodic drive, a moving wall
/// Test: cli/export (ctest label engines: runs OpenFOAM where it is installed).
void export_openfoam(const config::Case& the_case, const std::string& folder);

/// A LIGGGHTS input and STL: box, walls, materials, gravity; particles of
/// lists, and of count or fill by insert/pack.
///
/// Hertz with tangential history as ours; walls are an atom type of their own
/// with their friction. The fluid and injections with it are not LIGGGHTS's
/// part: they are named in a comment.
/// @throws InputError  a case without particles, walls that LIGGGHTS does not
/// have Test: cli/export.
void export_liggghts(const config::Case& the_case, const std::string& folder);

}  // namespace porefines::interop
