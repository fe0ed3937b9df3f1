// SPDX-License-Identifier: MPL-2.0
// Spheres against grains: queries per second for free spheres, spheres near a grain and touching ones.
//   porefines_bench --benchmark_filter=touches
#include <random>

#include <benchmark/benchmark.h>

#include "dem/surface.hpp"

namespace porefines::bench {
namespace {

constexpr int size = 128;    // voxels along the box
constexpr Real radius = 4;   // of the spheres
constexpr Real largest = 5;  // radius + reach

/// Overlapping balls, about half of the volume, as a picture.
const geom::VoxelSolid& rubble() {
  static const geom::VoxelSolid solid = [] {
    std::mt19937 random(2);
    std::uniform_real_distribution<Real> uniform(0, 1);
    geom::Voxels voxels = geom::make_voxels({size, size, size}, 1);
    for (int ball = 0; ball < 30; ++ball) {
      const Vec3 c = size * Vec3{uniform(random), uniform(random), uniform(random)};
      const Real r = 15 + 6 * uniform(random);
      for (int k = 0; k < size; ++k) {
        for (int j = 0; j < size; ++j) {
          for (int i = 0; i < size; ++i) {
            if (norm(Vec3{i + 0.5, j + 0.5, k + 0.5} - c) < r) {
              voxels.at(i, j, k) = 0;
            }
          }
        }
      }
    }
    constexpr geom::Surroundings mirrored{geom::Beyond::mirror, geom::Beyond::mirror,
                                          geom::Beyond::mirror};
    constexpr int by = 12;
    return geom::smooth_solid(voxels.view(), 1, mirrored,
                              {{-by, -by, -by}, {size + by, size + by, size + by}}, {1, 12});
  }();
  return solid;
}

const dem::Surface& field() {
  static const dem::Surface surface = dem::Fixed(dem::make_field(rubble(), largest));
  return surface;
}

const dem::Surface& mesh() {
  static const dem::Surface surface = [] {
    geom::VoxelSolid whole = rubble();
    whole.window = {{0, 0, 0}, whole.n};
    const Int3 n = rubble().window.size();
    whole.s.clear();
    for (int k = 0; k < size; ++k) {
      for (int j = 0; j < size; ++j) {
        for (int i = 0; i < size; ++i) {
          whole.s.push_back(
              rubble().s[static_cast<std::size_t>(geom::voxel_index(n, i + 12, j + 12, k + 12))]);
        }
      }
    }
    return dem::Surface(dem::Fixed(dem::make_mesh(geom::grain_surface(whole), largest)));
  }();
  return surface;
}

/// 500 centres whose distance from the grains lies between low and high radii.
std::vector<Vec3> centres(Real low, Real high) {
  std::mt19937 random(3);
  std::uniform_real_distribution<Real> uniform(10, size - 10.0);
  std::vector<Vec3> out;
  while (out.size() < 500) {
    const Vec3 x{uniform(random), uniform(random), uniform(random)};
    const Real s = geom::signed_distance(rubble(), x) / radius;
    if (s > low && s < high) {
      out.push_back(x);
    }
  }
  return out;
}

void touches(benchmark::State& state, const dem::Surface& (*surface)(), Real low, Real high) {
  const auto places = centres(low, high);
  const dem::Surface& grains = surface();
  Index found = 0;
  Index queries = 0;
  dem::TouchList list;
  for (auto _ : state) {
    for (const Vec3& x : places) {
      list.clear();
      dem::find_touches(grains, x, radius, 0, list);
      found += list.count;
    }
    queries += static_cast<Index>(places.size());
  }
  state.SetItemsProcessed(queries);
  state.counters["touches"] = static_cast<double>(found) / static_cast<double>(queries);
}

BENCHMARK_CAPTURE(touches, field_free, field, 2.4, 9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(touches, field_near, field, 1.05, 1.4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(touches, field_touching, field, 0.9, 0.97)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(touches, mesh_free, mesh, 2.4, 9)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(touches, mesh_near, mesh, 1.05, 1.4)->Unit(benchmark::kMicrosecond);
BENCHMARK_CAPTURE(touches, mesh_touching, mesh, 0.9, 0.97)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace porefines::bench
