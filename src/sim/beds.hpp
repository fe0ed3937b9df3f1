// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "config/case.hpp"
#include "core/log.hpp"
#include "dem/system.hpp"

namespace porefines::sim {

/// The particles that a case starts with, and what there is to tell about them.
struct Bed {
  std::vector<dem::Body> bodies;     ///< ids from 0, in the order of the case
  std::vector<std::string> remarks;  ///< "sand: 500 packed, diameters scaled by 0.998"
};

/// Reads lists and makes packings; species that share a region and a filling are placed together.
/// The same on every rank; no communication.
/// @throws InputError  a list that cannot be read (file, line, column), particles outside the box, a
///                     region that is not in the box, more than fit
/// Tests: unit/beds.
[[nodiscard]] Bed make_bed(const config::Case& the_case, const dem::Settings& settings);

/// A list of spheres: CSV with the header x_m,y_m,z_m,diameter_m and optionally u,v,w (or u_m_s,
/// v_m_s, w_m_s), columns in any order.
/// @param diameter  [m] where the list has no such column; 0: it must
/// @throws InputError
[[nodiscard]] std::vector<dem::Body> read_spheres(const std::string& path, Real diameter);

/// Refuses particles that at the start overlap each other or a wall by more than `most` radii, or
/// whose centre is inside a grain. Collective, after they were inserted.
/// @throws InputError  naming the worst pair and where it is
void require_apart(const dem::System& system, Real most, const par::Communicator& comm);

}  // namespace porefines::sim
