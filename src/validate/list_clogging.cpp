// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "validate/comparison.hpp"
#include "validate/read_cake.hpp"
#include "validate/read_result.hpp"
#include "validate/shipped.hpp"

namespace porefines::validate {
namespace {

/// One seed of cases/throat/bridging.toml, four cells a diameter [um].
Job bridging(const std::string& name, Real diameter, int seed,
             const std::vector<std::string>& more = {}) {
  std::vector<std::string> set{
      fmt::format("particles=[{{name=\"latex\", diameter=\"{} um\"}}]", diameter),
      fmt::format("grid.cell_size={} um", diameter / 4), fmt::format("run.random_seed={}", seed)};
  set.insert(set.end(), more.begin(), more.end());
  return shipped_job(name, "throat", "bridging.toml", {"funnel.txt"}, set);
}

Real summary_of(const std::string& folder, const char* key) {
  return number_in(folder + "/out/summary.json", key);
}

/// Runs whose throat clogged, over all.
Source share_clogged(std::size_t runs) {
  return Computed{[=](Folders folders) {
    Real clogged = 0;
    for (std::size_t k = 0; k < runs; ++k) {
      clogged += summary_of(folders[k], "clogged_throats");
    }
    return clogged / static_cast<Real>(runs);
  }};
}

/// Standard deviation over mean of those that passed before the clog: 1 for an exponential law.
Source spread_of_escapees(std::size_t runs) {
  return Computed{[=](Folders folders) {
    Real sum = 0;
    Real squares = 0;
    for (std::size_t k = 0; k < runs; ++k) {
      const Real out = summary_of(folders[k], "particles_out");
      sum += out, squares += out * out;
    }
    const auto n = static_cast<Real>(runs);
    return std::sqrt((squares - sum * sum / n) / (n - 1)) / (sum / n);
  }};
}

Comparison throats(bool quick) {
  const std::size_t seeds = quick ? 3 : 20;
  Comparison c{.name = "throats",
               .title = "One throat: sieving, arches, free passage",
               .quantity = "share of runs that clog; fines that passed",
               .reference =
                   "references.md E: wider than the throat is sieved at once (Sauret et al. "
                   "2014); arches by chance below three diameters, escapees exponential, "
                   "none above (Marin et al. 2018)"};
  c.jobs.push_back(shipped_job("sieved", "throat", "case.toml", {"fine.csv", "pillars.txt"}, {}));
  c.rows.push_back(
      {.label = "throat 0.9 diameters wide: clogs", .source = share_clogged(1), .reference = 1});
  c.rows.push_back({.label = "throat 0.9 diameters wide: passed",
                    .source = FromSummary{"particles_out"},
                    .reference = 0});
  const std::size_t arches = c.jobs.size();
  for (std::size_t seed = 1; seed <= seeds; ++seed) {
    c.jobs.push_back(bridging(fmt::format("arch_{}", seed), 16.0 / 3, static_cast<int>(seed)));
  }
  c.rows.push_back({.label = fmt::format("1.5 diameters wide, {} seeds: clog", seeds),
                    .job = arches,
                    .source = share_clogged(seeds),
                    .reference = 1});
  if (!quick) {
    c.rows.push_back(
        {.label = "1.5 diameters wide: standard deviation over mean of those that passed before",
         .job = arches,
         .source = spread_of_escapees(seeds),
         .reference = 1,
         .tolerance = 0.45});
    c.rows.push_back({.label = "3.5 diameters wide: clogs",
                      .job = c.jobs.size(),
                      .source = share_clogged(1),
                      .reference = 0});
    c.jobs.push_back(bridging("free", 8 / 3.5, 1, {"run.end_time=60 ms"}));
  }
  return c;
}

/// cases/filter_cake once the sieve is covered.
Comparison cake() {
  constexpr CakeFeed feed{.velocity = 1e-3, .viscosity = 1e-3, .diameter = 10e-6};
  constexpr Real fed = 0.1;  // volume fraction
  const auto grown = [=](Folders folders) {
    return cake_growth(folders[0] + "/out", feed, 0.22, 0.32);
  };
  return {
      .name = "cake",
      .title = "A filter cake grows on a sieve",
      .quantity = "over the prediction, with the solid share of the cake as it is",
      .reference = "references.md E: dL/dt = φ/(φ_m - φ) q; resistance by Kozeny and Carman",
      .jobs = {shipped_job("pumped", "filter_cake", "case.toml", {"sieve.txt"}, {})},
      .rows = {{.label = "solid share of the cake over 0.57 (loose random packing 0.55 to 0.60)",
                .source = Computed{[=](Folders folders) { return grown(folders).share / 0.57; }},
                .reference = 1,
                .tolerance = 0.06},
               {.label = "speed of its front",
                .source = Computed{[=](Folders folders) {
                  const CakeGrowth found = grown(folders);
                  return found.front / (fed * feed.velocity / (found.share - fed));
                }},
                .reference = 1,
                .tolerance = 0.15},
               {.label = "resistance of what was added",
                .source = Computed{[=](Folders folders) {
                  const CakeGrowth found = grown(folders);
                  return found.resistance / kozeny_carman(found.share, feed.diameter);
                }},
                .reference = 1,
                .tolerance = 0.3}}};
}

}  // namespace

void add_clogging(std::vector<Comparison>& list, bool quick) {
  list.push_back(throats(quick));
  if (!quick) {
    list.push_back(cake());
  }
}

}  // namespace porefines::validate
