// SPDX-License-Identifier: MPL-2.0
#include "flow/links.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "flow/smoother.hpp"

namespace porefines::flow {

bool exists(const grid::Block& block, const Boundaries& boundaries, int component, int axis,
            int local) {
  if (boundaries.periodic(axis)) {
    return true;
  }
  const int here = local + block.start[axis];
  const int total = block.global[axis];
  if (axis != component) {
    return here >= 0 && here < total;
  }
  const int first = boundaries.open(axis, false) ? 0 : 1;
  const int last = boundaries.open(axis, true) ? total : total - 1;
  return here >= first && here <= last;
}

namespace {

constexpr Real shortest_link = 0.02;  ///< cells

struct Link {
  Real excess;
  Real weight;
};

/// Walks the faces of one component, ghosts included, where the grid or its periodic images exist.
class Faces {
 public:
  Faces(const Level& level, const Boundaries& boundaries, int component)
      : level_(level), boundaries_(boundaries), component_(component) {
    for (int a = 0; a < 3; ++a) {
      spacing_[a] = level.widths[a].front();
    }
  }

  [[nodiscard]] bool exists(int axis, int local) const {
    return flow::exists(level_.block, boundaries_, component_, axis, local);
  }

  [[nodiscard]] Vec3 centre(int i, int j, int k) const {
    const Vec3 x = level_.block.centre(component_, {i, j, k});
    return {x.x * spacing_.x, x.y * spacing_.y, x.z * spacing_.z};
  }

  template <typename Visit>
  void for_each(const Visit& visit) const {
    const grid::Block& b = level_.block;
    for (int k = -b.ghost[2]; k <= b.n[2] + b.ghost[2]; ++k) {
      for (int j = -b.ghost[1]; j <= b.n[1] + b.ghost[1]; ++j) {
        if (!exists(1, j) || !exists(2, k)) {
          continue;
        }
        for (int i = -b.ghost[0]; i <= b.n[0] + b.ghost[0]; ++i) {
          if (exists(0, i)) {
            visit(i, j, k);
          }
        }
      }
    }
  }

  /// What the box walls parallel to this component do to a face: a half-cell link on every side with
  /// a no-slip wall (friction +e, weight as for a grain surface there), -e for slip and outflow.
  [[nodiscard]] Link box_link(int i, int j, int k) const {
    const Int3 index{i, j, k};
    Link link{0, 1};
    for (int a = 0; a < 3; ++a) {
      if (a == component_ || boundaries_.periodic(a)) {
        continue;
      }
      const int here = index[a] + level_.block.start[a];
      const auto& axis = level_.axis[a];
      Real reach = 1;  // mean link length across the wall
      const auto meet = [&](bool high, float e) {
        const FaceKind kind = boundaries_.at(a, high);
        link.excess += kind == FaceKind::slip || kind == FaceKind::outflow ? -e : e;
        reach -= kind == FaceKind::wall ? 0.25 : 0;
      };
      if (here == 0) {
        meet(false, axis.cell_low[index[a] + axis.offset]);
      }
      if (here == level_.block.global[a] - 1) {
        meet(true, axis.cell_high[index[a] + axis.offset]);
      }
      link.weight = std::min(link.weight, (1 + reach) / 2);
    }
    return link;
  }

  /// Off-diagonals of the row along an axis: {low, high}.
  [[nodiscard]] std::array<Real, 2> stencil(int axis, int local) const {
    const auto& c = level_.axis[axis];
    const std::size_t at = local + c.offset;
    return axis == component_ ? std::array<Real, 2>{c.face_low[at], c.face_high[at]}
                              : std::array<Real, 2>{c.cell_low[at], c.cell_high[at]};
  }

  [[nodiscard]] Real spacing(int axis) const { return spacing_[axis]; }

