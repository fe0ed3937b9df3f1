// SPDX-License-Identifier: MPL-2.0
#include "dem/primitive.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::dem {

namespace {

/// Where a wall is nearest to a point: distance (negative inside the wall), direction from the
/// wall, curvature.
struct Nearest {
  Real distance = 0;
  Vec3 normal;
  Real curvature = 0;
};

/// Nearest point of a round wall given the vector from its centre or axis.
/// @param directions  in how many of the two surface directions it is curved
Nearest nearest_round(const Vec3& from_centre, Real radius, bool hollow, int directions,
                      const Vec3& any) {
  const Real away = norm(from_centre);
  const Vec3 outward = away > 0 ? from_centre / away : any;
  const Real mean = 0.5 * directions / radius;
  return hollow ? Nearest{radius - away, -1.0 * outward, -mean}
                : Nearest{away - radius, outward, mean};
}

Nearest nearest(const Plane& wall, const Vec3& x) {
  return {dot(x - wall.point, wall.normal), wall.normal, 0};
}
Nearest nearest(const Cylinder& wall, const Vec3& x) {
  const Vec3 d = x - wall.point;
  const Vec3 least = std::abs(wall.axis.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
  const Vec3 across = cross(wall.axis, least);
  return nearest_round(d - dot(d, wall.axis) * wall.axis, wall.radius, wall.hollow, 1,
                       across / norm(across));
}
Nearest nearest(const Ball& wall, const Vec3& x) {
  return nearest_round(x - wall.centre, wall.radius, wall.hollow, 2, {1, 0, 0});
}

bool too_narrow(const Plane& /*wall*/, Real /*radius*/) {
  return false;
}
bool too_narrow(const auto& wall, Real radius) {
  return wall.hollow && radius > wall.radius;
}

void turn(Vec3& direction, const Vec3& angle) {
  direction += cross(angle, direction + 0.5 * cross(angle, direction));
  direction *= 1 / norm(direction);
}

/// Point of a wall after dt; it may be off the axis of rotation.
void carry(Vec3& point, const Motion& motion, Real dt) {
  Vec3 arm = point - motion.about;
  const Real length = norm(arm);
  if (length > 0) {
    turn(arm, dt * motion.spin);
    arm *= length;
  }
  point = motion.about + arm + dt * motion.velocity;
}

void advance_one(Plane& wall, Real dt) {
  carry(wall.point, wall.motion, dt);
  turn(wall.normal, dt * wall.motion.spin);
}
void advance_one(Cylinder& wall, Real dt) {
  carry(wall.point, wall.motion, dt);
  turn(wall.axis, dt * wall.motion.spin);
}
void advance_one(Ball& wall, Real dt) {
  carry(wall.centre, wall.motion, dt);
}

void make_unit(Vec3& direction, const char* what, std::size_t place) {
  const Real length = norm(direction);
  if (!(length > 0) || !std::isfinite(length)) {
    throw InputError(
        fmt::format("wall {}: its {} has no length; give one such as [0, 0, 1].", place, what));
  }
  direction *= 1 / length;
}
void check(Plane& wall, std::size_t place) {
  make_unit(wall.normal, "normal", place);
}
void check_radius(Real radius, std::size_t place) {
  if (!(radius > 0) || !std::isfinite(radius)) {
    throw InputError(fmt::format("wall {}: radius {:.3g} m; it must be positive.", place, radius));
  }
}
void check(Cylinder& wall, std::size_t place) {
  make_unit(wall.axis, "axis", place);
  check_radius(wall.radius, place);
}
void check(Ball& wall, std::size_t place) {
  check_radius(wall.radius, place);
}

/// What advance() changes.
std::array<Vec3*, 3> moving_parts(Plane& wall) {
  return {&wall.point, &wall.normal, &wall.motion.about};
}

std::array<Vec3*, 3> moving_parts(Cylinder& wall) {
  return {&wall.point, &wall.axis, &wall.motion.about};
}

std::array<Vec3*, 3> moving_parts(Ball& wall) {
  return {&wall.centre, &wall.motion.velocity, &wall.motion.about};
}

std::array<Vec3*, 3> moving_parts(Primitive& wall) {
  return std::visit([](auto& shape) { return moving_parts(shape); }, wall);
}

}  // namespace

Primitives checked(Primitives walls) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    std::visit([&](auto& wall) { check(wall, w); }, walls[w]);
  }
  return walls;
}

Primitives box_faces(const Vec3& low, const Vec3& high, const std::array<bool, 6>& which) {
  Primitives walls;
  for (std::size_t face = 0; face < 6; ++face) {
    if (which[face]) {
      const bool is_upper = is_high(static_cast<BoxFace>(face));
      Plane wall{is_upper ? high : low, {}};
      wall.normal[axis_of(static_cast<BoxFace>(face))] = is_upper ? -1 : 1;
      walls.emplace_back(wall);
    }
  }
  return walls;
}

void advance(Primitives& walls, Real dt) {
  for (Primitive& primitive : walls) {
    std::visit(
        [&](auto& wall) {
          advance_one(wall, dt);
          wall.motion.about += dt * wall.motion.velocity;
        },
        primitive);
  }
}

std::vector<Real> places(const Primitives& walls) {
  std::vector<Real> numbers;
  for (Primitive wall : walls) {
    for (const Vec3* v : moving_parts(wall)) {
      numbers.insert(numbers.end(), {v->x, v->y, v->z});
    }
  }
  return numbers;
}

std::span<const Real> put_back(Primitives& walls, std::span<const Real> places) {
  for (Primitive& wall : walls) {
    for (Vec3* v : moving_parts(wall)) {
      *v = {places[0], places[1], places[2]};
      places = places.subspan(3);
    }
  }
  return places;
}

namespace {

void touch_one(const auto& wall, std::size_t place, const Vec3& centre, Real radius, Real reach,
               TouchList& out) {
  const Nearest there = nearest(wall, centre);
  const Real gap = there.distance - radius;
  if (gap >= reach) {
    return;
  }
  const Motion& motion = wall.motion;
  const Vec3 at = centre - there.distance * there.normal;
  out.inside = out.inside || there.distance <= 0 || too_narrow(wall, radius);
  out.add({there.normal, gap, motion.velocity + cross(motion.spin, at - motion.about),
           there.curvature, 1, static_cast<std::uint32_t>(place)});
}

}  // namespace

void find_touches(const Primitives& walls, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  for (std::size_t w = 0; w < walls.size(); ++w) {
    if (const auto* plane = std::get_if<Plane>(&walls[w])) {  // most are, and most are far: no jump
      touch_one(*plane, w, centre, radius, reach, out);
    } else {
      std::visit([&](const auto& wall) { touch_one(wall, w, centre, radius, reach, out); },
                 walls[w]);
    }
  }
}

}  // namespace porefines::dem
