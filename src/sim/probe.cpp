// SPDX-License-Identifier: MPL-2.0
#include "sim/probe.hpp"

#include <algorithm>
#include <cmath>

#include "grid/block.hpp"

namespace porefines::sim {
namespace {

constexpr Real most_queries = 2e6;

/// Is there fluid at a point, relative to the sample's corner? Pixels are taken as they are.
class FluidAt {
 public:
  explicit FluidAt(const geom::Sample& sample) : sample_(sample) {
    if (sample.spec.kind != geom::Kind::image) {
      solid_ = geom::make_solid(sample, {}, sample.box.size, 1e-3 * sample.box.size.x);
    }
  }

  bool operator()(const Vec3& x) const {
    if (sample_.spec.kind != geom::Kind::image) {
      return geom::signed_distance(solid_, x) > 0;
    }
    const auto voxel = [&](int a) { return static_cast<int>(std::floor(x[a] / sample_.pixel)); };
    return geom::is_pore(sample_.voxels.view(), sample_.box.beyond, voxel(0), voxel(1), voxel(2));
  }

 private:
  const geom::Sample& sample_;
  geom::Solid solid_;
};

/// At most `wanted` indices of 0 .. n-1, evenly spread.
std::vector<int> spread(int n, int wanted) {
  std::vector<int> chosen;
  const int count = std::clamp(wanted, 1, n);
  for (int i = 0; i < count; ++i) {
    chosen.push_back(static_cast<int>((i + 0.5) * n / count));
  }
  return chosen;
}

/// Layers that were not looked at take the value of the nearest one that was.
void fill_gaps(std::vector<Real>& work, const std::vector<int>& seen) {
  const std::vector<Real> known = work;
  for (std::size_t layer = 0, at = 0; layer < work.size(); ++layer) {
    const auto here = static_cast<int>(layer);
    while (at + 1 < seen.size() && std::abs(seen[at + 1] - here) < std::abs(seen[at] - here)) {
      ++at;
    }
    work[layer] = known[seen[at]];
  }
}

/// No-slip walls of the box per volume of the sample [1/m].
Real wall_surface(const Domain& domain) {
  Real surface = 0;
  for (int face = 0; face < 6; ++face) {
    if (domain.boundaries.kind[face] == flow::FaceKind::wall) {
      surface += 1 / domain.sample_size[face / 2];
    }
  }
  return surface;
}

struct Counts {
  Index points = 0;
  Index fluid = 0;
  Index crossings = 0;
  Index lines = 0;
  Index active_lines = 0;
};

}  // namespace

Probe probe_grid(const geom::Sample& sample, const Domain& domain) {
  const FluidAt fluid_at(sample);
  const Int3& n = domain.cells;
  const Vec3 corner = domain.origin();
  const int edge = static_cast<int>(std::sqrt(most_queries / n[0]));
  const std::vector<int> rows = spread(n[1], edge);
  const std::vector<int> layers = spread(n[2], edge);
  Probe probe;
  for (int axis = 0; axis < 3; ++axis) {
    probe.work[axis].assign(static_cast<std::size_t>(n[axis]), 0);
  }
  Counts count;
  const auto inside = [&](int axis, int cell) {
    return axis != domain.axis || (cell >= domain.reservoir && cell < n[axis] - domain.reservoir);
  };
  for (const int k : layers) {
    for (const int j : rows) {
      bool before = true;
      bool line = false;
      for (int i = 0; i < n[0]; ++i) {
        const bool fluid =
            fluid_at(corner + Vec3{(i + 0.5) * domain.spacing.x, (j + 0.5) * domain.spacing.y,
                                   (k + 0.5) * domain.spacing.z});
        probe.work[0][i] += fluid;
        probe.work[1][j] += fluid;
        probe.work[2][k] += fluid;
        line = line || fluid;
        if ((i + 1) % grid::line_width == 0 || i + 1 == n[0]) {
          ++count.lines;
          count.active_lines += line;
          line = false;
        }
        if (inside(0, i) && inside(1, j) && inside(2, k)) {
          ++count.points;
          count.fluid += fluid;
          count.crossings += i > 0 && fluid != before;
        }
        before = fluid;
      }
    }
  }
  fill_gaps(probe.work[1], rows);
  fill_gaps(probe.work[2], layers);
  const auto points = static_cast<Real>(std::max<Index>(1, count.points));
  probe.porosity = static_cast<Real>(count.fluid) / points;
  probe.active_share = static_cast<Real>(count.active_lines) / static_cast<Real>(count.lines);
  probe.specific_surface = 2 * static_cast<Real>(count.crossings) / (points * domain.spacing.x) +
                           probe.porosity * wall_surface(domain);
  return probe;
}

}  // namespace porefines::sim