 private:
  const Level& level_;
  const Boundaries& boundaries_;
  int component_;
  Vec3 spacing_;
};

/// Distance to the wall in (0, 1] along a link, from s at its start, middle and end (s1 <= 0 < s0).
Real wall_fraction(Real s0, Real half, Real s1) {
  const Real c2 = 2 * (s1 + s0 - 2 * half);
  const Real c1 = s1 - s0 - c2;
  const Real discriminant = c1 * c1 - 4 * c2 * s0;
  Real theta = s0 / (s0 - s1);
  if (discriminant >= 0) {
    const Real root = 2 * s0 / (-c1 + std::sqrt(discriminant));
    theta = root > 0 && root <= 1 ? root : theta;
  }
  return std::max(theta, shortest_link);
}

/// Links of one face near a grain: wall friction and link weight.
Link link_face(const Faces& faces, const SignedDistance& s, const Int3& index, const Vec3& x,
               Real s0) {
  Link link{0, 1};
  Real normal_squared = 0;
  Real reach = 0;  // sum of n_t^2 c_t
  bool cut = false;
  for (int t = 0; t < 3; ++t) {
    Vec3 step;
    step[t] = faces.spacing(t);
    const auto e = faces.stencil(t, index[t]);
    std::array<Real, 2> half{};
    Real theta_sum = 0;
    for (int side = 0; side < 2; ++side) {
      const Vec3 towards = side == 0 ? Vec3{} - step : step;
      half[side] = s(x + 0.5 * towards);
      const Real s1 = s(x + towards);
      const bool wall = s1 <= 0 && e[side] != 0;
      const Real theta = wall ? wall_fraction(s0, half[side], s1) : 1;
      link.excess += e[side] * (1 / theta - 1);
      theta_sum += theta;
      cut = cut || wall;
    }
    const Real slope = (half[1] - half[0]) / faces.spacing(t);
    normal_squared += slope * slope;
    reach += slope * slope * theta_sum / 2;
  }
  if (cut && normal_squared > 0) {
    link.weight = (1 + reach / normal_squared) / 2;
  }
  return link;
}

void set_face(Level& level, Friction& friction, const Faces& faces, int c, const Int3& index,
              const Link& link) {
  const std::ptrdiff_t at = level.block.at(index[0], index[1], index[2]);
  Real diagonal = link.excess;
  for (int t = 0; t < 3; ++t) {
    const auto e = faces.stencil(t, index[t]);
    diagonal += e[0] + e[1];
  }
  friction.excess[c][at] = static_cast<float>(link.excess);
  level.inverse_diagonal[c][at] = diagonal > 0 ? static_cast<float>(1 / diagonal) : 0.0F;
  level.weight[c][at] = static_cast<float>(link.weight);
}

Friction no_flow(const Level& level) {
  Friction friction;
  for (Floats& field : friction.excess) {
    field.assign(level.block.size, Friction::inactive);
  }
  return friction;
}

}  // namespace

Friction link_to_surface(Level& finest, const Boundaries& boundaries,
                         const SignedDistance& distance) {
  Friction friction = no_flow(finest);
  for (int c = 0; c < 3; ++c) {
    const Faces faces(finest, boundaries, c);
    const Real far = 1.05 * std::max({faces.spacing(0), faces.spacing(1), faces.spacing(2)});
    faces.for_each([&](int i, int j, int k) {
      const Vec3 x = faces.centre(i, j, k);
      const Real s0 = distance(x);
      if (s0 <= 0) {
        return;
      }
      Link link{0, 1};
      if (s0 < far) {
        link = link_face(faces, distance, {i, j, k}, x, s0);
      }
      const Link box = faces.box_link(i, j, k);
      link = {link.excess + box.excess, std::min(link.weight, box.weight)};
      set_face(finest, friction, faces, c, {i, j, k}, link);
    });
  }
  return friction;
}

namespace {

/// 1 in pores, 0 in grains, for every cell that link_to_voxels looks at: two layers beyond the ghosts.
class PoreCells {
 public:
  PoreCells(const grid::Block& b, const IsPore& is_pore) {
    std::size_t count = 1;
    for (int a = 0; a < 3; ++a) {
      first_[a] = -b.ghost[a] - 2;
      n_[a] = b.n[a] + 2 * b.ghost[a] + 5;
      count *= static_cast<std::size_t>(n_[a]);
    }
    pore_.reserve(count);
    for (int k = 0; k < n_[2]; ++k) {
      for (int j = 0; j < n_[1]; ++j) {
        for (int i = 0; i < n_[0]; ++i) {
          pore_.push_back(is_pore(i + first_[0] + b.start[0], j + first_[1] + b.start[1],
                                  k + first_[2] + b.start[2])
                              ? 1
                              : 0);
        }
      }
    }
  }
  [[nodiscard]] std::size_t at(const Int3& cell) const {
    return static_cast<std::size_t>(cell[0] - first_[0]) +
           static_cast<std::size_t>(cell[1] - first_[1]) * stride(1) +
           static_cast<std::size_t>(cell[2] - first_[2]) * stride(2);
  }
  [[nodiscard]] std::size_t stride(int axis) const {
    const auto row = static_cast<std::size_t>(n_[0]);
    return axis == 0 ? 1 : axis == 1 ? row : row * static_cast<std::size_t>(n_[1]);
  }
  [[nodiscard]] int operator[](std::size_t at) const { return pore_[at]; }

