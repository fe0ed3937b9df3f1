// SPDX-License-Identifier: MPL-2.0
#include "sim/domain.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::sim {
namespace {

constexpr std::string_view axis_names = "xyz";
constexpr int most_cells_along = 1 << 20;

bool has_reservoir(const config::Case& the_case) {
  const bool empty = the_case.geometry.kind == config::GeometryKind::empty;
  const Real given = the_case.flow.reservoir;
  return the_case.flow.inlet && (given < 0 ? !empty : given > 0);
}

void require_opposite_openings(const config::Flow& flow) {
  if (flow.inlet && axis_of(flow.inlet->face) != axis_of(flow.outlet->face)) {
    throw InputError(
        "[flow] inlet and outlet are not on opposite faces of the box\n"
        "the permeability is measured from face to face: try x- and x+");
  }
}

void require_depth(const config::Geometry& geometry, const geom::Sample& sample) {
  if (geometry.kind != config::GeometryKind::image) {
    return;
  }
  const bool flat = sample.voxels.n[2] == 1;
  if (flat && geometry.depth == 0) {
    throw InputError(
        fmt::format("[geometry] {} is a 2D image: how deep are its pores?\ndepth = \"20 um\"",
                    geometry.source));
  }
  if (!flat && geometry.depth > 0) {
    throw InputError(
        fmt::format("[geometry] depth has no meaning for {}, which has {} layers\ndelete the key",
                    geometry.source, sample.voxels.n[2]));
  }
}

/// Cells of the sample along one axis.
int cells_along(const config::Grid& grid, Real length, int axis) {
  if (grid.cells[axis] > 0) {
    return grid.cells[axis];
  }
  const Real cells = std::round(length / grid.cell_size);
  if (cells < 1) {
    throw InputError(
        fmt::format("[grid] cell_size: {:.6g} m is larger than the box, {:.6g} m along {}\n"
                    "is the unit right?",
                    grid.cell_size, length, axis_names[axis]));
  }
  if (cells > most_cells_along) {
    throw InputError(
        fmt::format("[grid] cell_size: {:.6g} m makes {:.3g} cells along {}, more than 2^20\n"
                    "is the unit right?",
                    grid.cell_size, cells, axis_names[axis]));
  }
  return static_cast<int>(cells);
}

int reservoir_cells(const config::Case& the_case, Real length, Real spacing) {
  constexpr int least = 4;
  constexpr Real share = 0.02;
  if (!has_reservoir(the_case)) {
    return 0;
  }
  const Real given = the_case.flow.reservoir;
  const Real cells = (given < 0 ? share * length : given) / spacing;
  return std::max(given < 0 ? least : 1, static_cast<int>(std::lround(cells)));
}

flow::FaceKind kind_of(const config::Flow& flow, BoxFace face) {
  const auto at = static_cast<std::size_t>(face);
  if (flow.periodic[axis_of(face)]) {
    return flow::FaceKind::periodic;
  }
  for (const auto& opening : {flow.inlet, flow.outlet}) {
    if (opening && opening->face == face) {
      const bool velocity = opening->kind == config::DriveKind::velocity;
      return velocity ? flow::FaceKind::velocity : flow::FaceKind::pressure;
    }
  }
  return flow.slip[at] ? flow::FaceKind::slip : flow::FaceKind::wall;
}

/// What inertia changes: fluid leaves with its vortices, a rate enters evenly, and a wall may move.
flow::FaceKind kind_of(const config::Case& the_case, BoxFace face) {
  const flow::FaceKind kind = kind_of(the_case.flow, face);
  if (!config::is_inertial(the_case)) {
    const bool pumped = config::pumps_velocities(the_case) && kind == flow::FaceKind::velocity;
    return pumped ? flow::FaceKind::pressure : kind;  // see with_rates()
  }
  for (const auto& opening : {the_case.flow.inlet, the_case.flow.outlet}) {
    if (opening && opening->face == face && opening->kind == config::DriveKind::flow_rate) {
      return flow::FaceKind::velocity;  // see with_velocities()
    }
  }
  const auto& lid = the_case.inertia.lid;
  if (lid && lid->face == face) {
    return flow::FaceKind::lid;
  }
  const bool leaves = the_case.flow.outlet && flow_to(the_case.flow) == face;
  return leaves && kind == flow::FaceKind::pressure ? flow::FaceKind::outflow : kind;
}

/// The staircase is the grid: cells must be voxels.
void require_voxel_cells(const config::Geometry& geometry, const geom::Sample& sample,
                         const Domain& domain) {
  if (geometry.kind != config::GeometryKind::image || geometry.surface == config::Surface::smooth) {
    return;
  }
  const int axes = sample.voxels.n[2] == 1 ? 2 : 3;
  for (int axis = 0; axis < axes; ++axis) {
    if (std::abs(domain.spacing[axis] / sample.pixel - 1) > 1e-6) {
      throw InputError(
          fmt::format("[geometry] surface = \"voxel\" needs cells that are voxels: along {} a cell "
                      "has {:.6g} m, "
                      "a voxel {:.6g} m\ntry cell_size = \"{:.6g} m\", or surface = \"smooth\"",
                      axis_names[axis], domain.spacing[axis], sample.pixel, sample.pixel));
    }
  }
}

geom::Kind kind_of(config::GeometryKind kind) {
  switch (kind) {
    case config::GeometryKind::spheres:
      return geom::Kind::spheres;
    case config::GeometryKind::cylinders:
      return geom::Kind::cylinders;
    case config::GeometryKind::empty:
      return geom::Kind::empty;
    case config::GeometryKind::image:
      break;
  }
  return geom::Kind::image;
}

geom::Surroundings surroundings(const config::Case& the_case) {
  geom::Surroundings beyond{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool periodic = the_case.flow.periodic[axis] || the_case.box.periodic[axis];
    beyond[axis] = periodic ? geom::Beyond::periodic : geom::Beyond::mirror;
  }
  if (has_reservoir(the_case)) {
    beyond[flow_axis(the_case.flow)] = geom::Beyond::pore;
  }
  return beyond;
}

}  // namespace

