// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "validate/comparison.hpp"
#include "validate/read_track.hpp"

namespace porefines::validate {
namespace {

constexpr Real pi = std::numbers::pi;

/// Head on, test 1; on a rigid plane, test 2. Rows every step, 400 in a contact.
struct Hit {
  const char* name;
  const char* title;
  Real radius;   ///< [m]
  Real density;  ///< [kg/m^3]
  Real speed;    ///< [m/s] of one
  Real young;    ///< [Pa]
  Real poisson;
  bool pair;                      ///< two that meet, or one and a plane
  Real overlap, force, duration;  ///< [m], [N], [s] exact, Hertz theory
};

const std::array<Hit, 2> hits{Hit{"glass", "Two glass spheres meet", 0.010, 2800, 10, 48e9, 0.20,
                                  true, 274.1127e-6, 10.69689e3, 40.3395e-6},
                              Hit{"aluminium", "An aluminium sphere on a rigid plane", 0.1, 2699,
                                  0.2, 70e9, 0.30, false, 49.7172e-6, 11.36986e3, 731.657e-6}};

/// The spheres start a ten-thousandth of a radius apart.
Job hit_job(const Hit& hit) {
  const Real r = hit.radius;
  const Real gap = 1e-4 * r;
  std::string list = "x_m,y_m,z_m,diameter_m,u_m_s,v_m_s,w_m_s\n";
  const auto add = [&](Real z, Real w) {
    list += fmt::format("{0},{0},{1:.12g},{2},0,0,{3}\n", 3 * r, z, 2 * r, w);
  };
  add(r + gap + (hit.pair ? 2 * r : 0), -hit.speed);
  if (hit.pair) {
    add(r, hit.speed);
  }
  // The stiffest wall that a case may have gives way by 0.7 %: that much is given back to the sphere.
  constexpr Real wall = 1e13;
  const Real young = hit.pair ? hit.young : 1 / (1 / hit.young - 1 / wall);
  const Real end = 1.5 * hit.duration + gap / hit.speed;
  return {.name = hit.name,
          .case_text = fmt::format(
              R"(title = "{title}"
[run]
end_time = "{end} s"
[geometry]
kind = "empty"
size = ["{side} m", "{side} m", "{side} m"]
[[particles]]
source = "balls.csv"
density = "{density} kg/m^3"
young = "{young} Pa"
poisson = {poisson}
[contact]
restitution = 1
max_overlap = 0.05
wall_young = "{wall} Pa"
steps_per_contact = 400
[[output]]
kind = "tracks"
every = "{every} s"
)",
              fmt::arg("title", hit.title), fmt::arg("end", end), fmt::arg("side", 6 * r),
              fmt::arg("density", hit.density), fmt::arg("young", young), fmt::arg("wall", wall),
              fmt::arg("poisson", hit.poisson), fmt::arg("every", hit.duration / 400)),
          .files = {{"balls.csv", list}}};
}

Impact read_impact(const Hit& hit, const std::string& folder) {
  const Track one = read_track(folder + "/out", 0);
  const Track two = hit.pair ? read_track(folder + "/out", 1) : Track{};
  std::vector<Real> distance;
  std::vector<Real> speed;
  for (std::size_t i = 0; i < one.time.size(); ++i) {
    distance.push_back(one.position[i].z - (hit.pair ? two.position[i].z : 0));
    speed.push_back(one.velocity[i].z);
  }
  const Real mass = hit.density * 4 / 3 * pi * hit.radius * hit.radius * hit.radius;
  return impact_of(one.time, distance, speed, (hit.pair ? 2 : 1) * hit.radius, mass);
}

Comparison hertz() {
  Comparison c{.name = "hertz",
               .title = "Elastic impacts (Chung & Ooi 2011, tests 1 and 2)",
               .quantity = "over the exact one",
               .reference = "references.md C: Hertz theory, exact; 400 steps in a contact"};
  for (const Hit& hit : hits) {
    const auto add = [&](const char* what, Real Impact::*member, Real exact) {
      c.rows.push_back({.label = fmt::format("{}: {}", hit.title, what),
                        .job = c.jobs.size(),
                        .source = Computed{[&hit, member, exact](const auto& folders) {
                          return read_impact(hit, folders[0]).*member / exact;
                        }},
                        .reference = 1,
                        .tolerance = 0.005});
    };
    add("largest overlap", &Impact::overlap, hit.overlap);
    add("largest force", &Impact::force, hit.force);
    add("duration", &Impact::duration, hit.duration);
    c.jobs.push_back(hit_job(hit));
  }
  return c;
}

// Test 4: aluminium oxide on aluminium alloy.
constexpr Real speed = 3.9;      // [m/s]
constexpr Real radius = 2.5e-3;  // [m]
constexpr Real friction = 0.092;
constexpr Real restitution = 0.98;

Job oblique_job(Real degrees) {
  const Real angle = degrees * pi / 180;
  return {.name = fmt::format("{}_degrees", degrees),
          .case_text = fmt::format(R"(title = "Oblique impact, {} degrees from the normal"
[run]
end_time = "30 us"
[geometry]
kind = "empty"
size = ["40 mm", "40 mm", "40 mm"]
[[particles]]
source = "ball.csv"
density = "4000 kg/m^3"
young = "380 GPa"
poisson = 0.23
[contact]
restitution = {}
friction = {}
wall_young = "70 GPa"
wall_poisson = 0.33
steps_per_contact = 400
[[output]]
kind = "tracks"
every = "10 us"
)",
                                   degrees, restitution, friction),
          .files = {{"ball.csv", fmt::format("x_m,y_m,z_m,diameter_m,u_m_s,v_m_s,w_m_s\n"
                                             "20e-3,20e-3,2.50025e-3,5e-3,{:.12g},0,{:.12g}\n",
                                             speed * std::sin(angle), -speed * std::cos(angle))}}};
}

Comparison oblique() {
  Comparison c{.name = "oblique",
               .title = "Oblique impacts that slide (Chung & Ooi 2011, test 4)",
               .quantity = "tangential restitution and spin over the exact one",
               .along = "degrees from the normal",
               .reference =
                   "references.md C: e_t = 1 - μ(1 + e_n)/tan θ, ω = (5/2) μ(1 + e_n) V "
                   "cos θ/r, exact where it slides throughout"};
  for (const Real degrees : {40.0, 50.0, 60.0, 70.0, 80.0, 85.0}) {
    const Real angle = degrees * pi / 180;
    const Real kick = friction * (1 + restitution);
    c.rows.push_back({.label = fmt::format("e_t at {}°", degrees),
                      .x = degrees,
                      .job = c.jobs.size(),
                      .source = FromTracks{0, "u_m_s", FromTracks::Measure::ratio},
                      .reference = 1 - kick / std::tan(angle),
                      .tolerance = 0.005});
    const Real spin = 2.5 * kick * speed * std::cos(angle) / radius;
    c.rows.push_back({.label = fmt::format("ω at {}°", degrees),
                      .x = degrees,
                      .job = c.jobs.size(),
                      .source = FromTracks{0, "wy_rad_s", FromTracks::Measure::last, 1 / spin},
                      .reference = 1,
                      .tolerance = 0.005});
    c.jobs.push_back(oblique_job(degrees));
  }
  return c;
}

}  // namespace

void add_impacts(std::vector<Comparison>& list) {
  list.push_back(hertz());
  list.push_back(oblique());
}

}  // namespace porefines::validate