 private:
  Int3 first_{};
  Int3 n_{};
  std::vector<std::uint8_t> pore_;
};

}  // namespace

Friction link_to_voxels(Level& finest, const Boundaries& boundaries, const IsPore& is_pore) {
  Friction friction = no_flow(finest);
  const PoreCells pore(finest.block, is_pore);
  for (int c = 0; c < 3; ++c) {
    const Faces faces(finest, boundaries, c);
    const std::size_t back = pore.stride(c);
    const auto pores = [&](std::size_t at) { return pore[at] + pore[at - back]; };
    faces.for_each([&](int i, int j, int k) {
      const std::size_t at = pore.at({i, j, k});
      if (pores(at) < 2) {
        return;
      }
      Link link{faces.box_link(i, j, k).excess, 1};
      for (int t = 0; t < 3; ++t) {
        if (t == c) {
          continue;  // a closed face one cell ahead: u = 0 at distance 1
        }
        const auto e = faces.stencil(t, Int3{i, j, k}[t]);
        for (int side = 0; side < 2; ++side) {
          const bool inside = faces.exists(t, Int3{i, j, k}[t] + (side == 0 ? -1 : 1));
          const std::size_t next = side == 0 ? at - pore.stride(t) : at + pore.stride(t);
          // Two grain cells: a wall half a cell away. One: half wall, half open.
          link.excess += inside ? e[side] * (2 - pores(next)) / 2 : 0;
        }
      }
      set_face(finest, friction, faces, c, {i, j, k}, link);
    });
  }
  return friction;
}

namespace {

int open_faces(const Level& level, const Int3& cell) {
  const std::ptrdiff_t at = level.block.at(cell[0], cell[1], cell[2]);
  int count = 0;
  for (int a = 0; a < 3; ++a) {
    count += level.inverse_diagonal[a][at] != 0 ? 1 : 0;
    count += level.inverse_diagonal[a][at + level.block.stride(a)] != 0 ? 1 : 0;
  }
  return count;
}

/// Closes the only open face of every owned cell that has just one; returns how many.
/// A dead end across a rank border is closed by the cell's owner on its side and by the neighbour
/// through its own copy of the cell, one layer into the ghosts.
Index close_single_faces(Level& level, const Boundaries& boundaries, Friction& friction) {
  const grid::Block& b = level.block;
  Index closed = 0;
  // Never beyond the box: there every opening would be the only face of the cell behind it.
  const auto first = [&](int a) {
    return b.ghost[a] > 1 && (boundaries.periodic(a) || b.start[a] > 0) ? -1 : 0;
  };
  const auto last = [&](int a) {
    const bool more = boundaries.periodic(a) || b.start[a] + b.n[a] < b.global[a];
    return b.n[a] + (b.ghost[a] > 1 && more ? 1 : 0);
  };
  for (int k = first(2); k < last(2); ++k) {
    for (int j = first(1); j < last(1); ++j) {
      for (int i = first(0); i < last(0); ++i) {
        if (open_faces(level, {i, j, k}) != 1) {
          continue;
        }
        const std::ptrdiff_t at = b.at(i, j, k);
        for (int a = 0; a < 3; ++a) {
          for (const std::ptrdiff_t face : {at, at + b.stride(a)}) {
            if (level.inverse_diagonal[a][face] != 0) {
              level.inverse_diagonal[a][face] = 0;
              friction.excess[a][face] = Friction::inactive;
              ++closed;
            }
          }
        }
      }
    }
  }
  return closed;
}

}  // namespace

Index prune_dead_ends(const par::Communicator& comm, Level& finest, const Boundaries& boundaries,
                      Friction& friction) {
  const std::array<float*, 3> fields{finest.inverse_diagonal[0].data(),
                                     finest.inverse_diagonal[1].data(),
                                     finest.inverse_diagonal[2].data()};
  Index total = 0;
  while (true) {
    finest.halo.exchange(fields, sweep_depth);
    const Index closed = comm.sum(close_single_faces(finest, boundaries, friction));
    if (closed == 0) {
      return total;
    }
    total += closed;
  }
}

}  // namespace porefines::flow
