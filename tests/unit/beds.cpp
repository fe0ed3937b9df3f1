// SPDX-License-Identifier: MPL-2.0
// The particles that a run starts with, and the ledger that keeps count of them.
#include "sim/beds.hpp"

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "sim/ledger.hpp"
#include "support/scratch.hpp"

namespace porefines::sim {
namespace {

std::string message(const std::string& content, Real diameter = 0) {
  const test::Scratch folder;
  const std::string path = folder / "list.csv";
  write_file(path, content);
  try {
    (void)read_spheres(path, diameter);
    return "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    return text.starts_with(path) ? text.substr(path.size()) : text;
  }
}

TEST(SphereList, is_read_by_the_names_of_its_columns) {
  const test::Scratch folder;
  write_file(
      folder / "list.csv",
      "diameter_m, x_m, y_m, z_m, w, u_m_s\r\n2e-3,1,2,3,-0.5,7\n\n# remark\n4e-3,4,5,6,0,0\n");
  const auto bodies = read_spheres(folder / "list.csv", 0);
  ASSERT_EQ(bodies.size(), 2U);
  EXPECT_EQ(bodies[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(bodies[0].velocity, (Vec3{7, 0, -0.5}));
  EXPECT_EQ(bodies[0].radius, 1e-3);
  EXPECT_EQ(bodies[1].radius, 2e-3);
}

TEST(SphereList, may_leave_the_diameter_to_the_case) {
  EXPECT_EQ(message("x_m,y_m,z_m\n1,2,3\n", 1e-3), "accepted");
  EXPECT_EQ(message("x_m,y_m,z_m\n1,2,3\n"),
            ":1: there is no column diameter_m\nadd it, or give a diameter in [[particles]]");
}

TEST(SphereList, says_what_is_wrong_and_where) {
  EXPECT_EQ(
      message("x_m,y_m,z_mm,diameter_m\n"),
      ":1: unknown column z_mm; did you mean z_m?\nknown: x_m, y_m, z_m, diameter_m, u, v, w");
  EXPECT_EQ(message("x_m,y_m,diameter_m\n1,2,3\n"),
            ":1: there is no column z_m\nthe first line names the columns: x_m,y_m,z_m,diameter_m");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n1,2,3\n"), ":2: 3 values for 4 columns");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n1,2,3,1\n1,2,three,1\n"),
            ":3: \"three\" is not a number");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n1,2,nan,1\n"), ":2: \"nan\" is not a number");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n1,2,3,0\n"),
            ":2: a diameter of 0 m; it must be positive");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n1,2,3,-1e-3\n"),
            ":2: a diameter of -0.001 m; it must be positive");
  EXPECT_EQ(message("x_m,y_m,z_m,diameter_m\n"), ": holds no particles");
}

TEST(Bed, species_of_one_region_are_placed_together) {
  config::Case the_case;
  for (const auto& [name, diameter] : {std::pair{"a", 0.1}, {"b", 0.15}, {"c", 0.05}}) {
    config::Particles p;
    p.name = name;
    p.diameter.mean = diameter;
    p.count = 60;
    the_case.particles.push_back(p);
  }
  dem::Settings settings;
  settings.box = {{}, {1, 1, 1}, {true, false, false}};
  const Bed bed = make_bed(the_case, settings);
  ASSERT_EQ(bed.bodies.size(), 180U);
  for (std::size_t i = 0; i < 180; ++i) {
    const dem::Body& a = bed.bodies[i];
    EXPECT_EQ(a.id, i);
    EXPECT_EQ(a.species, i / 60);
    EXPECT_EQ(a.radius, the_case.particles[i / 60].diameter.mean / 2);
    for (std::size_t j = 0; j < i; ++j) {
      Vec3 d = a.position - bed.bodies[j].position;
      d.x -= std::round(d.x);
      EXPECT_GE(norm(d), a.radius + bed.bodies[j].radius);
    }
  }
}

TEST(Bed, fill_is_a_share_of_the_region) {
  config::Case the_case;
  config::Particles p;
  p.diameter.mean = 0.08;
  p.fill = 0.2;
  p.region = config::Region{{0.2, 0, 0}, {0.7, 1, 1}};
  the_case.particles.push_back(p);
  dem::Settings settings;
  settings.box = {{}, {1, 1, 1}, {}};
  const Bed bed = make_bed(the_case, settings);
  const Real one = 4.0 / 3 * std::acos(-1.0) * std::pow(0.04, 3);
  EXPECT_NEAR(static_cast<Real>(bed.bodies.size()) * one, 0.2 * 0.5, one / 2);
  for (const dem::Body& body : bed.bodies) {
    EXPECT_GE(body.position.x, 0.24 - 1e-12);
    EXPECT_LE(body.position.x, 0.66 + 1e-12);
  }
  the_case.particles[0].region->high[0] = 1.2;
  EXPECT_THROW((void)make_bed(the_case, settings), InputError);
}

TEST(Ledger, stops_the_run_when_a_particle_is_lost_or_found) {
  const Ledger ledger{10, 5, 3};
  EXPECT_NO_THROW(ledger.require_balance(12, 1));
  EXPECT_THROW(ledger.require_balance(11, 1), RunError);
  EXPECT_THROW(ledger.require_balance(13, 1), RunError);
  try {
    ledger.require_balance(11, 0.5);
  } catch (const RunError& error) {
    EXPECT_EQ(
        std::string(error.what()),
        "the ledger does not balance at 0.5 s: 10 placed + 5 injected - 3 out = 12, but 11 are "
        "inside\nparticles were lost: this is a defect of porefines, please report it with the "
        "case");
  }
}

}  // namespace
}  // namespace porefines::sim