int flow_axis(const config::Flow& flow) {
  if (flow.inlet) {
    return axis_of(flow.inlet->face);
  }
  const auto larger = [](Real a, Real b) { return std::abs(a) < std::abs(b); };
  const auto& gradient = flow.pressure_gradient;
  const auto largest = std::max_element(gradient.begin(), gradient.end(), larger);
  if (*largest != 0) {
    return static_cast<int>(largest - gradient.begin());
  }
  const auto periodic = std::find(flow.periodic.begin(), flow.periodic.end(), true);
  return periodic == flow.periodic.end() ? 0 : static_cast<int>(periodic - flow.periodic.begin());
}

BoxFace flow_to(const config::Flow& flow) {
  if (!flow.inlet) {
    const int axis = flow_axis(flow);
    return box_face(axis, flow.pressure_gradient[axis] >= 0);
  }
  const bool backwards = flow.inlet->kind == config::DriveKind::pressure &&
                         flow.outlet->kind == config::DriveKind::pressure &&
                         flow.inlet->value < flow.outlet->value;
  return backwards ? flow.inlet->face : flow.outlet->face;
}

geom::Spec geometry_spec(const config::Case& the_case) {
  const config::Geometry& g = the_case.geometry;
  geom::Spec spec;
  spec.kind = kind_of(g.kind);
  spec.source = g.source;
  spec.pixel_size = g.pixel_size;
  spec.segmentation = {g.pore_value, g.threshold, g.otsu, g.pore_is_bright};
  spec.raw_size = g.raw_size;
  spec.crop = g.crop;
  spec.depth = g.depth;
  spec.size = {g.size[0], g.size[1], g.size[2]};
  spec.list_unit = g.list_unit;
  spec.periodic_images = g.periodic_images;
  spec.smooth = g.smooth;
  spec.only_percolating = g.keep == config::Keep::percolating;
  spec.remove_grains_below = g.remove_grains_below;
  spec.fill_pores_below = g.fill_pores_below;
  spec.erode_grains = g.erode_grains;
  spec.edit_mask = g.edit_mask;
  spec.reconnect_gap = g.reconnect_gap;
  spec.minimum_throat = g.minimum_throat;
  spec.beyond = surroundings(the_case);
  spec.flow_axis = flow_axis(the_case.flow);
  return spec;
}

Vec3 Domain::origin() const {
  Vec3 corner;
  corner[axis] = -reservoir * spacing[axis];
  return corner;
}

Vec3 Domain::size() const {
  return {cells[0] * spacing.x, cells[1] * spacing.y, cells[2] * spacing.z};
}

Real Domain::length() const {
  return sample_size[axis];
}

Real Domain::area() const {
  return sample_size.x * sample_size.y * sample_size.z / length();
}

Int3 Domain::sample_cells() const {
  Int3 n = cells;
  n[axis] -= 2 * reservoir;
  return n;
}

Domain make_domain(const config::Case& the_case, const geom::Sample& sample) {
  require_opposite_openings(the_case.flow);
  require_depth(the_case.geometry, sample);
  Domain domain;
  domain.axis = flow_axis(the_case.flow);
  domain.sample_size = sample.box.size;
  for (int axis = 0; axis < 3; ++axis) {
    const Real length = sample.box.size[axis];
    domain.cells[axis] = cells_along(the_case.grid, length, axis);
    domain.spacing[axis] = length / domain.cells[axis];
  }
  domain.reservoir = reservoir_cells(the_case, domain.length(), domain.spacing[domain.axis]);
  domain.cells[domain.axis] += 2 * domain.reservoir;
  for (int face = 0; face < 6; ++face) {
    domain.boundaries.kind[face] = kind_of(the_case, static_cast<BoxFace>(face));
  }
  require_voxel_cells(the_case.geometry, sample, domain);
  return domain;
}

io::GridBlock grid_block(const Domain& domain, const grid::Block& block) {
  return {.global_cells = domain.cells,
          .origin = domain.origin(),
          .spacing = domain.spacing,
          .offset = block.start,
          .cells = block.n};
}

}  // namespace porefines::sim
