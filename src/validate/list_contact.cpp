// SPDX-License-Identifier: MPL-2.0

#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

using Measure = FromTracks::Measure;

Job incline_job() {
  return {.name = "incline",
          .case_text = R"(title = "Rolling and sliding on an incline of 20 degrees"
gravity = ["3.35521760598 m/s^2", "0 m/s^2", "-9.21838464996 m/s^2"]
[run]
end_time = "0.1 s"
[geometry]
kind = "empty"
size = ["40 mm", "4 mm", "2 mm"]
[[particles]]
name = "ball"
source = "balls.csv"
density = "2500 kg/m^3"
young = "50 MPa"
poisson = 0.25
[contact]
friction = { particle_wall = 0.3 }
[[output]]
kind = "tracks"
every = "10 ms"
)",
          .files = {{"balls.csv",
                     "x_m,y_m,z_m,diameter_m,u,v,w\n2e-3,1e-3,0.49998e-3,1e-3,0,0,0\n"
                     "2e-3,3e-3,0.49998e-3,1e-3,0.2,0,0\n"}}};
}

Comparison incline() {
  return {
      .name = "incline",
      .title = "A ball on an incline",
      .quantity = "millimetres, metres a second",
      .reference = "rigid rolling with friction, exact",
      .jobs = {incline_job()},
      .rows = {{.label = "rolls from rest, way after 0.1 s (mm): (5/14) g sin(slope) t²",
                .source = FromTracks{0, "x_m", Measure::change, 1e3},
                .reference = 11.982920,
                .tolerance = 0.005},
               {.label = "slides, then rolls, speed after 0.1 s (m/s): (5/7) (v₀ + g sin(slope) t)",
                .source = FromTracks{1, "u_m_s", Measure::last},
                .reference = 0.382515,
                .tolerance = 0.005}}};
}

Job impact_job(Real restitution) {
  return {
      .name = fmt::format("e_{}", restitution),
      .case_text = fmt::format(R"(title = "Impact on a wall, restitution {}"
[run]
end_time = "8 ms"
[geometry]
kind = "empty"
size = ["4 mm", "4 mm", "4 mm"]
[[particles]]
source = "ball.csv"
density = "2500 kg/m^3"
young = "50 MPa"
poisson = 0.25
[contact]
restitution = {}
steps_per_contact = 400
[[output]]
kind = "tracks"
every = "1 ms"
)",
                               restitution, restitution),
      .files = {{"ball.csv", "x_m,y_m,z_m,diameter_m,u,v,w\n2e-3,2e-3,0.55e-3,1e-3,0,0,-0.02\n"}}};
}

Comparison impact() {
  Comparison c{.name = "impact",
               .title = "Rebound from a wall (Chung & Ooi 2011, test 3)",
               .quantity = "speed after over before",
               .along = "restitution asked for",
               .reference =
                   "the restitution that was asked for; 400 steps per contact (30, the default, "
                   "are 1.4 % off)"};
  for (const Real e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    c.rows.push_back({.label = fmt::format("e = {}", e),
                      .x = e,
                      .job = c.jobs.size(),
                      .source = FromTracks{0, "w_m_s", Measure::ratio, -1},
                      .reference = e,
                      .tolerance = 0.01});
    c.jobs.push_back(impact_job(e));
  }
  return c;
}

}  // namespace

void add_contact(std::vector<Comparison>& list) {
  list.push_back(incline());
  list.push_back(impact());
}

}  // namespace porefines::validate
