// SPDX-License-Identifier: MPL-2.0
#include "page/geometry.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "geom/build.hpp"
#include "geom/metrics.hpp"
#include "geom/pore_size.hpp"
#include "geom/rasterise.hpp"
#include "geom/stl.hpp"
#include "page/pack.hpp"
#include "sim/domain.hpp"

namespace porefines::page {
namespace {

constexpr Index most_voxels = 30'000'000;
constexpr Real list_voxels = 3e5;  ///< of a list that is drawn into voxels
constexpr int bins = 30;
constexpr int field_points = 64;  ///< along the longest edge of a volume

/// Shares of equal bins from 0 to the 99.5 % quantile; what lies beyond counts in the last one.
std::string histogram(const geom::SizeDistribution& sizes) {
  const Real right = sizes.quantile(0.995);
  std::vector<Real> edges;
  std::vector<Real> share(bins, 0);
  Real total = 0;
  for (int bin = 0; bin <= bins; ++bin) {
    edges.push_back(right * bin / bins);
  }
  for (std::size_t k = 0; k < sizes.size.size(); ++k) {
    const Real place = right > 0 ? sizes.size[k] / right * bins : 0;
    share[static_cast<std::size_t>(std::clamp(place, 0.0, bins - 1.0))] += sizes.weight[k];
    total += sizes.weight[k];
  }
  for (Real& value : share) {
    value /= total;
  }
  Json json;
  json.set_json("edges_m", json_numbers(edges));
  json.set_json("share", json_numbers(share));
  json.set("median_m", sizes.quantile(0.5));
  json.set("count", sizes.size.size());
  return json.text();
}

std::string histograms(const geom::Metrics& metrics) {
  Json json;
  for (const auto& [name, sizes] :
       {std::pair{"pores", &metrics.pores}, std::pair{"throats", &metrics.throat_widths},
        std::pair{"grains", &metrics.grains}}) {
    if (!sizes->empty()) {
      json.set_json(name, histogram(*sizes));
    }
  }
  return json.text();
}

/// Corners as 16-bit numbers over the box, x and y in turn.
std::string outlines_json(const geom::VoxelSolid& solid, const Vec3& size) {
  std::vector<Real> counts;
  std::vector<std::uint16_t> corners;
  for (const auto& outline : geom::simplify(geom::grain_outlines(solid), 0.5 * solid.pixel)) {
    counts.push_back(static_cast<Real>(outline.size()));
    for (const geom::Point2& point : outline) {
      corners.push_back(Range16{0, size.x}.code(point[0]));
      corners.push_back(Range16{0, size.y}.code(point[1]));
    }
  }
  Json json;
  json.set_json("counts", json_numbers(counts));
  json.set_json("corners", pack_numbers(corners));
  return json.text();
}

/// Share of grain [0..255] in equal blocks of voxels, x fastest.
std::string field_json(const geom::VoxelView& image) {
  const int longest = std::max({image.n[0], image.n[1], image.n[2]});
  Int3 n{};
  for (std::size_t a = 0; a < 3; ++a) {
    n[a] = std::max(1, image.n[a] * std::min(field_points, longest) / longest);
  }
  std::vector<std::array<Index, 2>> counts(static_cast<std::size_t>(product(n)));
  for (int k = 0; k < image.n[2]; ++k) {
    for (int j = 0; j < image.n[1]; ++j) {
      for (int i = 0; i < image.n[0]; ++i) {
        const Index at = geom::voxel_index(n, static_cast<int>(Index{i} * n[0] / image.n[0]),
                                           static_cast<int>(Index{j} * n[1] / image.n[1]),
                                           static_cast<int>(Index{k} * n[2] / image.n[2]));
        auto& [grain, all] = counts[static_cast<std::size_t>(at)];
        grain += image.at(i, j, k) ? 0 : 1;
        ++all;
      }
    }
  }
  std::string bytes;
  for (const auto& [grain, all] : counts) {
    bytes += static_cast<char>(255 * grain / std::max<Index>(all, 1));
  }
  Json json;
  json.set_json("n", fmt::format("[{},{},{}]", n[0], n[1], n[2]));
  json.set("values", pack_bytes(bytes));
  return json.text();
}

std::string scene_json(const geom::VoxelView& image, const geom::Sample& sample,
                       const geom::VoxelSolid* solid) {
  const Vec3 size = sample.box.size;
  Json json;
  json.set_json("size_m", json_numbers(std::array{size.x, size.y, size.z}));
  if (solid != nullptr) {
    json.set_json("outlines", outlines_json(*solid, size));
  } else if (image.n[2] > 1) {
    json.set_json("field", field_json(image));
  }
  return json.text();
}

/// Voxels to measure; an image has them, a list is drawn.
std::pair<geom::SharedVoxels, Real> voxels_of(const geom::Sample& sample) {
  if (sample.spec.kind == geom::Kind::image) {
    return {sample.voxels, sample.pixel};
  }
  const Real pixel = geom::pixel_for(sample, list_voxels);
  return {geom::share(geom::rasterise(sample, pixel), MPI_COMM_SELF), pixel};
}

GeometryData measure_sample(const config::Case& the_case, const geom::Sample& sample) {
  const auto [voxels, pixel] = voxels_of(sample);
  const geom::VoxelView image = voxels.view();
  if (product(image.n) > most_voxels) {
    return {.missing =
                fmt::format("The image has {} million voxels: `porefines inspect` measures it.",
                            product(image.n) / 1'000'000)};
  }
  const geom::Spec& spec = sample.spec;
  geom::Question question{.fine_diameter = the_case.analysis.fine_diameter,
                          .cell_size = the_case.grid.cell_size,
                          .depth = sample.box.size.z,
                          .flow_axis = spec.flow_axis};
  if (spec.kind == geom::Kind::image && spec.smooth >= 0) {
    question.smooth = spec.smooth / spec.pixel_size;
  }
  const geom::Metrics metrics = geom::measure(image, pixel, spec.beyond, question);
  GeometryData out;
  out.metrics = geom::to_json(metrics, question).text();
  out.histograms = histograms(metrics);
  if (image.n[2] == 1) {
    const geom::VoxelSolid solid = geom::whole_solid(image, pixel, spec.beyond, question.smooth);
    out.scene = scene_json(image, sample, &solid);
  } else {
    out.scene = scene_json(image, sample, nullptr);
  }
  return out;
}

}  // namespace

GeometryData describe_geometry(const config::Case& the_case) {
  try {
    const geom::Sample sample = geom::build_sample(sim::geometry_spec(the_case), MPI_COMM_SELF);
    if (sample.spec.kind == geom::Kind::empty) {
      return {.scene = scene_json({}, sample, nullptr),
              .missing = "There are no grains in this run: an empty box."};
    }
    return measure_sample(the_case, sample);
  } catch (const InputError& error) {
    return {.missing = fmt::format("The grains could not be read again: {}", error.what())};
  }
}

}  // namespace porefines::page
