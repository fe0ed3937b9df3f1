// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <string>

#include "flow/stokes.hpp"

namespace porefines::bench {

inline constexpr Real viscosity = 1.002e-3;  ///< [Pa s] of all media

/// A geometry to measure on: fixed for all time, so that numbers of two days can be compared.
struct Medium {
  std::string name;
  Int3 cells;
  Vec3 spacing;  ///< [m]
  flow::Boundaries boundaries;
  flow::Drive drive;
  std::function<Real(const Vec3&)> distance;  ///< [m] > 0 in the fluid
  bool shared = true;                         ///< cut among the ranks; else each has its own
};

/// 4 x 4 x 4 spheres in a periodic box of 128^3 cells, porosity 0.62: a dense array, all of it fluid
/// or nearly so, on which solid lines save nothing.
const Medium& sphere_array();

/// Discs between two plates, 400 x 300 x 16 cells of 2 um, porosity 0.59: like a micromodel, with
/// pressure openings, slip sides and no-slip plates.
const Medium& micromodel();

/// An empty box whose finest level fits in the second-level cache: what arithmetic alone takes.
const Medium& small_box();

/// The medium cut for all ranks.
par::Decomposition cut(const Medium& medium, int ranks);

/// A solver that is set up, made at the first call and kept: several benchmarks share it.
flow::StokesSolver& prepared(const Medium& medium);

/// Drops the kept solvers; call before MPI_Finalize.
void forget_solvers();

}  // namespace porefines::bench
