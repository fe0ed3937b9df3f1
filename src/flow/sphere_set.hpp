// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "core/six.hpp"
#include "core/types.hpp"
#include "flow/boundary.hpp"
#include "grid/block.hpp"
#include "par/communicator.hpp"
#include "par/decomposition.hpp"

namespace porefines::flow {

/// A sphere in the units of the finest level: length = fine cell along x, viscosity = 1.
struct Ball {
  std::uint64_t id = 0;
  Vec3 centre;
  Real radius = 0;  ///< that the grid sees: the calibrated one
  Real body = 0;    ///< radius of the sphere itself
  bool held = false;
  Six force{};      ///< from outside, per volume of a fine cell
  Six motion{};     ///< of the step before; kept where held
  Real mass = 0;    ///< over the step, in the rows: 0 without inertia
  Real moment = 0;  ///< of inertia, likewise
};

/// A share of the flux that a moving ball drives into a cell, on its way to the rank of that cell.
struct CellShare {
  std::uint64_t id = 0;       ///< of the ball
  std::array<int, 3> cell{};  ///< global index
  std::array<float, 6> flux{};
};

/// A ball, or its copy beyond a periodic border, where this rank's block or its ghosts meet it.
struct BallImage {
  int ball = 0;
  Vec3 centre;
};

/// The spheres that a rank must know, and the sums over the ranks that share one.
///
/// Every rank whose block, ghosts included, is met by the sphere and two cells around it holds it.
/// All holders of a sphere add their parts in the order of ranks: they get the same bits, with
/// messages between them only.
/// Tests: mpi/flow_spheres.
class SphereSet {
 public:
  SphereSet(const par::Communicator& comm, const par::Decomposition& cut, const Vec3& spacing,
            const Boundaries& boundaries, const grid::Block& block);

  /// New places of the spheres that this rank owns: their centres lie in its block. Collective.
  void distribute(std::span<const Ball> owned);

  [[nodiscard]] std::size_t owned() const { return owned_; }
  [[nodiscard]] std::size_t size() const { return balls_.size(); }  ///< owned first, then others'
  [[nodiscard]] const std::vector<Ball>& balls() const { return balls_; }
  [[nodiscard]] const std::vector<BallImage>& images() const { return images_; }
  [[nodiscard]] Real cell_volume() const { return spacing_.x * spacing_.y * spacing_.z; }
  /// Of a ball itself, in cells.
  [[nodiscard]] Real volume(std::size_t ball) const {
    const Real r = balls_[ball].body;
    return 4.0 / 3 * std::numbers::pi * r * r * r / cell_volume();
  }
  [[nodiscard]] const Vec3& spacing() const { return spacing_; }
  /// Sums `parts` (6 or 36 numbers per held ball) over the ranks that hold it; collective.
  template <std::size_t count>
  void sum(std::vector<std::array<Real, count>>& parts);

  /// Sends records to every rank whose block lies within reach of this one's; collective.
  /// @return those of all neighbours and this rank's own, in the order of ranks
  template <typename Record>
  [[nodiscard]] std::vector<Record> gather_near(const std::vector<Record>& mine) const;

  /// The held ball with this id, or -1.
  [[nodiscard]] int find(std::uint64_t id) const;

 private:
  /// A rank whose block lies within reach, and the balls that both hold, by id.
  struct Neighbour {
    int rank = 0;
    std::vector<int> shared;
  };
  void find_neighbours(Real reach);
  [[nodiscard]] bool meets(int rank, const Ball& ball) const;
  void find_images();

  par::Communicator comm_;
  par::Decomposition cut_;
  Vec3 spacing_;
  std::array<bool, 3> periodic_;
  grid::Block block_;
  Real reach_ = -1;  ///< for which the neighbours were found
  std::vector<Neighbour> neighbours_;
  std::vector<Ball> balls_;
  std::size_t owned_ = 0;
  std::vector<BallImage> images_;
  std::vector<std::pair<std::uint64_t, int>> by_id_;
};

}  // namespace porefines::flow
