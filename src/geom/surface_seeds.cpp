// SPDX-License-Identifier: MPL-2.0
#include "geom/surface_seeds.hpp"

#include <algorithm>
#include <numbers>

#include "geom/blur.hpp"
#include "geom/simple_point.hpp"

namespace porefines::geom {

namespace {

constexpr float near_surface = 1.3F;   // [pixels] |raw| up to which planes are fitted
constexpr float seed_distance = 1.0F;  // [pixels] |s| up to which a plane is a seed
constexpr float least_slope = 0.35F;  // below this |grad raw| a voxel lies midway in a thin feature
constexpr float rescued_value = 0.75F;

/// Values of a field over a window, x fastest.
struct Grid3 {
  Window window;
  Int3 n;
  std::array<Index, 3> stride;
  explicit Grid3(const Window& w) : window(w), n(w.size()), stride{1, n[0], Index{n[0]} * n[1]} {}
  [[nodiscard]] Index at(int i, int j, int k) const {
    return (i - window.first[0]) + stride[1] * (j - window.first[1]) +
           stride[2] * (k - window.first[2]);
  }
};

std::vector<std::uint8_t> copy_indicator(const VoxelView& image, const Surroundings& beyond,
                                         const Window& window) {
  const Int3 n = window.size();
  std::vector<std::uint8_t> out(static_cast<std::size_t>(product(n)), full_share);
  std::vector<int> column(static_cast<std::size_t>(n[0]));
  for (int i = 0; i < n[0]; ++i) {
    column[static_cast<std::size_t>(i)] = fold(i + window.first[0], image.n[0], beyond[0]);
  }
  auto* row = out.data();
  for (int k = window.first[2]; k < window.past[2]; ++k) {
    const int c = image.n[2] == 1 ? 0 : fold(k, image.n[2], beyond[2]);
    for (int j = window.first[1]; j < window.past[1]; ++j, row += n[0]) {
      const int b = fold(j, image.n[1], beyond[1]);
      if (b < 0 || c < 0) {
        continue;
      }
      const Index from = voxel_index(image.n, 0, b, c);
      for (int i = 0; i < n[0]; ++i) {
        const int a = column[static_cast<std::size_t>(i)];
        if (a < 0) {
          continue;
        }
        row[i] = image.share != nullptr      ? image.share[from + a]
                 : image.pore[from + a] != 0 ? full_share
                                             : std::uint8_t{0};
      }
    }
  }
  return out;
}

/// sigma sqrt(2) erfinv(2 phi - 1) for phi = 0..blur_one, within +-3.2 sigma.
std::vector<float> inverse_blur(Real sigma) {
  constexpr Real furthest = 3.2;
  std::vector<float> table(blur_one + 1);
  for (int i = 0; i <= blur_one / 2; ++i) {
    const Real target = static_cast<Real>(i) / blur_one;
    Real low = -furthest;
    Real high = 0;
    for (int step = 0; step < 30; ++step) {
      const Real middle = 0.5 * (low + high);
      (0.5 * std::erfc(-middle / std::numbers::sqrt2) < target ? low : high) = middle;
    }
    table[static_cast<std::size_t>(i)] = static_cast<float>(sigma * high);
    table[static_cast<std::size_t>(blur_one - i)] = static_cast<float>(-sigma * high);
  }
  table[blur_one / 2] = 0;
  return table;
}

/// A flip would change the topology, or leave no like voxel around.
bool must_keep(const Neighbourhood& around, const Neighbourhood& flipped, bool flat) {
  if (!is_simple(around, flat)) {
    return true;
  }
  const int first = flat ? 9 : 0;
  const int past = flat ? 18 : 27;
  for (int v = first; v < past; ++v) {
    const auto u = static_cast<std::size_t>(v);
    if (v != 13 && around[u] == around[13] && flipped[u] == 0) {
      return false;
    }
  }
  return true;
}

/// The pore shares and their blurred, inverted image raw on a smaller window.
struct Blurred {
  const std::vector<std::uint8_t>& share;
  const Grid3& pore_grid;
  std::vector<float>& raw;
  const Grid3& grid;
  bool flat;

  [[nodiscard]] bool is_pore(Index u) const {
    return 2 * share[static_cast<std::size_t>(u)] >= full_share;
  }
  [[nodiscard]] bool is_flipped(Index v, bool was_pore) const {
    return (raw[static_cast<std::size_t>(v)] > 0) != was_pore;
  }

