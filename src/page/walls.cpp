// SPDX-License-Identifier: MPL-2.0
#include "page/walls.hpp"

#include <vector>

#include "core/error.hpp"
#include "core/json.hpp"
#include "dem/mesh.hpp"
#include "page/pack.hpp"

namespace porefines::page {
namespace {

using config::Shape;
using config::ShapeKind;

std::vector<Real> corners_of(const Shape& shape) {
  constexpr std::size_t most = 20'000;
  std::vector<geom::Triangle> triangles;
  try {
    triangles = dem::read_stl(shape.source, shape.unit);
  } catch (const InputError&) {
    return {};
  }
  std::vector<Real> out;
  for (const geom::Triangle& triangle : triangles) {
    for (const auto& corner : triangle) {
      for (std::size_t axis = 0; axis < 3; ++axis) {
        out.push_back(corner[axis] + shape.point[axis]);
      }
    }
  }
  return triangles.size() > most ? std::vector<Real>{} : out;
}

std::string wall_json(const Shape& shape) {
  Json json;
  json.set_json("point_m", json_numbers(shape.point));
  switch (shape.kind) {
    case ShapeKind::plane:
      json.set("kind", "plane");
      json.set_json("normal", json_numbers(shape.normal));
      break;
    case ShapeKind::cylinder:
      json.set("kind", "cylinder");
      json.set_json("axis", json_numbers(shape.axis));
      json.set("radius_m", shape.radius);
      break;
    case ShapeKind::sphere:
      json.set("kind", "sphere");
      json.set("radius_m", shape.radius);
      break;
    case ShapeKind::mesh:
      json.set("kind", "mesh");
      json.set_json("corners_m", json_numbers(corners_of(shape)));
      break;
  }
  return json.text();
}

}  // namespace

std::string walls_json(const config::Case& the_case) {
  std::vector<std::string> walls;
  for (const Shape& shape : the_case.surface) {
    walls.push_back(wall_json(shape));
  }
  return walls.empty() ? "" : json_list(walls);
}

}  // namespace porefines::page
