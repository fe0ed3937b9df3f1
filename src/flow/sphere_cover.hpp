// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "flow/links.hpp"
#include "flow/operator.hpp"
#include "flow/sphere_set.hpp"

namespace porefines::flow {

/// A face and the arm from a sphere's centre; r . V is component c of U + omega x arm.
struct FaceArm {
  std::uint32_t at = 0;  ///< place in a field of the level
  std::uint8_t component = 0;
  bool owned = false;          ///< this rank counts it in sums
  std::array<float, 3> arm{};  ///< [cells]

  [[nodiscard]] Real of(const Six& v) const {
    const int c = component;
    const int a = (c + 1) % 3;
    const int b = (c + 2) % 3;
    return v[c] + v[3 + a] * arm[b] - v[3 + b] * arm[a];
  }
  /// out += value r
  void add(Real value, Six& out) const {
    const int c = component;
    const int a = (c + 1) % 3;
    const int b = (c + 2) % 3;
    out[c] += value;
    out[3 + a] += value * arm[b];
    out[3 + b] -= value * arm[a];
  }
  [[nodiscard]] Six row() const { return row_of(component, {arm[0], arm[1], arm[2]}); }
};

/// A face covered by a sphere: it moves with it.
struct RigidFace {
  FaceArm face;
  float volume = 1;  ///< of its control volume, in cells: 1/2 on a pressure face of the box
};

/// A fluid face beside a sphere: friction k (u - r.V) against the surface, where the arm ends.
struct SphereLink {
  FaceArm face;
  float friction = 0;  ///< k = e / theta
  float volume = 1;
  std::int8_t towards = 0;   ///< axis + 1 of the covered neighbour, negative on the low side
  std::int64_t packed = -1;  ///< place in packed vectors, of an owned face
};

/// The flux g.V out of a cell through the faces that a sphere covers.
struct SphereCell {
  std::uint32_t at = 0;
  bool owned = false;
  std::array<float, 6> flux{};
  std::int64_t packed = -1;

  [[nodiscard]] Real of(const Six& v) const {
    Real sum = 0;
    for (std::size_t x = 0; x < 6; ++x) {
      sum += flux[x] * v[x];
    }
    return sum;
  }
};

/// What one ball does to the grid, on this rank.
struct SphereCut {
  std::vector<RigidFace> faces;
  std::vector<SphereLink> links;
  std::vector<SphereCell> cells;
};

/// What placing took, on this rank.
struct CoverCount {
  Index orphans = 0;  ///< gap cells without open faces: their fluxes went to open cells near by
  Index lost = 0;     ///< of these, without any within reach
  Index pockets = 0;  ///< small ones between spheres that were closed
};

/// Covers faces of the finest level by spheres, and takes that back.
///
/// - A face belongs to the sphere in which it lies deepest; 1/d = 0 there.
/// - A fluid face with a covered neighbour has a link of length theta = s0/(s0 - s1) in [0.05, 1].
/// - An orphan cell, all of whose faces are covered or solid, gives its flux to the nearest layer of
///   open cells (at most 4 cells away) in equal shares; the transpose presses on the sphere.
/// - A pocket of at most 4 cells a side that spheres cut off is closed: its faces join the nearest.
class SphereCover {
 public:
  SphereCover(Operator& op, Friction& friction, const Boundaries& boundaries);

  /// Collective.
  void place(const SphereSet& set);
  void lift();

  [[nodiscard]] const std::vector<SphereCut>& cuts() const { return cuts_; }
  [[nodiscard]] const CoverCount& count() const { return count_; }
  /// Cells that were open and are not any more, in memory order.
  [[nodiscard]] const std::vector<std::uint32_t>& covered_cells() const { return covered_; }
  [[nodiscard]] Int3 index_of(std::uint32_t at) const;

 private:
  struct OldFace {
    std::uint32_t at;
    std::uint8_t component;
    float inverse;
    float excess;
  };
  struct OldCell {
    std::uint32_t at;
    float push;
  };
  struct Window {
    Int3 first;
    Int3 last;
  };
  [[nodiscard]] Window window(const BallImage& image, Real radius, int margin) const;
  /// Open cells that hang together, and the open faces met.
  struct Flood {
    std::vector<std::uint32_t> cells;
    std::vector<std::pair<int, std::uint32_t>> faces;  ///< component, place
    bool closed = false;                               ///< a pocket
  };
  [[nodiscard]] Vec3 arm_of(int component, const Int3& index, const Vec3& centre) const;
  [[nodiscard]] float volume_of(int component, const Int3& index) const;
  [[nodiscard]] bool is_inside(const Int3& index) const;
  [[nodiscard]] bool was_open(std::uint32_t cell) const;
  [[nodiscard]] FaceArm face_arm(int component, const Int3& index, const Vec3& arm) const;
  [[nodiscard]] std::vector<std::uint32_t> changed_cells() const;
  [[nodiscard]] bool step_through(Int3& cell, int axis, int side) const;
  [[nodiscard]] Flood flood_from(std::uint32_t start) const;
  [[nodiscard]] int nearest_image(const SphereSet& set, int component, std::uint32_t face) const;
  [[nodiscard]] SphereCell cell_at(const Int3& index, const std::array<float, 6>& flux) const;
  [[nodiscard]] std::vector<SphereCell> fluxes_of(std::size_t ball) const;
  void cover(const SphereSet& set, int image);
  void close_pockets(const SphereSet& set);
  void take_face(int component, std::uint32_t at, int image);
  void list_faces(const SphereSet& set, int image);
  void link(const SphereSet& set, int image);
  void link_face(int component, const Int3& index, const Vec3& arm, int image, int ball,
                 Real radius);
  void find_pushes();
  void find_fluxes(const SphereSet& set);
  void share_orphan(std::uint32_t at, std::uint64_t id, const std::array<float, 6>& flux,
                    std::vector<CellShare>& out);
  void take_shares(const SphereSet& set, const std::vector<CellShare>& shares);

  Operator& op_;
  Level& level_;
  Friction& friction_;
  Boundaries boundaries_;
  Vec3 spacing_;
  /// Per face: image + 1 of the sphere that covers it, -1 with a link, 0 untouched.
  std::array<std::vector<std::int32_t>, 3> owner_;
  std::vector<OldFace> old_faces_;
  std::vector<OldCell> old_cells_;
  std::vector<std::uint32_t> covered_;
  std::vector<SphereCut> cuts_;
  std::vector<std::uint8_t> mark_;  ///< scratch of close_pockets
  CoverCount count_;
};

}  // namespace porefines::flow
