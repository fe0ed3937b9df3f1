// SPDX-License-Identifier: MPL-2.0
#include "sim/particle_walls.hpp"

#include <algorithm>

#include "sim/beds.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

/// Planes, cylinders and balls of [[surface]].
dem::Primitives primitives_of(const config::Case& the_case) {
  dem::Primitives walls;
  for (const config::Shape& shape : the_case.surface) {
    const dem::Motion motion{vec(shape.velocity), {}, vec(shape.point)};
    switch (shape.kind) {
      case config::ShapeKind::plane:
        walls.emplace_back(dem::Plane{vec(shape.point), vec(shape.normal), motion});
        break;
      case config::ShapeKind::cylinder:
        walls.emplace_back(
            dem::Cylinder{vec(shape.point), vec(shape.axis), shape.radius, shape.inside, motion});
        break;
      case config::ShapeKind::sphere:
        walls.emplace_back(dem::Ball{vec(shape.point), shape.radius, shape.inside, motion});
        break;
      case config::ShapeKind::mesh:
        break;  // a surface of its own
    }
  }
  return dem::checked(std::move(walls));
}

/// STL files of [[surface]], put where `point` says.
void add_meshes(const config::Case& the_case, dem::Surfaces& out) {
  for (const config::Shape& shape : the_case.surface) {
    if (shape.kind != config::ShapeKind::mesh) {
      continue;
    }
    std::vector<geom::Triangle> triangles = dem::read_stl(shape.source, shape.unit);
    for (geom::Triangle& triangle : triangles) {
      for (auto& corner : triangle) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
          corner[axis] += static_cast<float>(shape.point[axis]);
        }
      }
    }
    out.emplace_back(dem::Fixed(dem::make_mesh(triangles, 2 * largest_radius(the_case))));
  }
}

/// The grains of the sample, good for spheres of up to `largest` [m] radius and as much reach.
struct AddGrains {
  dem::Surfaces& out;
  Real largest;

  void operator()(const geom::Empty&) const {}
  void operator()(const geom::SphereList& list) const {
    out.emplace_back(dem::Fixed(dem::RoundGrains<3>{list, {}}));
  }
  void operator()(const geom::CylinderList& list) const {
    out.emplace_back(dem::Fixed(dem::RoundGrains<2>{list, {}}));
  }
  void operator()(const geom::VoxelSolid& solid) const {
    out.emplace_back(dem::Fixed(dem::make_field(solid, 2 * largest)));
  }
};

void add_grains(const config::Case& the_case, const geom::Sample& sample, const Vec3& low,
                const Vec3& high, dem::Surfaces& out) {
  constexpr Real voxels_beyond = 6;  // what make_field wants, and a little
  if (sample.spec.kind == geom::Kind::empty) {
    return;
  }
  const Real largest = largest_radius(the_case);
  const Real margin = 2 * largest + voxels_beyond * sample.pixel;
  const Vec3 beyond{margin, margin, margin};
  const geom::Solid solid = geom::make_solid(sample, low - beyond, high + beyond,
                                             2 * largest + voxels_beyond * sample.pixel);
  std::visit(AddGrains{out, largest}, solid);
}

}  // namespace

Walls make_walls(const config::Case& the_case, const geom::Sample& sample, const Vec3& low,
                 const Vec3& high) {
  const config::Box& faces = the_case.box;
  std::array<bool, 6> rough{};
  for (std::size_t face = 0; face < 6; ++face) {
    rough[face] = !faces.periodic[face / 2] && !faces.open[face] && !faces.smooth[face];
  }
  Walls walls;
  const auto add = [&](dem::Primitives primitives, bool smooth) {
    if (!primitives.empty()) {
      walls.surfaces.emplace_back(std::move(primitives));
      walls.smooth.push_back(smooth);
    }
  };
  add(dem::box_faces(low, high, rough), false);
  add(dem::box_faces(low, high, faces.smooth), true);
  add(primitives_of(the_case), false);
  add_meshes(the_case, walls.surfaces);
  add_grains(the_case, sample, low, high, walls.surfaces);
  walls.smooth.resize(walls.surfaces.size(), false);
  return walls;
}

Real largest_radius(const config::Case& the_case) {
  constexpr Real scaled = 1.1;  // a dense bed may scale its particles so much
  Real largest = 0;
  for (const config::Particles& species : the_case.particles) {
    if (species.source.empty()) {
      largest = std::max(largest, scaled * dem::largest_diameter(dem_sizes(species.diameter)) / 2);
      continue;
    }
    for (const dem::Body& body : read_spheres(species.source, species.diameter.mean)) {
      largest = std::max(largest, body.radius);
    }
  }
  return largest;
}

}  // namespace porefines::sim
