// SPDX-License-Identifier: MPL-2.0
#include "sim/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include "io/agree.hpp"

namespace porefines::sim {
namespace {

/// Axes to the right and up, as in a drawing in three views; see report::draw_three_slices.
std::array<int, 2> axes_of(int normal) {
  return normal == 2 ? std::array{0, 1} : normal == 1 ? std::array{0, 2} : std::array{2, 1};
}

report::SliceValues empty_slice(const Domain& domain, int axis) {
  const std::array<int, 2> axes = axes_of(axis);
  report::SliceValues slice;
  slice.shape.axes = axes;
  slice.shape.width = domain.cells[axes[0]];
  slice.shape.height = domain.cells[axes[1]];
  slice.shape.cell_width = domain.spacing[axes[0]];
  slice.shape.cell_height = domain.spacing[axes[1]];
  const int plane = domain.cells[axis] / 2;
  slice.shape.position = (plane + 0.5) * domain.spacing[axis];
  const auto count = static_cast<std::size_t>(slice.shape.width) * slice.shape.height;
  slice.values.assign(count, 0);
  slice.grain.assign(count, 0);
  return slice;
}

std::string title_of(const config::Case& the_case, const std::string& what) {
  return the_case.run.title.empty() ? what : the_case.run.title;
}

report::Picture draw(const geom::Sample& sample, const Domain& domain,
                     const std::array<report::SliceValues, 3>& slices,
                     const report::PictureStyle& style) {
  if (is_chip(sample, domain)) {
    return report::draw_slice(slices[2].view(), style);
  }
  return report::draw_three_slices({slices[0].view(), slices[1].view(), slices[2].view()}, style);
}

/// Distance to the nearest grain on the middle plane, within a band [m].
report::SliceValues distance_slice(const geom::Sample& sample, const Domain& domain, int axis,
                                   Real band) {
  report::SliceValues slice = empty_slice(domain, axis);
  const std::array<int, 2> axes = slice.shape.axes;
  Vec3 low = domain.origin();
  Vec3 high = low + domain.size();
  low[axis] += slice.shape.position;
  high[axis] = low[axis];
  const geom::Solid solid = geom::make_solid(sample, low, high, band);
  std::size_t at = 0;
  for (int b = 0; b < slice.shape.height; ++b) {
    for (int a = 0; a < slice.shape.width; ++a, ++at) {
      Vec3 x = low;
      x[axes[0]] += (a + 0.5) * slice.shape.cell_width;
      x[axes[1]] += (b + 0.5) * slice.shape.cell_height;
      const Real s = geom::signed_distance(solid, x);
      slice.values[at] = static_cast<float>(std::min(s, band));
      slice.grain[at] = s <= 0 ? 1 : 0;
    }
  }
  return slice;
}

}  // namespace

bool is_chip(const geom::Sample& sample, const Domain& domain) {
  const bool extruded = sample.spec.kind == geom::Kind::cylinders ||
                        (sample.spec.kind == geom::Kind::image && sample.voxels.n[2] == 1);
  return extruded || 4 * domain.cells[2] <= std::min(domain.cells[0], domain.cells[1]);
}

namespace {

/// Calls visit(place in the plane, place in the block) for this rank's cells from layer first to last
/// along the axis normal to it, both included.
template <typename Visit>
void for_layers(const report::Slice& shape, const grid::Block& block, int first, int last,
                const Visit& visit) {
  const auto [right, up] = shape.axes;
  const int axis = 3 - right - up;
  Int3 low{};
  Int3 high{block.n[0] - 1, block.n[1] - 1, block.n[2] - 1};
  low[axis] = std::max(low[axis], first);
  high[axis] = std::min(high[axis], last);
  grid::for_window(low, high, [&, right = right, up = up](const Int3& cell) {
    const Index in_plane =
        block.start[right] + cell[right] + Index{shape.width} * (block.start[up] + cell[up]);
    const Index in_block = cell[0] + block.n[0] * (cell[1] + Index{block.n[1]} * cell[2]);
    visit(static_cast<std::size_t>(in_plane), static_cast<std::size_t>(in_block));
  });
}

/// Adds up everybody's part on rank 0; empty elsewhere.
report::SliceValues add_up(report::SliceValues slice, const par::Communicator& comm) {
  const auto count = static_cast<int>(slice.values.size());
  const bool root = comm.is_root();
  MPI_Reduce(root ? MPI_IN_PLACE : slice.values.data(), slice.values.data(), count, MPI_FLOAT,
             MPI_SUM, 0, comm.handle());
  MPI_Reduce(root ? MPI_IN_PLACE : slice.grain.data(), slice.grain.data(), count, MPI_UINT8_T,
             MPI_SUM, 0, comm.handle());
  return root ? slice : report::SliceValues{};
}

}  // namespace

report::SliceValues gather_mid_slice(std::span<const float> values, std::span<const float> solid,
                                     const grid::Block& block, const Domain& domain, int axis,
                                     const par::Communicator& comm) {
  report::SliceValues slice = empty_slice(domain, axis);
  const int plane = domain.cells[axis] / 2 - block.start[axis];
  for_layers(slice.shape, block, plane, plane, [&](std::size_t to, std::size_t from) {
    slice.values[to] = values[from];
    slice.grain[to] = solid[from] > 0.5F ? 1 : 0;
  });
  return add_up(std::move(slice), comm);
}

report::SliceValues gather_mean_slice(std::span<const float> values, const grid::Block& block,
                                      const Domain& domain, int axis,
                                      const par::Communicator& comm) {
  report::SliceValues slice = empty_slice(domain, axis);
  const auto share = 1.0F / static_cast<float>(domain.cells[axis]);
  for_layers(slice.shape, block, 0, block.n[axis] - 1,
             [&](std::size_t to, std::size_t from) { slice.values[to] += share * values[from]; });
  return add_up(std::move(slice), comm);
}

std::vector<float> speeds_of(const flow::StokesSolver::CellFields& fields) {
  std::vector<float> speed(fields.pressure.size());
  for (std::size_t at = 0; at < speed.size(); ++at) {
    speed[at] = static_cast<float>(
        norm(Vec3{fields.velocity[0][at], fields.velocity[1][at], fields.velocity[2][at]}));
  }
  return speed;
}

void draw_fields(const std::string& folder, const config::Case& the_case,
                 const geom::Sample& sample, const Domain& domain,
                 const flow::StokesSolver::CellFields& fields, std::span<const float> solid,
                 const grid::Block& block, const io::Provenance& provenance,
                 const par::Communicator& comm) {
  const std::vector<float> speed = speeds_of(fields);
  struct Subject {
    std::span<const float> values;
    report::PictureStyle style;
  };
  const report::PictureStyle of_speed{.title = title_of(the_case, "Speed"),
                                      .quantity = "speed",
                                      .unit = "m/s",
                                      .colormap = report::Colormap::speed,
                                      .flow_to = flow_to(the_case.flow)};
  report::PictureStyle of_pressure = of_speed;
  of_pressure.title = title_of(the_case, "Pressure");
  of_pressure.quantity = "pressure";
  of_pressure.unit = "Pa";
  of_pressure.colormap = report::Colormap::pressure;
  std::string failure;
  for (const Subject& subject : {Subject{speed, of_speed}, Subject{fields.pressure, of_pressure}}) {
    std::array<report::SliceValues, 3> slices;
    for (int axis = 0; axis < 3; ++axis) {
      slices[axis] = gather_mid_slice(subject.values, solid, block, domain, axis, comm);
    }
    if (comm.is_root()) {
      try {
        report::write_picture(folder + "/" + subject.style.quantity + ".png",
                              draw(sample, domain, slices, subject.style), provenance,
                              subject.style.title);
      } catch (const std::exception& error) {
        failure = error.what();
      }
    }
  }
  io::throw_everywhere(comm.handle(), failure);
}

void draw_sample(const std::string& folder, const config::Case& the_case,
                 const geom::Sample& sample, const Domain& domain,
                 const io::Provenance& provenance) {
  const bool chip = is_chip(sample, domain);
  const Real band = (chip ? 24 : 8) * std::max(domain.spacing.x, domain.spacing.y);
  std::array<report::SliceValues, 3> slices;
  for (int axis = chip ? 2 : 0; axis < 3; ++axis) {
    slices[axis] = distance_slice(sample, domain, axis, band);
  }
  const report::PictureStyle style{.title = title_of(the_case, "Geometry"),
                                   .quantity = "distance to grain",
                                   .unit = "m",
                                   .colormap = report::Colormap::pressure,
                                   .flow_to = flow_to(the_case.flow)};
  report::write_picture(folder + "/geometry.png", draw(sample, domain, slices, style), provenance,
                        style.title);
}

}  // namespace porefines::sim
