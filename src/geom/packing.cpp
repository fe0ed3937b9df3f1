// SPDX-License-Identifier: MPL-2.0
#include "geom/packing.hpp"

#include <algorithm>
#include <numbers>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "geom/random.hpp"

namespace porefines::geom {

namespace {

Real volume_of(Real r, int dims) {
  return dims == 2 ? std::numbers::pi * r * r : 4.0 / 3 * std::numbers::pi * r * r * r;
}

std::vector<Body> draw_bodies(const PackSpec& spec, Random& random) {
  Real wanted = 1 - spec.porosity;
  for (int axis = 0; axis < spec.dims; ++axis) {
    wanted *= spec.size[axis];
  }
  std::vector<Body> bodies;
  Real sum = 0;
  while (sum < wanted) {
    Real d = spec.diameter;
    if (spec.spread > 0) {
      d = std::clamp(random.lognormal(spec.diameter, spec.spread), d / 4, d * 4);
    }
    bodies.push_back({{}, d / 2});
    sum += volume_of(d / 2, spec.dims);
  }
  const Real last = volume_of(bodies.back().radius, spec.dims);
  if (bodies.size() > 1 && sum - wanted > 0.5 * last) {
    bodies.pop_back();
    sum -= last;
  }
  const Real scale = std::pow(wanted / sum, 1.0 / spec.dims);
  for (Body& body : bodies) {
    body.radius *= scale;
    for (int axis = 0; axis < spec.dims; ++axis) {
      const Real wall = spec.periodic ? 0 : body.radius;
      body.centre[axis] = random.uniform(wall, std::max(spec.size[axis] - wall, wall));
    }
  }
  return bodies;
}

/// Cells at least as wide as the largest reach, at least three per axis where periodic.
class CellGrid {
 public:
  CellGrid(const PackSpec& spec, Real reach) : spec_(spec) {
    for (int axis = 0; axis < spec.dims; ++axis) {
      n_[static_cast<std::size_t>(axis)] = std::max(static_cast<int>(spec.size[axis] / reach), 1);
    }
  }

  void fill(const std::vector<Body>& bodies) {
    head_.assign(static_cast<std::size_t>(product(n_)), -1);
    next_.resize(bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      std::int32_t& head = head_[place(cell_of(bodies[b].centre))];
      next_[b] = head;
      head = static_cast<std::int32_t>(b);
    }
  }

  /// Every body in the cells around x, once.
  template <class Visit>
  void visit(const Vec3& x, const Visit& visitor) const {
    const Int3 c = cell_of(x);
    std::array<std::array<int, 3>, 3> range{};
    std::array<std::size_t, 3> count{};
    for (std::size_t a = 0; a < 3; ++a) {
      for (int d = -1; d <= 1; ++d) {
        const int i = c[a] + d;
        const int wrapped = spec_.periodic ? (i + n_[a]) % n_[a] : i;
        const auto end = range[a].begin() + static_cast<std::ptrdiff_t>(count[a]);
        if (wrapped >= 0 && wrapped < n_[a] && std::find(range[a].begin(), end, wrapped) == end) {
          range[a][count[a]++] = wrapped;
        }
      }
    }
    for (std::size_t k = 0; k < count[2]; ++k) {
      for (std::size_t j = 0; j < count[1]; ++j) {
        for (std::size_t i = 0; i < count[0]; ++i) {
          for (std::int32_t b = head_[place({range[0][i], range[1][j], range[2][k]})]; b >= 0;
               b = next_[static_cast<std::size_t>(b)]) {
            visitor(static_cast<std::size_t>(b));
          }
        }
      }
    }
  }

 private:
  [[nodiscard]] Int3 cell_of(const Vec3& x) const {
    Int3 c{0, 0, 0};
    for (int axis = 0; axis < spec_.dims; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      c[a] = std::clamp(static_cast<int>(x[axis] / spec_.size[axis] * n_[a]), 0, n_[a] - 1);
    }
    return c;
  }
  [[nodiscard]] std::size_t place(const Int3& c) const {
    return static_cast<std::size_t>(voxel_index(n_, c[0], c[1], c[2]));
  }

