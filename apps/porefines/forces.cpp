// SPDX-License-Identifier: MPL-2.0
#include "forces.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "surface/adhesion.hpp"

namespace porefines {
namespace {

using config::Colloid;
using config::ForcesFile;

surface::Solution solution_of(const Colloid& c) {
  return {c.temperature, c.permittivity, c.ionic_strength};
}

ForceCurve curve_of(const Colloid& c, bool wall, Real particle_radius) {
  const surface::Surfaces pair{.hamaker = wall ? c.hamaker : c.hamaker_particles,
                               .wavelength = c.wavelength,
                               .zeta1 = c.zeta_particle,
                               .zeta2 = wall ? c.zeta_wall : c.zeta_particle,
                               .model = static_cast<surface::DoubleLayerModel>(c.model),
                               .born_diameter = c.born_diameter};
  ForceCurve curve{
      wall ? "wall" : "particles",
      wall ? "Particle and wall" : "Two particles",
      wall ? particle_radius : surface::reduced_radius(particle_radius, particle_radius),
      surface::make_force_law(solution_of(c), pair),
      {}};
  curve.marks = surface::find_landmarks(curve.law, curve.radius);
  return curve;
}

Adhesion adhesion_of(const ForcesFile& file, Real radius) {
  constexpr Real range = 0.3e-9;  // [m] of the attraction between surfaces in contact
  const Real work = file.colloid.work_of_adhesion;
  Adhesion a{surface::jkr_pull_off(work, radius), surface::dmt_pull_off(work, radius)};
  if (!std::isnan(file.particles.young)) {
    const Real modulus =
        surface::contact_modulus(file.particles.young, file.particles.poisson,
                                 file.contact.wall_young, file.contact.wall_poisson);
    a.contact_radius = surface::jkr_contact_radius(work, radius, modulus);
    a.tabor = surface::tabor_number(work, radius, modulus, range);
  }
  return a;
}

/// Whatever holds the particle on the wall, if there is a lever to roll it over.
void find_detachments(Forces& f, Real radius) {
  const Real contact = f.adhesion ? f.adhesion->contact_radius : config::not_given;
  const Real roughness = f.file.colloid.roughness;
  f.lever = roughness > 0 ? surface::roughness_lever(roughness, radius) : contact;
  const auto add = [&](const std::string& held_by, Real force) {
    f.detachments.push_back(
        {held_by, force, surface::critical_shear_stress(force, f.lever, radius)});
  };
  if (std::isnan(f.lever)) {
    return;
  }
  if (f.adhesion) {
    add("adhesion", f.adhesion->jkr);
  }
  // Bodies in a minimum do not touch: the lever of a contact is none of theirs.
  const surface::Landmarks& marks = f.curves[0].marks;
  if (marks.primary && roughness > 0) {
    add("primary minimum", marks.primary->pull);
  }
  if (marks.secondary && roughness > 0) {
    add("secondary minimum", marks.secondary->pull);
  }
}

Filtration filtration_of(const ForcesFile& file) {
  const config::FilterGrain& grain = *file.collector;
  const surface::Collector collector{grain.diameter, grain.porosity, grain.velocity};
  const surface::FiltrationNumbers n =
      surface::filtration_numbers(collector, {.diameter = file.particles.diameter,
                                              .density = file.particles.density,
                                              .hamaker = file.colloid.hamaker,
                                              .temperature = file.colloid.temperature,
                                              .fluid_density = file.fluid.density,
                                              .fluid_viscosity = file.fluid.viscosity});
  const surface::CollectorEfficiency efficiency = surface::tufenkji_elimelech(n);
  return {efficiency, surface::rajagopalan_tien(n).total(),
          surface::happel_interception(grain.porosity, n.size),
          surface::filtration_coefficient(collector, efficiency.total())};
}

std::vector<std::string> notes_of(const Forces& f) {
  constexpr Real highest = 60e-3;  // [V]
  constexpr Real thinnest = 5;
  const Colloid& c = f.file.colloid;
  std::vector<std::string> notes;
  const Real zeta = std::max(std::abs(c.zeta_particle), std::abs(c.zeta_wall));
  if (c.model == config::DoubleLayer::hhf && zeta > highest) {
    notes.push_back(
        fmt::format("a zeta potential of {:.0f} mV is beyond hhf, which is linear up to "
                    "some 60 mV; colloid.model=superposition takes it",
                    1e3 * zeta));
  }
  const Real thin = f.curves[1].radius / f.debye_length;
  if (thin < thinnest) {
    notes.push_back(
        fmt::format("the reduced radius of two particles is {:.2g} Debye lengths; "
                    "Derjaguin's approximation wants 5",
                    thin));
  }
  return notes;
}

}  // namespace

Forces find_forces(const ForcesFile& file) {
  const Real radius = file.particles.diameter / 2;
  const Colloid& c = file.colloid;
  Forces f{.file = file,
           .thermal = surface::thermal_energy(c.temperature),
           .debye_length = surface::debye_length(solution_of(c)),
           .diffusivity =
               surface::diffusivity(c.temperature, file.fluid.viscosity, file.particles.diameter),
           .curves = {curve_of(c, true, radius), curve_of(c, false, radius)},
           .adhesion = {},
           .detachments = {},
           .filtration = {},
           .notes = {}};
  if (c.work_of_adhesion > 0) {
    f.adhesion = adhesion_of(file, radius);
  }
  find_detachments(f, radius);
  if (file.collector) {
    f.filtration = filtration_of(file);
  }
  f.notes = notes_of(f);
  return f;
}

}  // namespace porefines
