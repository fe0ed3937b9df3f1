// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <fmt/format.h>

#include "surface/adhesion.hpp"
#include "surface/collector.hpp"
#include "surface/force_law.hpp"
#include "surface/landmarks.hpp"
#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

using surface::Solution;

/// A row that no run is needed for.
Row law(const std::string& label, Real value, Real reference, Real tolerance) {
  return {.label = label,
          .source = Computed{[value](const auto& /*folders*/) { return value; }},
          .reference = reference,
          .tolerance = tolerance};
}

constexpr Real nm = 1e-9;
constexpr Real radius = 2.5e-6;

constexpr Solution water(Real millimolar) {
  return {.temperature = 298.15, .permittivity = 78.4, .ionic_strength = millimolar};
}

/// Sphere and plate, A = 1e-20 J, zeta -40 and -30 mV, 10 mM, 25 degrees.
Comparison colloids() {
  const surface::ForceLaw dlvo = make_force_law(
      water(10), {.hamaker = 1e-20, .wavelength = 100 * nm, .zeta1 = -0.040, .zeta2 = -0.030});
  const Real kt = surface::thermal_energy(298.15);
  Comparison c{.name = "colloids",
               .title = "Surface forces",
               .quantity = "nm, or kT of a sphere of 5 um and a plate at 10 mM",
               .reference =
                   "references.md D: Gregory 1981; Hogg, Healy & Fuerstenau 1966. The laws "
                   "of porefines forces; no run uses them yet"};
  for (const auto& [millimolar, length] :
       {std::pair{0.1, 30.401}, {1.0, 9.6137}, {10.0, 3.0401}, {100.0, 0.96138}}) {
    c.rows.push_back(law(fmt::format("Debye length at {} mM", millimolar),
                         debye_length(water(millimolar)) / nm, length, 2e-5));
  }
  struct Energy {
    Real gap, attraction, layers;
  };
  for (const Energy& e :
       {Energy{1, -887.904, 3349.97}, {5, -119.083, 1117.27}, {20, -13.3186, 8.8283}}) {
    c.rows.push_back(law(fmt::format("van der Waals at {} nm", e.gap),
                         radius * dlvo.attraction.energy(e.gap * nm) / kt, e.attraction, 1e-5));
    c.rows.push_back(law(fmt::format("double layer at {} nm", e.gap),
                         radius * dlvo.layers.energy(e.gap * nm) / kt, e.layers, 1e-5));
  }
  const surface::Landmarks marks = find_landmarks(dlvo, radius);
  if (marks.barrier && marks.secondary) {
    c.rows.push_back(law("barrier", marks.barrier->energy / kt, 2475.4, 1e-4));
    c.rows.push_back(law("place of the barrier", marks.barrier->gap / nm, 1.13, 5e-3));
    c.rows.push_back(law("secondary minimum", marks.secondary->energy / kt, -7.316, 1e-4));
    c.rows.push_back(law("place of the secondary minimum", marks.secondary->gap / nm, 24.41, 1e-3));
  } else {
    c.rows.push_back(law("barrier and secondary minimum", NAN, 1, 0));
  }
  return c;
}

/// Grains of 0.6 mm, particles of 1 um at 15 degrees.
Comparison filtration() {
  const surface::FiltrationNumbers n = surface::filtration_numbers(
      {.diameter = 0.6e-3, .porosity = 0.39, .velocity = 9e-6}, {.diameter = 1e-6,
                                                                 .density = 1050,
                                                                 .hamaker = 1e-20,
                                                                 .temperature = 288.15,
                                                                 .fluid_density = 997,
                                                                 .fluid_viscosity = 1e-3});
  const surface::CollectorEfficiency eta = tufenkji_elimelech(n);
  const Real tumbling = surface::shear_moment(1, 1);
  return {.name = "filtration",
          .title = "Diffusion, adhesion, detachment, collectors",
          .quantity = "SI",
          .reference =
              "references.md D: Stokes & Einstein; Johnson, Kendall & Roberts 1971; Goldman, Cox "
              "& Brenner 1967; Tufenkji & Elimelech 2004; Rajagopalan & Tien 1976",
          .rows = {law("diffusivity of 1 um, 0.8903 mPa s",
                       surface::diffusivity(298.15, 0.8903e-3, 1e-6), 4.9058e-13, 2e-5),
                   law("diffusivity of 5 um", surface::diffusivity(298.15, 0.8903e-3, 5e-6),
                       9.8116e-14, 2e-5),
                   law("JKR pull-off, 50 mJ/m², 2.5 um", surface::jkr_pull_off(0.05, radius),
                       5.8905e-7, 2e-5),
                   law("moment on a sphere at a wall over τ a³", tumbling, 43.916, 2e-5),
                   law("N_A over N_vdW/(N_R N_Pe)",
                       n.attraction / (n.van_der_waals / (n.size * n.peclet)), 1, 1e-12),
                   law("efficiency by diffusion", eta.diffusion, 0.0167925, 1e-5),
                   law("efficiency by interception", eta.interception, 3.780e-4, 2e-4),
                   law("efficiency by gravity", eta.gravity, 1.8303e-3, 5e-5),
                   law("single-collector efficiency", eta.total(), 0.0190009, 1e-5),
                   law("that of Rajagopalan & Tien", rajagopalan_tien(n).total(), 0.027092, 2e-5)}};
}

}  // namespace

void add_forces(std::vector<Comparison>& list) {
  list.push_back(colloids());
  list.push_back(filtration());
}

}  // namespace porefines::validate
