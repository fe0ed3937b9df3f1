// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <optional>
#include <string>

#include "config/forces_file.hpp"
#include "surface/collector.hpp"
#include "surface/landmarks.hpp"

namespace porefines {

/// One curve: a particle and a wall, or two particles.
struct ForceCurve {
  std::string name;   ///< of its files
  std::string title;  ///< for people
  Real radius = 0;    ///< [m] reduced
  surface::ForceLaw law;
  surface::Landmarks marks;
};

/// A sphere on a wall held by `force`, rolled over `lever`.
struct Detachment {
  std::string held_by;  ///< "adhesion", "primary minimum", "secondary minimum"
  Real force = 0;       ///< [N]
  Real stress = 0;      ///< [Pa] critical
};

/// Surfaces in contact.
struct Adhesion {
  Real jkr = 0;                             ///< [N] pull-off
  Real dmt = 0;                             ///< [N]
  Real contact_radius = config::not_given;  ///< [m] JKR
  Real tabor = config::not_given;
};

struct Filtration {
  surface::CollectorEfficiency efficiency;  ///< Tufenkji & Elimelech
  Real rajagopalan_tien = 0;
  Real happel_interception = 0;
  Real coefficient = 0;  ///< [1/m] of the first
};

/// All numbers of `porefines forces`.
struct Forces {
  config::ForcesFile file;
  Real thermal = 0;       ///< [J] kT
  Real debye_length = 0;  ///< [m]
  Real diffusivity = 0;   ///< [m^2/s]
  std::array<ForceCurve, 2> curves;
  std::optional<Adhesion> adhesion;
  Real lever = config::not_given;  ///< [m] of the roughness, else of the contact
  std::vector<Detachment> detachments;
  std::optional<Filtration> filtration;
  std::vector<std::string> notes;  ///< where a law is beyond its range
};

[[nodiscard]] Forces find_forces(const config::ForcesFile& file);

/// CSV, charts and summary.json; returns the names of the files.
/// @throws RunError
std::vector<std::string> write_forces(const std::string& folder, const Forces& forces);

}  // namespace porefines
