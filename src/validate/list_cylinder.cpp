// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

/// The thesis's domain (fig. 15): 31.5 D x 25 D, D = 0.2 mm, centre 11.5 D from the inlet, slip sides.
Job stream_job(int re, int cells, bool steady) {
  const Real cell = 200.0 / cells;  // [um]
  return {.name = fmt::format("re_{}", re),
          .case_text =
              fmt::format(R"(title = "Cylinder, Re {}"
[run]
end_time = "0.06 s"
[geometry]
kind = "cylinders"
source = "cylinder.txt"
size = ["6.3 mm", "5 mm", "{} um"]
list_unit = "1 mm"
periodic_images = false
[grid]
cell_size = "{} um"
[fluid]
density = "1000 kg/m^3"
viscosity = "1 mPa s"
[flow]
regime = "navier-stokes"
steady = {}
inlet = {{ face = "x-", velocity = "{} m/s" }}
outlet = {{ face = "x+", pressure = "0 Pa" }}
slip = ["y-", "y+", "z-", "z+"]
reservoir = "0 m"
{}[[output]]
kind = "summary"
every = "0.04 ms"
)",
                          re, cell, cell, steady, 0.005 * re, steady ? "" : "disturbance = 0.1\n"),
          .files = {{"cylinder.txt", "2.3 2.5 0.1\n"}}};
}

/// What the same runs show besides drag: a table of its own, since Table 1 has drag alone.
Comparison wake(const std::vector<Job>& jobs) {
  Comparison c{.name = "wake",
               .folder = "cylinder",
               .title = "Wake and vortices behind a cylinder",
               .quantity = "length of the wake over the diameter; Strouhal number",
               .reference =
                   "references.md A4: independent solution in the same domain; Strouhal "
                   "number 0.164 to 0.167 (literature)",
               .jobs = jobs};
  const auto add = [&](const char* label, std::size_t job, const char* key, Real known,
                       Real tolerance) {
    c.rows.push_back({.label = label,
                      .job = job,
                      .source = FromSummary{key},
                      .reference = known,
                      .tolerance = tolerance});
  };
  add("wake, Re 10", 0, "wake_length_over_diameter", 0.261, 0.05);
  add("wake, Re 40", 2, "wake_length_over_diameter", 2.275, 0.02);
  add("Strouhal number, Re 100", 3, "body_1_strouhal", 0.1655, 0.015);
  return c;
}

}  // namespace

void add_cylinder(std::vector<Comparison>& list, bool quick) {
  Comparison c{
      .name = "cylinder",
      .title = "Flow past a cylinder (thesis, table 1)",
      .quantity = "drag coefficient 2F/(ρDU²)",
      .along = "Reynolds number",
      .reference =
          "Re 10, 40: independent solution in the thesis's domain (references.md A4); Re 20: the "
          "thesis; Re 100: "
          "mean of 1.33 to 1.40 (literature)",
      .literature = {"Su 2007", "Lima e Silva 2003", "Deng 2006", "Maniyeri 2014", "thesis"}};
  struct Known {
    int re;
    Real drag;
    Real tolerance;
    std::vector<Real> literature;
  };
  std::vector<Known> known{{10, 2.981, 0.01, {NAN, 2.81, 2.98, 2.98, 2.98}},
                           {20, 2.13, 0.02, {2.20, 2.04, 2.06, 2.16, 2.13}},
                           {40, 1.587, 0.01, {1.63, 1.54, 1.52, 1.67, 1.59}}};
  if (!quick) {
    known.push_back({100, 1.365, 0.026, {1.40, 1.39, 1.30, 1.32, 1.38}});
  }
  for (const Known& k : known) {
    const bool steady = k.re < 47;  // sheds vortices above
    c.rows.push_back(
        {.label = fmt::format("Re {}", k.re),
         .x = static_cast<Real>(k.re),
         .job = c.jobs.size(),
         .source = FromSummary{steady ? "body_1_drag_coefficient" : "body_1_mean_drag_coefficient"},
         .reference = k.drag,
         .tolerance = k.tolerance,
         .literature = k.literature});
    c.jobs.push_back(stream_job(k.re, quick || !steady ? 8 : 16, steady));
  }
  const std::vector<Job> jobs = c.jobs;
  list.push_back(std::move(c));
  if (!quick) {
    list.push_back(wake(jobs));
  }
}

}  // namespace porefines::validate
