// SPDX-License-Identifier: MPL-2.0
// The file of `porefines forces`. Its [colloid] is not yet part of a case: no run uses surface forces.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "config/case.hpp"

namespace porefines::config {

inline constexpr Real not_given = std::numeric_limits<Real>::quiet_NaN();

enum class DoubleLayer { hhf, superposition };

/// [colloid]: what surfaces do to each other across the liquid.
struct Colloid {
  Real hamaker = not_given;            ///< [J] particle and wall
  Real hamaker_particles = not_given;  ///< [J] two particles; not given: hamaker
  Real wavelength = 100e-9;            ///< [m]
  Real zeta_particle = not_given;      ///< [V]
  Real zeta_wall = not_given;          ///< [V]
  DoubleLayer model = DoubleLayer::hhf;
  Real ionic_strength = not_given;  ///< [mol/m^3]
  Real temperature = 293.15;        ///< [K]
  Real permittivity = 80.1;
  Real born_diameter = 0;     ///< [m]; 0: no Born repulsion
  Real work_of_adhesion = 0;  ///< [J/m^2]; 0: none
  Real roughness = 0;         ///< [m]; 0: smooth
};

/// [particles] of the file: one size.
struct Fine {
  Real diameter = not_given;
  Real density = Particles{}.density;
  Real young = not_given;
  Real poisson = Particles{}.poisson;
};

/// [contact] of the file: walls and grains.
struct WallStiffness {
  Real wall_young = not_given;    ///< not given: that of the particle
  Real wall_poisson = not_given;  ///< likewise
};

/// [collector]: the grains of a filter.
struct FilterGrain {
  Real diameter = not_given;
  Real porosity = not_given;
  Real velocity = not_given;  ///< superficial
};

struct ForcesFile {
  std::string path;
  Colloid colloid;
  Fine particles;
  WallStiffness contact;
  Fluid fluid;
  std::optional<FilterGrain> collector;
};

/// Reads and checks the file; SI, defaults filled.
/// @param overrides  "colloid.ionic_strength=1 mM", as for a case
/// @throws InputError  `forces.toml:4: [colloid] hamacker: unknown key; did you mean hamaker?`
/// Test: unit/config_forces.
[[nodiscard]] ForcesFile load_forces(const std::string& path,
                                     const std::vector<std::string>& overrides = {});
[[nodiscard]] ForcesFile parse_forces(const std::string& text, const std::string& path,
                                      const std::vector<std::string>& overrides = {});

/// The table of keys of docs/forces.md.
[[nodiscard]] std::string forces_reference();

}  // namespace porefines::config
