// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "flow/level.hpp"
#include "flow/links.hpp"

namespace porefines::flow {

class RigidSpheres;

/// Values of u, v, w, p on the active lines that a rank owns: 4 x 16 values per line, one after the
/// other. Krylov vectors are kept so: solid costs nothing and every pass is a stream.
template <typename T>
using Packed = AlignedVector<T>;

inline constexpr int packed_width = 4 * grid::line_width;

/// The Stokes operator of the finest level in double precision, and the map to packed vectors.
class Operator {
 public:
  Operator(Level& level, const Friction& friction);

  /// Numbers in a packed vector: of the fluid, then of the spheres that this rank owns.
  [[nodiscard]] std::size_t size() const { return fluid_size() + tail_; }
  [[nodiscard]] std::size_t fluid_size() const { return lines_.size() * packed_width; }

  /// Spheres take part from now on; nullptr: no more. After every placement.
  void attach(RigidSpheres* spheres);
  [[nodiscard]] RigidSpheres* spheres() const { return spheres_; }

  /// Place of an owned unknown in a packed vector; component 3 is pressure.
  [[nodiscard]] std::size_t position(int component, const Int3& index) const;

  /// out = K (u, p) for the level's u and p. Exchanges one ghost layer; collective.
  ///
  ///     momentum:    sum e (u - u_nb) + s u + W grad p      (s: wall friction, 0 in the bulk)
  ///     continuity:  div W u
  template <typename T>
  void apply(Packed<T>& out);

  /// r = b - K x, with x split into two floats so that nothing is lost. Overwrites u and p.
  void residual(const Packed<float>& b, const Packed<double>& x, Packed<float>& r);

  /// Right-hand side of the level = scale * v; zero elsewhere.
  template <typename T>
  void load_right_hand_side(const Packed<T>& v, double scale);
  /// The level's u and p = the packed values; zero elsewhere.
  template <typename T>
  void load_unknowns(const Packed<T>& v);
  /// Spheres' motions too, as load_unknowns loads them.
  template <typename T>
  void store_unknowns(Packed<T>& v) const;

  /// Calls visit(component 0..3, i, j, k, position in a packed vector) for every owned unknown that is
  /// active; component 3 is pressure.
  template <typename Visit>
  void for_each(const Visit& visit) const {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      for (int c = 0; c < 4; ++c) {
        visit_line(line, c, [&](int i, int j, int k, std::size_t at) { visit(c, i, j, k, at); });
      }
    }
  }

  /// The same for one component: visit(i, j, k, position).
  template <typename Visit>
  void for_each_of(int component, const Visit& visit) const {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      visit_line(line, component, visit);
    }
  }

  /// Calls visit(i, j, k, position) for every line: of its first cell, and of its first number.
  template <typename Visit>
  void for_each_line(const Visit& visit) const {
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      visit(lines_[line].i, lines_[line].j, lines_[line].k, line * packed_width);
    }
  }

  [[nodiscard]] Level& level() { return level_; }
  [[nodiscard]] const Level& level() const { return level_; }
  [[nodiscard]] const Friction& friction() const { return friction_; }

 private:
  struct Line {
    int i, j, k;
  };
  template <typename Visit>
  void visit_line(std::size_t line, int component, const Visit& visit) const {
    const Line& q = lines_[line];
    const std::ptrdiff_t at = level_.block.at(q.i, q.j, q.k);
    const float* active =
        (component < 3 ? level_.inverse_diagonal[component] : level_.push).data() + at;
    const auto owned = [&](int a) -> const float* {
      const auto& axis = level_.axis[a];
      return (a == component ? axis.owned_face : axis.owned_cell).data() + axis.offset;
    };
    const float row = owned(1)[q.j] * owned(2)[q.k];
    const float* owned_x = owned(0) + q.i;
    for (int l = 0; l < grid::line_width; ++l) {
      if (owned_x[l] * row * active[l] != 0) {
        visit(q.i + l, q.j, q.k, line * packed_width + component * grid::line_width + l);
      }
    }
  }
  /// fields = scale * v on the active lines.
  template <typename T>
  void scatter(const std::array<Floats*, 4>& fields, const Packed<T>& v, double scale);

  Level& level_;
  const Friction& friction_;
  std::vector<Line> lines_;
  std::vector<std::int32_t> line_at_;  ///< per 16 places in memory: index in lines_, or -1
  RigidSpheres* spheres_ = nullptr;
  std::size_t tail_ = 0;
};

}  // namespace porefines::flow
