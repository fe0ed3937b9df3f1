// SPDX-License-Identifier: MPL-2.0
// Grains as triangles.
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "geom/pore_size.hpp"
#include "interop/export_case.hpp"

namespace porefines::interop {
namespace {

using geom::Triangle;

constexpr int corners = 128;
constexpr int subdivisions = 4;

/// A polygon with the circle's area.
geom::Outline circle(const geom::Body& body) {
  const Real step = 2 * std::numbers::pi / corners;
  const Real radius = body.radius * std::sqrt(step / std::sin(step));
  geom::Outline outline;
  for (int i = 0; i < corners; ++i) {
    outline.push_back(
        {body.centre.x + radius * std::cos(i * step), body.centre.y + radius * std::sin(i * step)});
  }
  return outline;
}

/// Extruded from -beyond to depth + beyond.
std::vector<Triangle> through_plates(const std::vector<geom::Outline>& outlines, Real depth,
                                     Real beyond) {
  std::vector<Triangle> triangles = geom::extrude(outlines, depth + 2 * beyond);
  for (Triangle& triangle : triangles) {
    for (auto& corner : triangle) {
      corner[2] -= static_cast<float>(beyond);
    }
  }
  return triangles;
}

using Face = std::array<Vec3, 3>;

Vec3 unit(const Vec3& v) {
  return (1 / std::sqrt(dot(v, v))) * v;
}

/// An octahedron whose faces are cut in four again and again, counter-clockwise
/// from outside.
std::vector<Face> unit_sphere() {
  std::vector<Face> faces;
  for (const Real x : {1.0, -1.0}) {
    for (const Real y : {1.0, -1.0}) {
      for (const Real z : {1.0, -1.0}) {
        const Face face{Vec3{x, 0, 0}, Vec3{0, y, 0}, Vec3{0, 0, z}};
        faces.push_back(x * y * z > 0 ? face : Face{face[0], face[2], face[1]});
      }
    }
  }
  for (int level = 0; level < subdivisions; ++level) {
    std::vector<Face> finer;
    for (const Face& f : faces) {
      const Vec3 a = unit(f[0] + f[1]);
      const Vec3 b = unit(f[1] + f[2]);
      const Vec3 c = unit(f[2] + f[0]);
      finer.insert(finer.end(),
                   {Face{f[0], a, c}, Face{a, f[1], b}, Face{c, b, f[2]}, Face{a, b, c}});
    }
    faces = std::move(finer);
  }
  return faces;
}

Triangle placed(const Face& face, const Vec3& centre, Real radius) {
  Triangle triangle;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 at = centre + radius * face[i];
    triangle[i] = {static_cast<float>(at.x), static_cast<float>(at.y), static_cast<float>(at.z)};
  }
  return triangle;
}

std::vector<Triangle> spheres(const std::vector<geom::Body>& bodies) {
  const std::vector<Face> faces = unit_sphere();
  std::vector<Triangle> one;
  for (const Face& face : faces) {
    one.push_back(placed(face, {}, 1));
  }
  const Real exact = 4.0 / 3 * std::numbers::pi;
  const Real larger = std::cbrt(exact / geom::enclosed_volume(one));
  std::vector<Triangle> triangles;
  for (const geom::Body& body : bodies) {
    for (const Face& face : faces) {
      triangles.push_back(placed(face, body.centre, larger * body.radius));
    }
  }
  return triangles;
}

std::vector<Triangle> image(const config::Case& the_case, const geom::Sample& sample, Real beyond) {
  const Real smooth = sample.spec.smooth < 0 ? 1 : sample.spec.smooth / sample.pixel;
  const geom::VoxelSolid solid =
      geom::whole_solid(sample.voxels.view(), sample.pixel, sample.spec.beyond, smooth);
  if (solid.n[2] > 1) {
    return geom::grain_surface(solid);
  }
  const auto outlines =
      geom::simplify(geom::grain_outlines(solid), 0.1 * the_case.geometry.simplify * sample.pixel);
  return through_plates(outlines, sample.box.size.z, beyond);
}

}  // namespace

std::vector<Triangle> grain_triangles(const config::Case& the_case, const geom::Sample& sample,
                                      Real beyond) {
  switch (sample.spec.kind) {
    case geom::Kind::image:
      return image(the_case, sample, beyond);
    case geom::Kind::spheres:
      return spheres(sample.bodies);
    case geom::Kind::cylinders: {
      std::vector<geom::Outline> outlines;
      for (const geom::Body& body : sample.bodies) {
        outlines.push_back(circle(body));
      }
      return through_plates(outlines, sample.box.size.z, beyond);
    }
    default:
      return {};
  }
}

void write_text_stl(const std::string& path, const std::vector<Triangle>& triangles) {
  std::string text = "solid grains\n";
  for (const Triangle& triangle : triangles) {
    text += " facet normal 0 0 0\n  outer loop\n";
    for (const auto& corner : triangle) {
      text += fmt::format("   vertex {:.9g} {:.9g} {:.9g}\n", corner[0], corner[1], corner[2]);
    }
    text += "  endloop\n endfacet\n";
  }
  write_file(path, text + "endsolid grains\n");
}

}  // namespace porefines::interop
