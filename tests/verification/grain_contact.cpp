// SPDX-License-Identifier: MPL-2.0
// Spheres at rest in grooves, corners and throats, and rolling over grains made of voxels.
// Units of these tests: the sphere's diameter is 1, so is its density; gravity pulls with 1.
#include <gtest/gtest.h>

#include "dem/system.hpp"
#include "support/sampled.hpp"
#include "support/shapes.hpp"
#include "support/spheres.hpp"

namespace porefines::test {

namespace {

using dem::Surfaces;
using dem::System;
using dem::TouchList;

constexpr Real mass = std::numbers::pi / 6;
constexpr Real overlap = 2e-3;  // under the sphere's weight on one wall

/// Young's modulus at which the weight gives that overlap on a plane of the same material.
dem::Elastic soft() {
  const Real reduced = mass / (4.0 / 3 * std::sqrt(0.5) * std::pow(overlap, 1.5));
  return {"soft", 2 * (1 - 0.3 * 0.3) * reduced, 0.3};
}

System one_sphere(const Surfaces& walls, Real side, const Vec3& gravity, const dem::Body& body,
                  const dem::Friction& friction) {
  dem::Settings s = cube(side, false, soft(), friction);
  s.walls = walls;
  s.gravity = gravity;
  System system(par::Communicator::self(), s);
  system.insert(std::vector<dem::Body>{body});
  return system;
}

/// Where a sphere let go at `start` comes to rest.
Vec3 settle(const Surfaces& walls, Real side, const Vec3& gravity, const Vec3& start) {
  System system = one_sphere(walls, side, gravity, sphere(1, start, 0.5, 1), {0.2, 0.0, 0.0, 0.3});
  const Real dt = system.contact_duration(0.1) / 30;
  for (int part = 0; part < 60; ++part) {
    system.advance(dt, 200);
    system.particles().velocity[0] *= 0.5;
    system.rebuild();
  }
  EXPECT_EQ(system.wall_trouble().inside, 0);
  return system.particles().position[0];
}

/// Overlap of each of `count` equal touches that share the weight, normals at an angle of cosine
/// `cosine` to it: Hertz.
Real shared_overlap(int count, Real cosine) {
  return overlap * std::pow(1 / (count * cosine), 2.0 / 3);
}

Surfaces field(const geom::VoxelSolid& solid) {
  return {dem::Fixed(dem::make_field(solid, 0.6))};
}

constexpr Vec3 down_y{0, -1, 0};

}  // namespace

TEST(GrainContact, sphere_rests_in_a_groove_to_a_thousandth_of_its_diameter) {
  const Real half = 0.7;  // angle between wall and bisector
  const Vec3 bottom{2.03, 1.02, 0};
  const Vec3 left{std::cos(half), std::sin(half), 0};
  const Vec3 right{-std::cos(half), std::sin(half), 0};
  const auto groove = [&](Real voxels) {
    return [=](const Vec3& x) {
      const Vec3 y = x - voxels * bottom;
      return std::min(dot(y, left), dot(y, right));
    };
  };
  const Real sunk = shared_overlap(2, std::sin(half));
  const Vec3 exact = bottom + Vec3{0, (0.5 - sunk) / std::sin(half), 0};
  const Surfaces planes{dem::Primitives{dem::Plane{bottom, left}, dem::Plane{bottom, right}}};
  auto sheets = quad(bottom - Vec3{0, 0, 1}, {0, 0, 6}, 3.0 * Vec3{-left.y, left.x, 0});
  for (const auto& t :
       quad(bottom - Vec3{0, 0, 1}, 3.0 * Vec3{-right.y, right.x, 0} * -1.0, {0, 0, 6})) {
    sheets.push_back(t);
  }
  const Surfaces mesh{dem::Fixed(dem::make_mesh(sheets, 0.6))};
  for (const Real voxels : {8.0, 16.0}) {
    const int n = static_cast<int>(4 * voxels);
    const auto sampled_walls = field(sampled({n, n, 1}, 1 / voxels, groove(voxels)));
    for (const Surfaces& walls : {planes, mesh, sampled_walls}) {
      const Vec3 rest = settle(walls, 4, down_y, {2.06, exact.y + 0.03, 2});
      EXPECT_NEAR(rest.x, exact.x, 1e-3);
      EXPECT_NEAR(rest.y, exact.y, 1e-3);
    }
  }
}

TEST(GrainContact, sphere_rests_on_a_concave_corner_of_three_walls) {
  constexpr Real voxels = 8;
  const Vec3 corner{1.01, 0.97, 1.04};
  const auto walls = [&](const Vec3& x) {
    const Vec3 y = x - voxels * corner;
    return std::min({y.x, y.y, y.z});
  };
  constexpr int n = 24;
  const Real sunk = shared_overlap(3, 1 / std::sqrt(3.0));
  const Vec3 exact = corner + (0.5 - sunk) * Vec3{1, 1, 1};
  const Vec3 along = (-1 / std::sqrt(3.0)) * Vec3{1, 1, 1};
  const Surfaces planes{dem::box_faces(corner, {9, 9, 9}, {true, false, true, false, true, false})};
  const Surfaces mesh{dem::Fixed(dem::make_mesh(box_mesh(corner, {9, 9, 9}, true), 0.6))};
  for (const Surfaces& surfaces : {planes, mesh, field(sampled({n, n, n}, 1 / voxels, walls))}) {
    const Vec3 rest = settle(surfaces, 3, along, exact + Vec3{0.02, 0.03, 0.01});
    EXPECT_LT(norm(rest - exact), 1e-3);
  }
}

TEST(GrainContact, sphere_wedges_in_a_throat_between_two_grains) {
  constexpr Real grain = 2;  // radius
  for (const Real throat : {0.5, 0.9}) {
    const Real apart = grain + 0.5 * throat;
    const std::vector<geom::Body> grains{{{4 - apart, 2.6, 0}, grain},
                                         {{4 + apart, 2.6, 0}, grain}};
    const Surfaces exact_grains{dem::Fixed(dem::RoundGrains<2>{
        geom::CylinderList(
            grains, {{8, 8, 4}, {geom::Beyond::pore, geom::Beyond::pore, geom::Beyond::pore}}, true,
            1),
        {}})};
    for (const Real voxels : {8.0, 16.0}) {
      const auto distance = [&](const Vec3& x) {
        Real s = 1e9;
        for (const geom::Body& g : grains) {
          const Vec3 d = x - voxels * g.centre;
          s = std::min(s, std::hypot(d.x, d.y) - voxels * g.radius);
        }
        return s;
      };
      const int n = static_cast<int>(8 * voxels);
      const Surfaces voxel_grains = field(sampled({n, n, 1}, 1 / voxels, distance));
      for (const bool is_voxel : {false, true}) {
        // height h above the grains' centres, weight 2 N cos = 2 N h/(2.5 - sunk); Hertz' radius
        // knows the grain's curvature where the list does
        const Real reduced = is_voxel ? 0.5 : 1 / (2 + 0.5 / grain);
        Real sunk = 0;
        Real h = 0;
        for (int i = 0; i < 100; ++i) {
          const Real away = grain + 0.5 - sunk;
          h = std::sqrt(away * away - apart * apart);
          sunk = overlap * std::pow(std::sqrt(0.5 / reduced) * away / (2 * h), 2.0 / 3);
        }
        const Vec3 rest =
            settle(is_voxel ? voxel_grains : exact_grains, 8, down_y, {4.02, 2.6 + h + 0.02, 2});
        EXPECT_NEAR(rest.x, 4, 1e-3) << throat << ' ' << voxels << ' ' << is_voxel;
        EXPECT_NEAR(rest.y, 2.6 + h, 1e-3) << throat << ' ' << voxels << ' ' << is_voxel;
      }
    }
  }
}

TEST(GrainContact, sphere_touches_both_grains_of_a_throat_a_little_wider_and_falls_through) {
  constexpr Real voxels = 8;
  constexpr Real apart = 2.52;  // throat 1.04 between grains of radius 2
  const auto distance = [&](const Vec3& x) {
    return std::min(std::hypot(x.x - voxels * (4 - apart), x.y - voxels * 4.1),
                    std::hypot(x.x - voxels * (4 + apart), x.y - voxels * 4.1)) -
           2 * voxels;
  };
  const Surfaces walls = field(sampled({64, 72, 1}, 1 / voxels, distance));
  TouchList touches;
  dem::find_touches(walls, {4, 4.1, 2}, 0.5, 0.05, touches);
  ASSERT_EQ(touches.count, 2);  // gaps of 0.02 on either side
  EXPECT_NEAR(touches.touch[0].gap, 0.02, 1e-4);
  EXPECT_NEAR(touches.touch[1].gap, 0.02, 1e-4);
  System system =
      one_sphere(walls, 8, down_y, sphere(1, {4.2, 5.2, 2}, 0.5, 1), {0.2, 0.0, 0.0, 0.3});
  const Real dt = system.contact_duration(0.1) / 30;
  int touched = 0;
  while (system.particles().position[0].y > 3.2 && touched < 40000) {
    system.advance(dt, 1);
    touched += norm(system.particles().force[0]) > 0 ? 1 : 0;
  }
  EXPECT_GT(touched, 30);
  EXPECT_LT(system.particles().position[0].y, 3.2);
}

namespace {

/// What a sphere felt on its way over a grain.
struct Ride {
  Real jump = 0;  ///< largest change of the force between substeps / weight
  Real rms = 0;   ///< of the radial force / weight - its mean
  Real mean = 0;
  Real slip = 0;  ///< largest |v - w x r| / speed after the start: 0 for rolling
  Real most_overlap = 0;
  int held = 0;  ///< substeps in contact
  int steps = 0;
  Vec3 end;
};

/// Rolls a sphere over the top of a round grain; gravity always points at the grain's centre.
Ride roll(const Surfaces& walls, const Vec3& centre, Real grain, Real speed, Real way) {
  const Real from = std::numbers::pi / 2 + 0.5 * way / grain;
  const Vec3 e{std::cos(from), std::sin(from), 0};
  dem::Body body = sphere(1, centre + (grain + 0.5 - overlap) * e, 0.5, 1);
  body.velocity = speed * Vec3{e.y, -e.x, 0};
  body.angular_velocity = {0, 0, -speed / 0.5};
  System system = one_sphere(walls, 3 * centre.x, {}, body, {0.3, 0.5, 0.0, 0.3});
  const Real dt = system.contact_duration(0.1) / 30;
  Ride out;
  Vec3 last;
  Real sum = 0;
  Real square = 0;
  const int total = static_cast<int>(way / (speed * dt));
  for (int step = 0; step < total; ++step) {
    dem::Particles& p = system.particles();
    const Vec3 r = p.position[0] - centre;
    const Vec3 up = r / norm(r);
    p.external_force[0] = -mass * up - 0.5 * mass * dot(p.velocity[0], up) * up;
    system.advance(dt, 1);
    const Vec3 force = (1 / mass) * p.force[0];
    if (step > total / 5) {  // settled
      out.jump = std::max(out.jump, norm(force - last));
      sum += dot(force, up);
      square += dot(force, up) * dot(force, up);
      ++out.steps;
      out.held += norm(force) > 0 ? 1 : 0;
      const Vec3 at_foot = p.velocity[0] - 0.5 * cross(p.angular_velocity[0], up);
      out.slip = std::max(out.slip, norm(at_foot - dot(at_foot, up) * up) / speed);
    }
    last = force;
    out.end = p.position[0];
  }
  out.mean = sum / out.steps;
  out.rms = std::sqrt(std::max(square / out.steps - out.mean * out.mean, 0.0));
  out.most_overlap = system.largest_overlap();
  return out;
}

}  // namespace

TEST(GrainContact, rolling_over_a_grain_feels_no_jumps_and_does_not_slip) {
  constexpr Real grain = 3;
  const Vec3 centre{4.03, 4.05, 4};
  const auto disc = [&](Real voxels) {
    return [=](const Vec3& x) {
      return std::hypot(x.x - voxels * centre.x, x.y - voxels * centre.y) - voxels * grain;
    };
  };
  const Surfaces primitive{dem::Primitives{dem::Cylinder{centre, {0, 0, 1}, grain}}};
  const Ride exact = roll(primitive, centre, grain, 0.02, 0.4);
  EXPECT_LT(exact.jump, 1e-3);
  for (const Real voxels : {8.0, 16.0}) {
    const int n = static_cast<int>(10 * voxels);
    const Ride ride =
        roll(field(sampled({n, n, 1}, 1 / voxels, disc(voxels))), centre, grain, 0.02, 0.4);
    EXPECT_LT(ride.jump, 1e-3);
    EXPECT_EQ(ride.held, ride.steps);
    EXPECT_LT(ride.rms, 1e-3);
    EXPECT_LT(ride.slip, 0.01);  // friction holds: the tangential spring is kept from step to step
    EXPECT_LT(norm(ride.end - exact.end), 1e-3);
  }
  for (const Real voxels : {4.0, 8.0}) {  // and over the steps of a picture
    const int n = static_cast<int>(10 * voxels);
    const Ride ride =
        roll(field(pictured({n, n, 1}, 1 / voxels, disc(voxels))), centre, grain, 0.02, 0.4);
    EXPECT_LT(ride.jump, 0.01);
    EXPECT_EQ(ride.held, ride.steps);
  }
  for (const Real voxels : {8.0, 16.0}) {  // the levels of a grey picture know better
    const int n = static_cast<int>(10 * voxels);
    const Ride ride =
        roll(field(photographed({n, n, 1}, 1 / voxels, disc(voxels))), centre, grain, 0.02, 0.4);
    EXPECT_LT(ride.jump, 0.01) << voxels;
    EXPECT_EQ(ride.held, ride.steps) << voxels;
    EXPECT_LT(ride.rms, 1e-3) << voxels;
  }
}

namespace {

/// Elastic force on the sphere, of touches on planes that carry the weight at `overlap`.
Vec3 force_at(const Surfaces& walls, const Vec3& x) {
  TouchList touches;
  dem::find_touches(walls, x, 0.5, 0, touches);
  EXPECT_FALSE(touches.in_trouble());
  Vec3 force;
  for (const dem::Touch& touch : touches.view()) {
    force += touch.share * std::pow(std::max(-touch.gap, 0.0) / overlap, 1.5) * touch.normal;
  }
  return force;
}

struct Slide {
  Real jump = 0;     ///< largest change of force between substeps / load
  Real highest = 0;  ///< of the centre above the mean surface
  Real lowest = 0;
  int shared = 0;  ///< places with more than one touch
};

/// Carries a sphere under a constant load along a great circle in steps of `step`; its height follows
/// from balance, found by false position and halving (the force grows as the sphere sinks).
Slide slide(const Surfaces& walls, const Vec3& centre, Real grain, const Vec3& e1, const Vec3& e2,
            Real way, Real step) {
  Slide out;
  out.lowest = 1;
  Vec3 last;
  Real r = grain + 0.5;
  for (Real at = 0; at < way; at += step) {
    const Real angle = at / (grain + 0.5);
    const Vec3 up = std::cos(angle) * e1 + std::sin(angle) * e2;
    const auto excess = [&](Real radius) {
      return dot(force_at(walls, centre + radius * up), up) - 1;
    };
    Real width = at == 0 ? 0.2 : 4 * step;
    Real low = excess(r - width);
    Real high = excess(r + width);
    for (; low < 0 || high > 0; low = excess(r - width), high = excess(r + width)) {
      width *= 2;
    }
    Real below = r - width;
    Real above = r + width;
    for (int i = 0; i < 60 && above - below > 1e-13; ++i) {  // Illinois
      const Real next =
          i % 3 == 2 ? 0.5 * (below + above) : (above * low - below * high) / (low - high);
      const Real value = excess(next);
      r = next;
      if (std::abs(value) < 1e-9) {
        break;
      }
      (value > 0 ? below : above) = next;
      (value > 0 ? low : high) = value;
      (value > 0 ? high : low) *= 0.5;
    }
    const Vec3 force = force_at(walls, centre + r * up);
    out.jump = at == 0 ? 0 : std::max(out.jump, norm(force - last));
    out.highest = std::max(out.highest, r - grain - 0.5);
    out.lowest = std::min(out.lowest, r - grain - 0.5);
    TouchList touches;
    dem::find_touches(walls, centre + r * up, 0.5, 0, touches);
    out.shared += touches.count > 1 ? 1 : 0;
    last = force;
  }
  return out;
}

}  // namespace

// Where the pictured surface has dips narrower than the sphere, minima of the distance are born, join
// and die under load. The force follows without jumps, direction included.
TEST(GrainContact, force_is_continuous_over_the_dips_of_a_pictured_grain) {
  int shared = 0;
  for (const Real voxels : {4.0, 8.0, 16.0}) {
    const Real grain = 1.5;
    const int n = static_cast<int>(6 * voxels);
    const Vec3 centre{3.03, 2.98, 3.01};
    const auto distance = [&](const Vec3& x) {
      return std::hypot(x.x - voxels * centre.x, x.y - voxels * centre.y) - voxels * grain;
    };
    const auto ball = [&](const Vec3& x) { return norm(x - voxels * centre) - voxels * grain; };
    const Slide flat = slide(field(pictured({n, n, 1}, 1 / voxels, distance)), centre, grain,
                             {1, 0, 0}, {0, 1, 0}, 0.8, 1e-4);
    EXPECT_LT(flat.jump, 0.01) << voxels;
    shared += flat.shared;
    const Slide solid = slide(field(pictured({n, n, n}, 1 / voxels, ball)), centre, grain,
                              {0.48, 0.36, 0.8}, {-0.6, 0.8, 0}, 0.2, 1e-4);
    EXPECT_LT(solid.jump, 0.01) << voxels;
    shared += solid.shared;
    // the steps of the image are one voxel high
    for (const Slide& s : {flat, solid}) {
      EXPECT_GT(s.lowest, -0.6 / voxels);
      EXPECT_LT(s.highest, 0.6 / voxels);
    }
  }
  EXPECT_GT(shared, 100);  // such places were met
}

/// All round a disc of 3 diameters, in a grey picture: how far the sphere's centre is off.
TEST(GrainContact, sphere_rides_a_photographed_grain_at_its_true_height) {
  constexpr Real grain = 1.5;
  const Vec3 centre{3.03, 2.98, 3.01};
  for (const auto& [voxels, most] : {std::pair{8.0, 6e-3}, {16.0, 3e-3}}) {
    const int n = static_cast<int>(6 * voxels);
    const auto distance = [&, v = voxels](const Vec3& x) {
      return std::hypot(x.x - v * centre.x, x.y - v * centre.y) - v * grain;
    };
    const Slide s = slide(field(photographed({n, n, 1}, 1 / voxels, distance)), centre, grain,
                          {1, 0, 0}, {0, 1, 0}, 2 * std::numbers::pi * 2, 1e-3);
    std::printf("[ measured ] %2.0f voxels a diameter: %+.2f to %+.2f %% of d\n", voxels,
                100 * s.lowest, 100 * s.highest);
    EXPECT_GT(s.lowest + overlap, -most) << voxels;
    EXPECT_LT(s.highest + overlap, most) << voxels;
    EXPECT_LT(s.jump, 0.1) << voxels;  // steps ten times those above
  }
}

}  // namespace porefines::test
