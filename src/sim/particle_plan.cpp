// SPDX-License-Identifier: MPL-2.0
#include "sim/particle_plan.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/progress.hpp"
#include "dem/packing.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

constexpr Real cycles_per_step = 6;        ///< warm solves of 131 to 827 spheres took 5 to 6
constexpr Real bytes_per_particle = 20e3;  ///< links and covered faces at 6 to 8 cells a diameter
constexpr Real bytes_per_cell = 180;       ///< throats, places of the spheres, fields of the moment
constexpr Real movie_bytes = 100e6;        ///< of the encoder
constexpr Real peak_over_mean = 3;         ///< of the speed in pores: 1.5 in a slit, 2 in a tube

Real mean_volume_of(const config::Particles& species) {
  return dem::mean_volume(dem_sizes(species.diameter));
}

Real product_of(const config::Region& region) {
  Real volume = 1;
  for (std::size_t a = 0; a < 3; ++a) {
    volume *= region.high[a] - region.low[a];
  }
  return volume;
}

Real at_start(const config::Case& the_case, const Domain& domain) {
  Real sum = 0;
  for (const config::Particles& species : the_case.particles) {
    sum += static_cast<Real>(species.count);
    if (species.fill > 0) {
      const Real volume =
          species.region ? product_of(*species.region) : domain.area() * domain.length();
      sum += species.fill * volume / mean_volume_of(species);
    }
  }
  return sum;
}

Real entering(const config::Case& the_case, const Domain& domain, Real darcy_velocity) {
  const Vec3 low = domain.origin();
  const std::vector<dem::Inlet> inlets =
      make_inlets(the_case, {low, low + domain.size(), the_case.flow.periodic});
  Real sum = 0;
  for (std::size_t k = 0; k < inlets.size(); ++k) {
    const dem::Inlet& inlet = inlets[k];
    const Real rate = inlet.by_number
                          ? inlet.rate
                          : injected_volume(the_case, the_case.injection[k], inlet.density,
                                            darcy_velocity * domain.area());
    sum += particles_entering(inlet, rate, the_case.run.end_time);
  }
  return sum;
}

}  // namespace

ParticlePlan plan_particles(const config::Case& the_case, const Domain& domain, Real porosity,
                            Real darcy_velocity, Real seconds_per_cycle) {
  ParticlePlan plan;
  plan.diameter = INFINITY;
  for (const config::Particles& species : the_case.particles) {
    if (species.diameter.mean > 0) {
      plan.diameter = std::min(plan.diameter, species.diameter.mean);
    }
  }
  plan.at_start = at_start(the_case, domain);
  plan.entering = entering(the_case, domain, darcy_velocity);
  const Real fastest = peak_over_mean * darcy_velocity / std::max(porosity, 1e-3);
  const Real way =
      the_case.coupling.travel * std::min({domain.spacing.x, domain.spacing.y, domain.spacing.z});
  constexpr Real fewest = 100;  // samples of series.csv end a step
  plan.steps = std::max(the_case.run.end_time * fastest / way, fewest);
  const bool films = config::find_output(the_case, config::OutputKind::movie) != nullptr;
  plan.memory = bytes_per_particle * (plan.at_start + plan.entering) +
                bytes_per_cell * static_cast<Real>(product(domain.cells)) +
                (films ? movie_bytes : 0);
  plan.seconds = plan.steps * cycles_per_step * seconds_per_cycle;
  return plan;
}

std::vector<std::string> describe(const ParticlePlan& plan, const Domain& domain) {
  std::vector<std::string> lines;
  const std::string size = std::isfinite(plan.diameter)
                               ? fmt::format("{:.3g} um = {:.1f} cells, ", 1e6 * plan.diameter,
                                             plan.diameter / domain.spacing.x)
                               : "";
  lines.push_back(fmt::format("fines      {}{:.0f} at the start, about {:.0f} to enter", size,
                              plan.at_start, plan.entering));
  lines.push_back(
      fmt::format("steps      about {:.0f}, {} in all", plan.steps, format_duration(plan.seconds)));
  if (std::isfinite(plan.diameter) && plan.diameter < 4 * domain.spacing.x) {
    lines.push_back(
        fmt::format("warning: fines of less than 4 cells are not resolved; grid.cell_size = "
                    "\"{:.3g} um\" resolves these",
                    1e6 * plan.diameter / 6));
  }
  return lines;
}

}  // namespace porefines::sim
