// SPDX-License-Identifier: MPL-2.0
#include "geometry_spec.hpp"

#include <cmath>

namespace porefines {
namespace {

geom::Kind kind_of(config::GeometryKind kind) {
  switch (kind) {
    case config::GeometryKind::image:
      return geom::Kind::image;
    case config::GeometryKind::spheres:
      return geom::Kind::spheres;
    case config::GeometryKind::cylinders:
      return geom::Kind::cylinders;
    case config::GeometryKind::empty:
      break;
  }
  return geom::Kind::empty;
}

}  // namespace

BoxFace flow_direction(const config::Flow& flow) {
  if (flow.outlet) {
    return flow.outlet->face;
  }
  if (flow.inlet) {
    return box_face(axis_of(flow.inlet->face), !is_high(flow.inlet->face));
  }
  int axis = 0;
  for (int other = 1; other < 3; ++other) {
    if (std::abs(flow.pressure_gradient[static_cast<std::size_t>(other)]) >
        std::abs(flow.pressure_gradient[static_cast<std::size_t>(axis)])) {
      axis = other;
    }
  }
  return box_face(axis, flow.pressure_gradient[static_cast<std::size_t>(axis)] >= 0);
}

geom::Spec geometry_spec(const config::Case& the_case) {
  const config::Geometry& from = the_case.geometry;
  geom::Spec spec;
  spec.kind = kind_of(from.kind);
  spec.source = from.source;
  spec.pixel_size = from.pixel_size;
  spec.segmentation = {from.pore_value, from.threshold, from.otsu, from.pore_is_bright};
  spec.raw_size = from.raw_size;
  spec.crop = from.crop;
  spec.depth = from.depth;
  spec.size = {from.size[0], from.size[1], from.size[2]};
  spec.list_unit = from.list_unit;
  spec.periodic_images = from.periodic_images;
  spec.smooth = from.smooth;
  spec.only_percolating = from.keep == config::Keep::percolating;
  spec.remove_grains_below = from.remove_grains_below;
  spec.fill_pores_below = from.fill_pores_below;
  spec.minimum_throat = from.minimum_throat;
  spec.flow_axis = axis_of(flow_direction(the_case.flow));
  for (std::size_t axis = 0; axis < 3; ++axis) {
    spec.beyond[axis] =
        the_case.flow.periodic[axis] ? geom::Beyond::periodic : geom::Beyond::mirror;
  }
  for (const auto& opening : {the_case.flow.inlet, the_case.flow.outlet}) {
    if (opening) {
      spec.beyond[static_cast<std::size_t>(axis_of(opening->face))] = geom::Beyond::pore;
    }
  }
  return spec;
}

}  // namespace porefines
