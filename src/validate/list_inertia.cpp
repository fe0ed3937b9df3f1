// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validate/comparison.hpp"
#include "validate/read_track.hpp"
#include "validate/shipped.hpp"

namespace porefines::validate {
namespace {

Job fall(const std::string& name, const std::vector<std::string>& set) {
  return shipped_job(name, "settling_sphere", "case.toml", {"sphere.csv"}, set);
}

Comparison settling(bool quick) {
  Comparison c{.name = "settling",
               .title = "A sphere settles in a box (ten Cate et al. 2002)",
               .quantity = "largest speed over the terminal one in an unbounded fluid",
               .reference =
                   "references.md B7; its two digitised figures differ by 3 to 5 %. At Re 1.5 the "
                   "sphere reaches 0.9345 without any inertia, already below the experiment"};
  const auto add = [&](const std::string& label, Real terminal, Real measured, Job job) {
    c.rows.push_back({.label = label,
                      .job = c.jobs.size(),
                      .source = Computed{[=](Folders folders) {
                        return peak_fall(read_track(folders[0] + "/out", 0)) / terminal;
                      }},
                      .reference = measured,
                      .tolerance = 0.05});
    c.jobs.push_back(std::move(job));
  };
  add("Re 31.9, 6 cells a diameter", 0.128, 0.955, fall("fast", {}));
  if (!quick) {
    add("Re 31.9, 12 cells a diameter", 0.128, 0.955,
        fall("fast_fine", {"grid.cell_size=1.25 mm"}));
    add("Re 1.5, 6 cells a diameter", 0.038, 0.947,
        fall("slow",
             {"fluid.density=970 kg/m^3", "fluid.viscosity=0.373 Pa s", "run.end_time=4 s"}));
  }
  return c;
}

/// St = (rho_p + rho_f/2) u d/(9 mu)
Comparison wet_impact() {
  Comparison c{.name = "wet_impact",
               .title = "Rebound from a wall in a liquid, a tenth of a diameter from it",
               .quantity = "speed after over before",
               .along = "Stokes number",
               .reference =
                   "references.md B8: none below St of about 10 (Gondret et al. 2002); "
                   "above 0.97 exp(-35/St) (Legendre et al. 2005)"};
  struct Known {
    int stokes;
    const char* viscosity;
    Real restitution;
    Real tolerance;
  };
  for (const Known& known : {Known{8, "125 mPa s", 0, 0},
                             {54, "20 mPa s", 0.507, 0.1},
                             {114, "10 mPa s", 0.714, 0.07}}) {
    c.rows.push_back({.label = fmt::format("St = {}", known.stokes),
                      .x = static_cast<Real>(known.stokes),
                      .job = c.jobs.size(),
                      .source = Computed{[](Folders folders) {
                        return rebound(read_track(folders[0] + "/out", 0), 2.4e-3);
                      }},
                      .reference = known.restitution,
                      .tolerance = known.tolerance});
    c.jobs.push_back(shipped_job(fmt::format("st_{}", known.stokes), "wet_impact", "case.toml",
                                 {"sphere.csv"},
                                 {fmt::format("fluid.viscosity={}", known.viscosity)}));
  }
  return c;
}

/// Share of the tube's radius at which the sphere of cases/tube_migration ends.
Real place_in_tube(Folders folders) {
  const Track track = read_track(folders[0] + "/out", 0);
  constexpr Real centre = 1.6e-3;
  constexpr Real tube = 1.5e-3;
  return track.position.empty()
             ? NAN
             : std::hypot(track.position.back().x - centre, track.position.back().y - centre) /
                   tube;
}

Comparison migration() {
  Comparison c{.name = "migration",
               .title = "A neutral sphere in a tube, Re 40",
               .quantity = "place over the tube's radius at the end",
               .reference = "references.md B9: about 0.6 (Segré & Silberberg 1962)"};
  for (const auto& [label, file] :
       {std::pair{"from 0.50", "inside.csv"}, std::pair{"from 0.68", "outside.csv"}}) {
    c.rows.push_back({.label = label,
                      .job = c.jobs.size(),
                      .source = Computed{place_in_tube},
                      .reference = 0.6,
                      .tolerance = 0.08});
    c.jobs.push_back(shipped_job(file, "tube_migration", "case.toml", {"tube.png", file},
                                 {fmt::format("particles.0.source={}", file)}));
  }
  return c;
}

/// Phases of cases/tumbling that came, each after the one before.
Real phases_in_order(Folders folders) {
  const std::string out = folders[0] + "/out";
  const Phases found = phases(read_track(out, 0), read_track(out, 1), 1.0 / 600);
  const std::array<Real, 3> times{found.drafting, found.kissing, found.tumbling};
  Real count = 0;
  for (Real last = 0; const Real time : times) {
    count += time > last ? 1 : 0;
    last = std::max(last, time);
  }
  return count;
}

Comparison tumbling() {
  return {.name = "tumbling",
          .title = "Drafting, kissing, tumbling",
          .quantity = "phases in their order",
          .reference = "references.md B10; Glowinski et al. 2001, 6 cells a diameter",
          .jobs = {shipped_job("pair", "tumbling", "case.toml", {"spheres.csv"}, {})},
          .rows = {{.label = "phases seen", .source = Computed{phases_in_order}, .reference = 3}}};
}

}  // namespace

void add_inertia(std::vector<Comparison>& list, bool quick) {
  list.push_back(wet_impact());
  list.push_back(settling(quick));
  if (!quick) {
    list.push_back(tumbling());
    list.push_back(migration());
  }
}

}  // namespace porefines::validate
