// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "analysis/run_sample.hpp"
#include "par/communicator.hpp"

namespace porefines::analysis {

/// A sample that holds its arrays.
struct OwnedSample {
  std::vector<std::uint64_t> id;
  std::vector<Vec3> position;
  std::vector<Vec3> velocity;
  std::vector<Real> radius;
  std::vector<Real> wall_gap;
  std::vector<Vec3> wall_normal;
  RunSample scalars;  ///< time, pore volumes, fluid speed, particles out

  void put(std::uint64_t which, const Vec3& x, const Vec3& v, Real r, const WallTouch& wall);
  [[nodiscard]] RunSample view() const;
};

/// Everybody's particles in rising order of id, on rank 0; empty elsewhere. Collective.
/// Scalars are those of rank 0. The order does not depend on the number of ranks.
/// Test: mpi/run_readings.
[[nodiscard]] OwnedSample gather_sample(const OwnedSample& mine, const par::Communicator& comm);

}  // namespace porefines::analysis
