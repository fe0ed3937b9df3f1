// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "flow/stokes.hpp"
#include "par/decomposition.hpp"

namespace porefines::mobility {

/// As many cells for every rank as can be, where every cell is as much work as another.
[[nodiscard]] par::Decomposition even_cut(const Int3& cells, int ranks);

/// A solver of unit cells and unit viscosity without grains.
[[nodiscard]] flow::StokesSolver open_box(const Int3& cells, const flow::Boundaries& boundaries,
                                          const par::Communicator& comm = par::Communicator());

/// Walls below and above, periodic otherwise.
[[nodiscard]] flow::Boundaries slit_along_z();
[[nodiscard]] flow::Boundaries closed_box();

[[nodiscard]] flow::Sphere sphere(std::uint64_t id, const Vec3& position, Real radius);

/// A unit force per volume along x.
[[nodiscard]] flow::Drive along_x();

[[nodiscard]] flow::SolveOptions to(Real tolerance);

}  // namespace porefines::mobility