  /// Voxel u of the binary volume is voxel v of raw: flipped, but not allowed to.
  [[nodiscard]] bool needs_rescue(Index u, Index v) const {
    if (!is_flipped(v, is_pore(u))) {
      return false;
    }
    Neighbourhood around{};
    Neighbourhood flipped{};
    for (int a = flat ? 9 : 0; a < (flat ? 18 : 27); ++a) {
      const int dx = a % 3 - 1;
      const int dy = a / 3 % 3 - 1;
      const int dz = a / 9 - 1;
      const Index at = u + dx + dy * pore_grid.stride[1] + dz * pore_grid.stride[2];
      const bool was_pore = is_pore(at);
      const Index there = v + dx + dy * grid.stride[1] + dz * grid.stride[2];
      around[static_cast<std::size_t>(a)] = was_pore ? 1 : 0;
      flipped[static_cast<std::size_t>(a)] = is_flipped(there, was_pore) ? 1 : 0;
    }
    return must_keep(around, flipped, flat);
  }
};

/// Give back their sign to voxels whose flip would close a throat or erase a grain.
Index rescue(const Window& where, const Window& count_in, const Blurred& blurred) {
  std::vector<std::pair<Index, float>> kept;  // applied at the end: the order must not matter
  Index counted = 0;
  for (int k = where.first[2]; k < where.past[2]; ++k) {
    for (int j = where.first[1]; j < where.past[1]; ++j) {
      Index v = blurred.grid.at(where.first[0], j, k);
      Index u = blurred.pore_grid.at(where.first[0], j, k);
      for (int i = where.first[0]; i < where.past[0]; ++i, ++v, ++u) {
        if (blurred.needs_rescue(u, v)) {
          kept.emplace_back(v, blurred.is_pore(u) ? rescued_value : -rescued_value);
          counted += count_in.holds(i, j, k) ? 1 : 0;
        }
      }
    }
  }
  for (const auto& [v, value] : kept) {
    blurred.raw[static_cast<std::size_t>(v)] = value;
  }
  return counted;
}

/// Plane through the surface near one voxel: s = raw/|g| - sigma^2/2 div(g/|g|), n = g/|g|.
bool fit_plane(const float* r, const std::array<Index, 3>& stride, bool flat, float sigma,
               Seed& seed) {
  const Index x = stride[0];
  const Index y = stride[1];
  const Index z = flat ? 0 : stride[2];
  const float gx = 0.5F * (r[x] - r[-x]);
  const float gy = 0.5F * (r[y] - r[-y]);
  const float gz = 0.5F * (r[z] - r[-z]);
  const float g2 = gx * gx + gy * gy + gz * gz;
  if (g2 < least_slope * least_slope) {
    return false;
  }
  const float slope = 1 / std::sqrt(g2);
  const float nx = gx * slope;
  const float ny = gy * slope;
  const float nz = gz * slope;
  const float xx = r[x] - 2 * r[0] + r[-x];
  const float yy = r[y] - 2 * r[0] + r[-y];
  const float zz = r[z] - 2 * r[0] + r[-z];
  const float xy = 0.25F * (r[x + y] - r[x - y] - r[-x + y] + r[-x - y]);
  float along = nx * nx * xx + ny * ny * yy + 2 * nx * ny * xy;
  float sum = xx + yy;
  if (!flat) {
    const float xz = 0.25F * (r[x + z] - r[x - z] - r[-x + z] + r[-x - z]);
    const float yz = 0.25F * (r[y + z] - r[y - z] - r[-y + z] + r[-y - z]);
    along += nz * nz * zz + 2 * (nx * nz * xz + ny * nz * yz);
    sum += zz;
  }
  const float most = 0.8F / sigma;
  const float curvature = std::clamp((sum - along) * slope, -most, most);
  seed = {r[0] * slope - 0.5F * sigma * sigma * curvature, {nx, ny, nz}};
  return true;
}

}  // namespace

Window grown(const Window& window, int by, bool flat) {
  Window out = window;
  for (int axis = 0; axis < (flat ? 2 : 3); ++axis) {
    out.first[axis] -= by;
    out.past[axis] += by;
  }
  return out;
}

SurfaceSeeds find_surface(const VoxelView& image, const Surroundings& beyond, const Window& window,
                          const Window& count_in, Real sigma) {
  const bool flat = image.n[2] == 1;
  const auto weights = gaussian_weights(sigma);
  const Grid3 grid(grown(window, 2, flat));
  const Grid3 pore_grid(grown(grid.window, static_cast<int>(weights.size()) / 2, flat));
  const auto pore = copy_indicator(image, beyond, pore_grid.window);

  std::vector<float> raw(static_cast<std::size_t>(product(grid.n)));
  {
    Int3 n = pore_grid.n;
    const auto phi = blur(pore, n, weights);
    const auto table = inverse_blur(sigma);
    std::transform(phi.begin(), phi.end(), raw.begin(), [&](auto p) { return table[p]; });
  }
  SurfaceSeeds out;
  out.window = window;
  out.rescued = rescue(grown(window, 1, flat), count_in, {pore, pore_grid, raw, grid, flat});

  const auto count = static_cast<std::size_t>(product(window.size()));
  out.index.assign(count, -1);
  out.mark.assign(count, 0);
  out.side.resize(count);
  std::size_t v = 0;
  for (int k = window.first[2]; k < window.past[2]; ++k) {
    for (int j = window.first[1]; j < window.past[1]; ++j) {
      const float* r = &raw[static_cast<std::size_t>(grid.at(window.first[0], j, k))];
      for (int i = window.first[0]; i < window.past[0]; ++i, ++r, ++v) {
        out.side[v] = *r > 0 ? 1 : -1;
        Seed seed{};
        const bool fits = std::abs(*r) <= near_surface &&
                          fit_plane(r, grid.stride, flat, static_cast<float>(sigma), seed);
        const bool rescued = std::abs(*r) == rescued_value;
        if (rescued && !fits) {
          seed = {std::copysign(0.5F, *r), {0, 0, 0}};
        }
        if ((fits || rescued) && std::abs(seed.s) <= seed_distance) {
          out.index[v] = static_cast<std::int32_t>(out.seed.size());
          out.mark[v] = 1;
          out.seed.push_back(seed);
        }
      }
    }
  }
  return out;
}

}  // namespace porefines::geom
