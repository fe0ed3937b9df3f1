// SPDX-License-Identifier: MPL-2.0
#include "geom/pore_network.hpp"

#include <algorithm>
#include <type_traits>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "geom/pore_size.hpp"
#include "geom/rasterise.hpp"
#include "geom/thinning.hpp"

namespace porefines::geom {

namespace {

std::vector<Pore> pores_of(const VoxelSolid& solid, const Basins& basins, Real depth) {
  const Real pixel = solid.pixel;
  const bool flat = solid.n[2] == 1;
  const Real voxel = pixel * pixel * (flat ? depth : pixel);
  std::vector<Index> top(basins.voxels.size(), -1);
  for (Index v = 0; v < product(solid.n); ++v) {
    const std::int32_t label = basins.label[static_cast<std::size_t>(v)];
    if (label >= 0) {
      Index& best = top[static_cast<std::size_t>(label)];
      if (best < 0 ||
          solid.s[static_cast<std::size_t>(v)] > solid.s[static_cast<std::size_t>(best)]) {
        best = v;
      }
    }
  }
  std::vector<Pore> pores;
  for (std::size_t b = 0; b < top.size(); ++b) {
    const Int3 i = position(solid.n, top[b]);
    Vec3 centre = pixel * Vec3{i[0] + 0.5, i[1] + 0.5, i[2] + 0.5};
    centre.z = flat ? 0.5 * depth : centre.z;
    pores.push_back({centre, pixel * basins.peak[b], voxel * static_cast<Real>(basins.voxels[b])});
  }
  return pores;
}

/// [m] fine enough to tell the pores of a list apart; throats are measured on the list itself.
Real drawing_pixel(const Sample& sample, Real cell_size) {
  const Vec3 size = sample.box.size;
  const Real longest = std::max({size.x, size.y, size.z});
  return sample.spec.kind == Kind::cylinders && cell_size > 0
             ? std::min(cell_size, longest / 200)
             : std::clamp(cell_size, longest / 200, longest / 100);
}

template <class Item>
void share_items(std::vector<Item>& items, MPI_Comm communicator) {
  static_assert(std::is_trivially_copyable_v<Item>);
  auto count = static_cast<std::int64_t>(items.size());
  MPI_Bcast(&count, 1, MPI_INT64_T, 0, communicator);
  items.resize(static_cast<std::size_t>(count));
  broadcast_bytes(items.data(), items.size() * sizeof(Item), communicator);
}

}  // namespace

PoreNetwork find_network(const VoxelSolid& solid, const std::array<bool, 3>& periodic,
                         const ThroatFrame& frame) {
  const Basins basins = find_basins(solid, Phase::pore, periodic);
  const Real depth = frame.depth > 0 ? frame.depth : solid.pixel;
  PoreNetwork network;
  network.pores = pores_of(solid, basins, depth);
  network.throats = find_throats(solid, basins, periodic, frame);
  network.flat = solid.n[2] == 1;
  network.size = solid.pixel * Vec3{Real(solid.n[0]), Real(solid.n[1]), Real(solid.n[2])};
  network.size.z = network.flat ? depth : network.size.z;
  network.periodic = periodic;
  return network;
}

PoreNetwork find_network(const Sample& sample, Real cell_size) {
  const Spec& spec = sample.spec;
  const Vec3 size = sample.box.size;
  std::array<bool, 3> periodic{};
  for (std::size_t a = 0; a < 3; ++a) {
    periodic[a] = sample.box.beyond[a] == Beyond::periodic;
  }
  if (spec.kind == Kind::empty) {
    return {.pores = {}, .throats = {}, .size = size, .periodic = periodic};
  }
  const bool image = spec.kind == Kind::image;
  const Real pixel = image ? sample.pixel : drawing_pixel(sample, cell_size);
  const Voxels drawn = image ? Voxels{} : rasterise(sample, pixel);
  const Real sigma = !image || spec.smooth < 0 ? 1 : spec.smooth / spec.pixel_size;
  const VoxelSolid solid =
      whole_solid(image ? sample.voxels.view() : drawn.view(), pixel, sample.box.beyond, sigma);
  ThroatFrame frame{spec.flow_axis, size.z, {}, {}};
  for (int a = 0; a < 3; ++a) {  // particles do not leave through the sides
    frame.walls[static_cast<std::size_t>(a)] =
        !periodic[static_cast<std::size_t>(a)] && a != spec.flow_axis;
  }
  if (!image) {
    const Real band = pixel * *std::max_element(solid.s.begin(), solid.s.end());
    frame.distance = [exact = make_solid(sample, {}, size, std::max(band, pixel))](const Vec3& x) {
      return signed_distance(exact, x);
    };
  }
  PoreNetwork network = find_network(solid, periodic, frame);
  network.size = size;
  return network;
}

PoreNetwork share_network(PoreNetwork mine, MPI_Comm communicator) {
  share_items(mine.pores, communicator);
  share_items(mine.throats, communicator);
  broadcast_bytes(&mine.size, sizeof mine.size, communicator);
  broadcast_bytes(&mine.periodic, sizeof mine.periodic, communicator);
  broadcast_bytes(&mine.flat, sizeof mine.flat, communicator);
  return mine;
}

void write_throats(const std::string& path, const std::vector<Throat>& throats) {
  std::string text =
      "id,x_m,y_m,z_m,width_m,area_m2,across_x,across_y,across_z,normal_x,normal_y,normal_z,"
      "behind_m,ahead_m,pore_behind,pore_ahead\n";
  for (std::size_t id = 0; id < throats.size(); ++id) {
    const Throat& t = throats[id];
    text += fmt::format(
        "{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.5f},{:.9g},"
        "{:.9g},{},{}\n",
        id, t.centre.x, t.centre.y, t.centre.z, t.width, t.area, t.across.x, t.across.y, t.across.z,
        t.normal.x, t.normal.y, t.normal.z, t.behind, t.ahead, t.pore_behind, t.pore_ahead);
  }
  write_file(path, text);
}

void write_pores(const std::string& path, const std::vector<Pore>& pores) {
  std::string text = "id,x_m,y_m,z_m,radius_m,volume_m3\n";
  for (std::size_t id = 0; id < pores.size(); ++id) {
    const Pore& p = pores[id];
    text += fmt::format("{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", id, p.centre.x, p.centre.y,
                        p.centre.z, p.radius, p.volume);
  }
  write_file(path, text);
}

}  // namespace porefines::geom
