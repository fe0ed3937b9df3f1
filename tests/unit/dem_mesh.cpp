// SPDX-License-Identifier: MPL-2.0
#include <filesystem>
#include <fstream>
#include <random>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "dem/surface.hpp"
#include "support/shapes.hpp"

namespace porefines::dem {

namespace {

using geom::Triangle;
using test::ball_mesh;
using test::quad;

TouchList touches(const Mesh& mesh, const Vec3& centre, Real radius, Real reach) {
  TouchList out;
  find_touches(mesh, centre, radius, reach, out);
  return out;
}

/// A plane z = 0 over [0, 1]^2 cut into triangles with displaced inner corners.
std::vector<Triangle> crumbled_plane(int n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> uniform(-0.3F, 0.3F);
  std::vector<std::array<float, 3>> p;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const bool inner = i > 0 && j > 0 && i < n && j < n;
      const auto h = 1 / static_cast<float>(n);
      p.push_back({h * (static_cast<float>(i) + (inner ? uniform(random) : 0)),
                   h * (static_cast<float>(j) + (inner ? uniform(random) : 0)), 0});
    }
  }
  std::vector<Triangle> out;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i + (n + 1) * j);
      const auto up = at + static_cast<std::size_t>(n) + 1;
      out.push_back({p[at], p[at + 1], p[up + 1]});
      out.push_back({p[at], p[up + 1], p[up]});
    }
  }
  return out;
}

