// SPDX-License-Identifier: MPL-2.0
#include "geom/metrics.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "geom/pore_size.hpp"

namespace porefines::geom {

void SizeDistribution::sort() {
  std::vector<std::size_t> order(size.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return size[a] < size[b]; });
  SizeDistribution sorted;
  for (const std::size_t i : order) {
    sorted.size.push_back(size[i]);
    sorted.weight.push_back(weight[i]);
  }
  *this = std::move(sorted);
}

Real SizeDistribution::mean() const {
  const Real total = std::accumulate(weight.begin(), weight.end(), Real{0});
  return total > 0 ? std::inner_product(size.begin(), size.end(), weight.begin(), Real{0}) / total
                   : std::numeric_limits<Real>::quiet_NaN();
}

Real SizeDistribution::quantile(Real share) const {
  const Real total = std::accumulate(weight.begin(), weight.end(), Real{0});
  Real below = 0;
  for (std::size_t i = 0; i < size.size(); ++i) {
    below += weight[i];
    if (below >= share * total) {
      return size[i];
    }
  }
  return size.empty() ? std::numeric_limits<Real>::quiet_NaN() : size.back();
}

namespace {

/// Histogram of the local thickness in steps of a tenth of a pixel.
SizeDistribution pore_sizes(const VoxelSolid& solid) {
  std::map<int, Index> count;
  for (const float t : local_thickness(solid)) {
    if (t > 0) {
      ++count[static_cast<int>(std::lround(10 * t))];
    }
  }
  SizeDistribution out;
  for (const auto& [tenths, voxels] : count) {
    out.size.push_back(0.1 * tenths * solid.pixel);
    out.weight.push_back(static_cast<Real>(voxels));
  }
  return out;
}

SizeDistribution grain_sizes(const VoxelSolid& solid, const std::array<bool, 3>& periodic) {
  const Merging merging{0.3F, 1.0F};  // grains are rough: only clear necks part them
  const Basins grains = find_basins(solid, Phase::grain, periodic, merging);
  SizeDistribution out;
  for (const Index voxels : grains.voxels) {
    const auto v = static_cast<Real>(voxels);
    out.size.push_back(solid.pixel * (solid.n[2] == 1 ? std::sqrt(4 * v / std::numbers::pi)
                                                      : std::cbrt(6 * v / std::numbers::pi)));
    out.weight.push_back(1);
  }
  out.sort();
  return out;
}

Real connected_share(const VoxelView& image, const std::array<bool, 3>& periodic, int axis) {
  const auto parts = find_components(image, Phase::pore, periodic, axis);
  Index sum = 0;
  for (const Component& part : parts.component) {
    sum += percolates(part, periodic[static_cast<std::size_t>(axis)]) ? part.voxels : 0;
  }
  return static_cast<Real>(sum) / static_cast<Real>(product(image.n));
}

}  // namespace

Metrics measure(const VoxelView& image, Real pixel, const Surroundings& beyond,
                const Question& question) {
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) {
    periodic[a] = beyond[a] == Beyond::periodic;
  }
  const auto count = static_cast<Real>(product(image.n));
  Metrics out;
  out.voxels = image.n;
  out.pixel = pixel;
  out.porosity = static_cast<Real>(std::count_if(image.pore, image.pore + product(image.n),
                                                 [](std::uint8_t p) { return p != 0; })) /
                 count;
  out.porosity_connected = connected_share(image, periodic, question.flow_axis);

  const VoxelSolid solid = whole_solid(image, pixel, beyond, question.smooth);
  out.smoothing = solid.report;
  Real smooth = 0;
  for (const float s : solid.s) {
    smooth += std::clamp<Real>(0.5 + s, 0, 1);
  }
  out.porosity_smooth = smooth / count;
  const Real depth = question.depth > 0 ? question.depth : pixel;
  const Real bulk = count * pixel * pixel * (image.n[2] == 1 ? depth : pixel);
  out.specific_surface = surface_area(solid, depth) / bulk;
  out.pores = pore_sizes(solid);
  out.grains = grain_sizes(solid, periodic);
  out.throats = find_throats(solid, find_basins(solid, Phase::pore, periodic), periodic,
                             {question.flow_axis, depth});
  const Real four = 4 * (question.cell_size > 0 ? question.cell_size : pixel);
  Real under = 0;
  for (const Throat& throat : out.throats) {
    out.throat_widths.size.push_back(throat.width);
    out.throat_widths.weight.push_back(1);
    under += throat.width < four ? 1 : 0;
  }
  out.throat_widths.sort();
  out.throats_under_4_cells =
      out.throats.empty() ? 0 : under / static_cast<Real>(out.throats.size());
  return out;
}

Json to_json(const Metrics& m, const Question& question) {
  Json json;
  json.set("voxels_x", m.voxels[0]);
  json.set("voxels_y", m.voxels[1]);
  json.set("voxels_z", m.voxels[2]);
  json.set("pixel_size_m", m.pixel);
  json.set("porosity", m.porosity);
  json.set("porosity_connected", m.porosity_connected);
  json.set("porosity_smooth", m.porosity_smooth);
  json.set("percolating_share", m.porosity > 0 ? m.porosity_connected / m.porosity : 0);
  json.set("specific_surface_per_m", m.specific_surface);
  json.set("pore_diameter_mean_m", m.pores.mean());
  json.set("pore_diameter_median_m", m.pores.quantile(0.5));
  json.set("pore_diameter_10_m", m.pores.quantile(0.1));
  json.set("pore_diameter_90_m", m.pores.quantile(0.9));
  json.set("throats", m.throats.size());
  json.set("throat_width_mean_m", m.throat_widths.mean());
  json.set("throat_width_median_m", m.throat_widths.quantile(0.5));
  json.set("throat_width_10_m", m.throat_widths.quantile(0.1));
  json.set("throat_width_90_m", m.throat_widths.quantile(0.9));
  json.set("throat_width_min_m", m.throat_widths.quantile(0));
  json.set("throats_under_4_cells_share", m.throats_under_4_cells);
  json.set("grains", m.grains.size.size());
  json.set("grain_diameter_mean_m", m.grains.mean());
  json.set("grain_diameter_median_m", m.grains.quantile(0.5));
  json.set("grain_diameter_10_m", m.grains.quantile(0.1));
  json.set("grain_diameter_90_m", m.grains.quantile(0.9));
  if (question.fine_diameter > 0) {
    const Real d = question.fine_diameter;
    json.set("fine_diameter_m", d);
    json.set("throat_to_fine_ratio_mean", m.throat_widths.mean() / d);
    json.set("throat_to_fine_ratio_median", m.throat_widths.quantile(0.5) / d);
    json.set("throat_to_fine_ratio_min", m.throat_widths.quantile(0) / d);
    json.set("grain_to_fine_ratio_mean", m.grains.mean() / d);
    json.set("grain_to_fine_ratio_median", m.grains.quantile(0.5) / d);
  }
  json.set("smoothing_flipped_pore_voxels", m.smoothing.flipped_pores);
  json.set("smoothing_flipped_grain_voxels", m.smoothing.flipped_grains);
  json.set("smoothing_rescued_voxels", m.smoothing.rescued);
  return json;
}

}  // namespace porefines::geom
