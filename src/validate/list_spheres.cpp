// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

constexpr Real gradient = 2e4;    // [Pa/m]
constexpr Real viscosity = 1e-3;  // [Pa s]
constexpr Real diameter = 5e-6;   // [m]
constexpr Real cell = 0.625e-6;   // [m] eight to a diameter

/// A neutrally buoyant fine between plates, `gap` and its height in radii.
Job between_plates(const std::string& name, Real gap, Real height) {
  const Real h = gap * diameter / 2;
  Job job;
  job.name = name;
  job.case_text = fmt::format(R"(title = "A free sphere in a slit, H/a = {gap}"
[run]
end_time = "4 ms"
[geometry]
kind = "empty"
size = ["60 um", "40 um", "{height} um"]
[grid]
cells = [96, 64, {cells}]
[fluid]
density = "1050 kg/m^3"
viscosity = "1 mPa s"
[flow]
periodic = ["x", "y"]
pressure_gradient = ["2e4 Pa/m", "0 Pa/m", "0 Pa/m"]
walls = ["z-", "z+"]
[[particles]]
source = "fine.csv"
density = "1050 kg/m^3"
[[output]]
kind = "tracks"
every = "2 ms"
)",
                              fmt::arg("gap", gap), fmt::arg("height", h * 1e6),
                              fmt::arg("cells", std::lround(h / cell)));
  job.files = {{"fine.csv", fmt::format("x_m,y_m,z_m,diameter_m\n20e-6,20e-6,{:.10g},5e-6\n",
                                        height * diameter / 2)}};
  return job;
}

/// [m/s] peak of the clean flow
Real peak(Real gap) {
  const Real h = gap * diameter / 2;
  return gradient * h * h / (8 * viscosity);
}

/// [1/s] half of its shear at a height
Real half_shear(Real gap, Real height) {
  return gradient / (4 * viscosity) * (gap - 2 * height) * diameter / 2;
}

Comparison free_sphere() {
  using Measure = FromTracks::Measure;
  const auto speed = [](Real gap) { return FromTracks{0, "u_m_s", Measure::last, 1 / peak(gap)}; };
  return {.name = "free_sphere",
          .title = "A fine carried between the plates of a chip",
          .quantity = "speed over the peak of the clean flow; spin over half of its shear",
          .reference = "references.md B3: free of force and torque in Poiseuille flow, exact",
          .jobs = {between_plates("centre", 8, 4), between_plates("low", 8, 1.5),
                   between_plates("wide", 10, 5)},
          .rows = {{.label = "speed, H/a = 8, centre, 8 cells per diameter",
                    .job = 0,
                    .source = speed(8),
                    .reference = 0.97903,
                    .tolerance = 0.005},
                   {.label = "speed, H/a = 8, z/a = 1.5",
                    .job = 1,
                    .source = speed(8),
                    .reference = 0.54991,
                    .tolerance = 0.005},
                   {.label = "spin, H/a = 8, z/a = 1.5",
                    .job = 1,
                    .source = FromTracks{0, "wy_rad_s", Measure::last, 1 / half_shear(8, 1.5)},
                    .reference = 0.9232,
                    .tolerance = 0.02},
                   {.label = "speed, H/a = 10, centre",
                    .job = 2,
                    .source = speed(10),
                    .reference = 0.98662,
                    .tolerance = 0.005}}};
}

}  // namespace

void add_spheres(std::vector<Comparison>& list) {
  list.push_back(free_sphere());
}

}  // namespace porefines::validate