std::string message_of(const std::string& path) {
  try {
    (void)read_stl(path, 1);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST(Mesh, coplanar_triangles_touch_once_wherever_the_sphere_is) {
  const auto triangles = crumbled_plane(12);
  const Mesh mesh = make_mesh(triangles, 0.2);
  EXPECT_FALSE(mesh.closed);
  std::mt19937 random(2);
  std::uniform_real_distribution<Real> uniform(0, 1);
  for (int trial = 0; trial < 5000; ++trial) {
    Vec3 c{uniform(random), uniform(random), 0.15};
    if (trial % 3 == 0) {  // right above a corner or the middle of an edge
      const Triangle& t = triangles[random() % triangles.size()];
      const float w = trial % 2 == 0 ? 1 : 0.5F;
      c.x = w * t[0][0] + (1 - w) * t[1][0];
      c.y = w * t[0][1] + (1 - w) * t[1][1];
    }
    const TouchList found = touches(mesh, c, 0.16, 0);
    ASSERT_EQ(found.count, 1);
    EXPECT_NEAR(found.touch[0].gap, -0.01, 1e-12);
    EXPECT_NEAR(found.touch[0].normal.z, 1, 1e-12);
    EXPECT_EQ(found.touch[0].share, 1);
  }
  EXPECT_NEAR(touches(mesh, {0.5, 0.5, -0.15}, 0.16, 0).touch[0].normal.z, -1, 1e-12);  // a sheet
  EXPECT_EQ(touches(mesh, {0.5, 0.5, 0.17}, 0.16, 0).count, 0);
  EXPECT_EQ(touches(mesh, {1.1, 0.5, 0.1}, 0.16, 0).count, 1);  // over its border
}

TEST(Mesh, box_from_outside_and_inside) {
  for (const bool hollow : {false, true}) {
    const Mesh mesh = make_mesh(test::box_mesh({0, 0, 0}, {1, 2, 3}, hollow), 0.3);
    EXPECT_TRUE(mesh.closed);
    EXPECT_EQ(mesh.face.size(), 12U);
    EXPECT_EQ(mesh.vertex.size(), 8U);
    std::mt19937 random(3);
    std::uniform_real_distribution<Real> uniform(-0.4, 1.4);
    for (int trial = 0; trial < 4000; ++trial) {
      const Vec3 c{uniform(random), 2 * uniform(random), 3 * uniform(random)};
      const Vec3 nearest{std::clamp<Real>(c.x, 0, 1), std::clamp<Real>(c.y, 0, 2),
                         std::clamp<Real>(c.z, 0, 3)};
      const bool is_within = c == nearest;
      const TouchList found = touches(mesh, c, 0.25, 0.01);
      if (is_within != hollow) {
        EXPECT_TRUE(found.inside || found.count == 0);
        continue;
      }
      int expected = 0;
      if (hollow) {
        for (int axis = 0; axis < 3; ++axis) {
          expected += c[axis] < 0.26 ? 1 : 0;
          expected += (axis + 1) - c[axis] < 0.26 ? 1 : 0;
        }
      } else {
        expected = norm(c - nearest) < 0.26 ? 1 : 0;
      }
      ASSERT_EQ(found.count, expected);
      if (!hollow && expected == 1) {
        EXPECT_NEAR(found.touch[0].gap, norm(c - nearest) - 0.25, 1e-6);
        EXPECT_GT(dot(found.touch[0].normal, c - nearest), 0.99999 * norm(c - nearest));
      }
    }
  }
}

TEST(Mesh, force_on_a_sphere_in_a_bowl_of_facets_is_continuous) {
  const Mesh bowl = make_mesh(ball_mesh({0, 0, 0}, 3, 12, true), 1.1);
  Vec3 last;
  Real jump = 0;
  int shared = 0;
  for (Real angle = 0; angle < 1; angle += 2e-5) {
    const Vec3 e{std::cos(angle) * 0.8, std::sin(angle) * 0.8, 0.6};
    const TouchList found = touches(bowl, (3 - 1 + 0.02) * e, 1, 0);
    Vec3 force;
    for (const Touch& t : found.view()) {
      force += t.share * std::pow(-t.gap / 0.05, 1.5) * t.normal;
    }
    jump = angle > 0 ? std::max(jump, norm(force - last)) : 0;
    shared += found.count > 1 ? 1 : 0;
    last = force;
  }
  EXPECT_GT(shared, 1000);
  EXPECT_LT(jump, 0.01);
}

TEST(Mesh, files_binary_and_ascii_and_wrong_ones) {
  const auto folder = std::filesystem::temp_directory_path() / "porefines_dem_mesh";
  std::filesystem::create_directories(folder);
  const std::string path = (folder / "ball.stl").string();
  const auto ball = ball_mesh({1, 2, 3}, 0.5, 6, false);
  geom::write_stl(path, ball);
  const auto back = read_stl(path, 1e-3);
  ASSERT_EQ(back.size(), ball.size());
  EXPECT_FLOAT_EQ(back[7][1][2], 1e-3F * ball[7][1][2]);
  std::filesystem::resize_file(path, 200);
  EXPECT_NE(message_of(path).find("announces"), std::string::npos);
  const std::string text = (folder / "text.stl").string();
  std::ofstream(text) << "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                         "vertex 0 1e0 0\nendloop\nendfacet\nendsolid a\n";
  ASSERT_EQ(read_stl(text, 1).size(), 1U);
  EXPECT_EQ(read_stl(text, 2)[0][1][0], 2);
  std::ofstream(text) << "solid a\nvertex 0 0 0\nvertex 1 0 zero\n";
  EXPECT_NE(message_of(text).find("three numbers"), std::string::npos);
  std::ofstream(text) << "solid a\nvertex 0 0 0\n";
  EXPECT_NE(message_of(text).find("ends within"), std::string::npos);
  std::ofstream(text) << "solid a\nendsolid\n";
  EXPECT_NE(message_of(text).find("no triangles"), std::string::npos);
  EXPECT_NE(message_of((folder / "none.stl").string()).find("cannot be opened"), std::string::npos);
  EXPECT_THROW((void)make_mesh({Triangle{}}, 1), InputError);
  const float nan = std::nanf("");
  EXPECT_THROW((void)make_mesh({Triangle{{{0, 0, 0}, {1, 0, 0}, {0, nan, 0}}}}, 1), InputError);
  EXPECT_EQ(make_mesh({quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0})[0], Triangle{}}, 1).dropped, 1);
}

}  // namespace porefines::dem
