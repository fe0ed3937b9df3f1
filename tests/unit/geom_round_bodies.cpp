// SPDX-License-Identifier: MPL-2.0
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/round_bodies.hpp"
#include "geom/solid.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace {

std::vector<Body> random_bodies(int count, Real radius) {
  std::mt19937 random(5);
  std::uniform_real_distribution<Real> uniform(0, 1);
  std::vector<Body> bodies;
  for (int b = 0; b < count; ++b) {
    bodies.push_back(
        {{uniform(random), uniform(random), uniform(random)}, radius * (0.3 + uniform(random))});
  }
  return bodies;
}

std::string message_of(const std::string& path, int dims) {
  try {
    (void)read_bodies(path, dims, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string write(const std::string& name, const std::string& text) {
  const auto path = support::scratch("bodies") / name;
  std::ofstream(path) << text;
  return path.string();
}

}  // namespace

TEST(RoundBodies, distance_equals_brute_force_over_bodies_and_images) {
  const auto bodies = random_bodies(200, 0.06);
  const SampleBox box{{1, 1, 1}, {Beyond::periodic, Beyond::mirror, Beyond::pore}};
  const SphereList list(bodies, box, true, 0.1);
  std::mt19937 random(6);
  std::uniform_real_distribution<Real> uniform(-0.3, 1.3);
  for (int trial = 0; trial < 3000; ++trial) {
    const Vec3 x{uniform(random), uniform(random), uniform(random)};
    const Real y = x.y < 0 ? -x.y : x.y > 1 ? 2 - x.y : x.y;
    Real exact = 0.1;
    for (const Body& body : bodies) {
      for (int shift = -2; shift <= 2; ++shift) {
        const Vec3 d = Vec3{x.x, y, x.z} - body.centre - Vec3{1.0 * shift, 0, 0};
        exact = std::min(exact, norm(d) - body.radius);
      }
    }
    ASSERT_NEAR(list.signed_distance(x), std::max(exact, -0.1), 1e-12);
  }
}

TEST(RoundBodies, without_images_a_grain_ends_at_a_periodic_face) {
  const std::vector<Body> bodies{{{0.05, 0.5, 0.5}, 0.1}};
  const SampleBox box{{1, 1, 1}, {Beyond::periodic, Beyond::periodic, Beyond::periodic}};
  const Vec3 behind{0.98, 0.5, 0.5};
  EXPECT_NEAR(SphereList(bodies, box, true, 0.2).signed_distance(behind), -0.03, 1e-12);
  EXPECT_NEAR(SphereList(bodies, box, false, 0.2).signed_distance(behind), 0.2, 1e-12);
}

TEST(RoundBodies, cylinders_ignore_z_and_normals_point_into_the_pore) {
  const std::vector<Body> bodies{{{0.5, 0.5, 0}, 0.2}};
  const Solid solid = CylinderList(bodies, {{1, 1, 1}, {}}, true, 0.25);
  EXPECT_NEAR(signed_distance(solid, {0.8, 0.5, 0.9}), 0.1, 1e-12);
  EXPECT_NEAR(band_of(solid), 0.25, 1e-15);
  const Vec3 n = normal(solid, {0.5, 0.8, 0.4}, 1e-3);
  EXPECT_NEAR(n.y, 1, 1e-6);
  EXPECT_NEAR(n.z, 0, 1e-12);
}

TEST(ReadBodies, takes_headers_comments_and_units) {
  const auto path = write("list.txt",
                          "Number of Spheres: 2\nDomain: 1, 1, 1\n# x y z r\n\n"
                          "1 2 3 0.5\n 4,5e-1;6\t1.5 # the second\n");
  const auto bodies = read_bodies(path, 3, 1e-3);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_DOUBLE_EQ(bodies[1].centre.y, 0.5e-3);
  EXPECT_DOUBLE_EQ(bodies[1].radius, 1.5e-3);
}

TEST(ReadBodies, names_the_line_of_a_bad_row) {
  EXPECT_NE(message_of(write("a", "1 2 3 4\n1 2 x 4\n"), 3).find(":2:"), std::string::npos);
  EXPECT_NE(message_of(write("b", "1 2 3 4\n\n1 2 3\n"), 3).find(":3:"), std::string::npos);
  EXPECT_NE(message_of(write("c", "1 2 3 -4\n"), 3).find("radius"), std::string::npos);
  EXPECT_NE(message_of(write("d", "1 2 3\n4 5 6\n"), 3).find("line 1"), std::string::npos);
  EXPECT_NE(message_of("/nowhere/list", 3).find("/nowhere/list"), std::string::npos);
}

TEST(ReadBodies, porosity_of_a_real_pack_is_the_published_one) {
  const std::string path = support::shared_file("packs/spheres_1896.txt");
  if (path.empty()) {
    GTEST_SKIP() << "needs ../shared/data/packs/spheres_1896.txt (or PF_SHARED)";
  }
  const auto bodies = read_bodies(path, 3, 1);
  ASSERT_EQ(bodies.size(), 1896U);
  const SphereList list(bodies, {{1, 1, 1}, {}}, true, 0.02);
  Index pores = 0;
  constexpr int n = 60;
  for (int v = 0; v < n * n * n; ++v) {
    const Vec3 x{(v % n + 0.5) / n, (v / n % n + 0.5) / n, (v / n / n + 0.5) / n};
    pores += list.signed_distance(x) > 0 ? 1 : 0;
  }
  EXPECT_NEAR(static_cast<Real>(pores) / (n * n * n), 0.36, 0.01);
}

}  // namespace porefines::geom
