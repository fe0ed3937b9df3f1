// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <deque>
#include <functional>
#include <vector>

#include "flow/level.hpp"
#include "flow/transfer.hpp"

namespace porefines::flow {

class RigidSpheres;

/// The levels of the multigrid: the finest spread over the ranks, coarse ones homogenised from the
/// mobility, the coarsest held whole by every rank.
///
/// Axes are halved (n -> ceil(n/2), the last cell may have one child) until they have one cell: first
/// those of short cells, until cells are nearly cubic, then all.
/// A level of at most `replicate_below` cells is gathered: all ranks then do the same small work,
/// with no messages.
class Hierarchy {
 public:
  static constexpr Index replicate_below = 40'000;

  /// Makes the finest level, empty; fill it with link_to_surface or link_to_voxels.
  /// @param spacing  cell sizes, in units of the cell along x
  Hierarchy(const par::Communicator& comm, const par::Decomposition& cut, const Vec3& spacing,
            const Boundaries& boundaries);

  /// Solves the mobility and makes the coarse levels, anew each time; call once the finest level is
  /// linked.
  void build();

  [[nodiscard]] Level& finest() { return levels_.front(); }
  [[nodiscard]] const Level& finest() const { return levels_.front(); }
  [[nodiscard]] int size() const { return static_cast<int>(levels_.size()); }
  [[nodiscard]] Level& level(int l) { return levels_[l]; }
  [[nodiscard]] const Transfer& transfer(int fine) const { return transfers_[fine]; }
  [[nodiscard]] std::size_t bytes() const;
  [[nodiscard]] int mobility_sweeps() const { return mobility_sweeps_; }

 private:
  void solve_mobility();
  bool add_coarse_level();

  par::Communicator comm_;
  Boundaries boundaries_;
  std::deque<Level> levels_;
  std::vector<Transfer> transfers_;
  int mobility_sweeps_ = 0;
};

/// One multigrid cycle; leaves the correction in u and p of the finest level, starting from zero.
///
/// load_sides() puts the right-hand side into f and g of that level (owned values suffice). Where the
/// level lends them to the residual it is called again after the coarse levels: the memory of four
/// fields for a pass over two.
/// Two sweeps before and after. Coarse levels know nothing of spheres; on the finest each sweep is
/// followed by an update of theirs.
/// @param visits  of every coarse level: 2, a W cycle; 1, a V cycle, which does where time dominates the rows
void cycle(Hierarchy& hierarchy, const std::function<void()>& load_sides,
           RigidSpheres* spheres = nullptr, int visits = 2);

/// Sweeps of the finest level, each followed by an update of the spheres; from what u and p hold.
void smooth_finest(Hierarchy& hierarchy, RigidSpheres* spheres, int count);

}  // namespace porefines::flow