  const PackSpec& spec_;
  Int3 n_{1, 1, 1};
  std::vector<std::int32_t> head_;
  std::vector<std::int32_t> next_;
};

/// One round of pushing apart. @return the largest missing distance
Real push_apart(const PackSpec& spec, CellGrid& grid, std::vector<Body>& bodies, Real margin) {
  grid.fill(bodies);
  std::vector<Vec3> move(bodies.size());
  Real worst = 0;
  for (std::size_t a = 0; a < bodies.size(); ++a) {
    grid.visit(bodies[a].centre, [&](std::size_t b) {
      if (b <= a) {
        return;
      }
      Vec3 d = bodies[b].centre - bodies[a].centre;
      for (int axis = 0; spec.periodic && axis < spec.dims; ++axis) {
        d[axis] -= spec.size[axis] * std::round(d[axis] / spec.size[axis]);
      }
      const Real apart = norm(d);
      const Real wanted = bodies[a].radius + bodies[b].radius + spec.gap;
      if (apart >= wanted) {
        return;
      }
      worst = std::max(worst, wanted - apart);
      const Vec3 n = apart > 0 ? d / apart : Vec3{1, 0, 0};
      const Vec3 push = 0.5 * (wanted + margin - apart) * n;
      move[a] -= push;
      move[b] += push;
    });
  }
  for (std::size_t b = 0; b < bodies.size(); ++b) {
    bodies[b].centre += move[b];
    for (int axis = 0; axis < spec.dims; ++axis) {
      Real& x = bodies[b].centre[axis];
      const Real r = bodies[b].radius;
      x = spec.periodic ? fold(x, spec.size[axis], Beyond::periodic)
                        : std::clamp(x, r, std::max(spec.size[axis] - r, r));
    }
  }
  return worst;
}

}  // namespace

std::vector<Body> make_packing(const PackSpec& spec) {
  if (!(spec.porosity > 0 && spec.porosity < 1 && spec.diameter > 0 && spec.gap >= 0)) {
    throw InputError(fmt::format(
        "a packing needs a porosity within 0..1 and a positive diameter; got {:.3g} and {:.3g} m.",
        spec.porosity, spec.diameter));
  }
  Random random(spec.seed);
  std::vector<Body> bodies = draw_bodies(spec, random);
  Real largest = spec.diameter;
  for (const Body& body : bodies) {
    largest = std::max(largest, 2 * body.radius);
  }
  for (int axis = 0; axis < spec.dims; ++axis) {
    if (largest + spec.gap > spec.size[axis]) {
      throw InputError(fmt::format("grains of {:.3g} m do not fit into a box of {:.3g} m along {}.",
                                   largest, spec.size[axis], "xyz"[axis]));
    }
  }
  const Real accurate = 1e-6 * spec.diameter;
  CellGrid grid(spec, largest + spec.gap);
  constexpr int rounds = 2500;
  for (int round = 0; round < rounds; ++round) {
    if (push_apart(spec, grid, bodies, 1e-3 * spec.diameter) <= accurate) {
      return bodies;
    }
  }
  throw InputError(fmt::format(
      "{} grains of porosity {:.3g} with gaps of {:.3g} m could not be packed.\nTry a larger "
      "porosity, a smaller gap, or a wider spread of sizes.",
      bodies.size(), spec.porosity, spec.gap));
}

void write_bodies(const std::string& path, const std::vector<Body>& bodies, const PackSpec& spec) {
  std::string text = fmt::format(
      "# porefines packing: {} {}, porosity {:.6g}, box {:.9g} {:.9g} {:.9g} m, seed {}\n# {}\n",
      bodies.size(), spec.dims == 2 ? "cylinders" : "spheres", spec.porosity, spec.size.x,
      spec.size.y, spec.size.z, spec.seed, spec.dims == 2 ? "x y r [m]" : "x y z r [m]");
  for (const Body& body : bodies) {
    text += spec.dims == 2
                ? fmt::format("{:.9g} {:.9g} {:.9g}\n", body.centre.x, body.centre.y, body.radius)
                : fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", body.centre.x, body.centre.y,
                              body.centre.z, body.radius);
  }
  write_file(path, text);
}

}  // namespace porefines::geom
