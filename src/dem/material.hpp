// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::dem {

/// What a species of particle, or a wall, is made of.
struct Elastic {
  std::string name;    ///< for messages
  Real young = 0;      ///< [Pa]
  Real poisson = 0.3;  ///< [-] in (-1, 0.5]
};

/// How two species rub against each other.
struct Friction {
  Real restitution = 0.9;    ///< [-] e in (0, 1]
  Real sliding = 0.5;        ///< [-] Coulomb's mu
  Real rolling = 0;          ///< [-] mu_r: rolling moment / (normal force times reduced radius)
  Real rolling_damping = 0;  ///< [-] of the spring-dashpot rolling model, 1 = critical
};

/// Properties of a pair of species in contact, combined once.
struct PairMaterial {
  Real modulus = 0;          ///< [Pa] E, 1/E = (1 - nu1^2)/E1 + (1 - nu2^2)/E2
  Real shear = 0;            ///< [Pa] G, 1/G = (2 - nu1)/G1 + (2 - nu2)/G2
  Real damping = 0;          ///< [-]  zeta = -ln e / sqrt(ln^2 e + pi^2)
  Real sliding = 0;          ///< [-]
  Real rolling = 0;          ///< [-]
  Real rolling_damping = 0;  ///< [-]
  Real normal_viscous = 0;   ///< [Pa^1/2] 2 sqrt(5/6) zeta sqrt(2 E)
  Real shear_viscous = 0;    ///< [Pa^1/2] 2 sqrt(5/6) zeta sqrt(8 G)
};

/// @throws InputError naming the value when it is out of range, with what to try
[[nodiscard]] PairMaterial combine(const Elastic& a, const Elastic& b, const Friction& friction);

/// Every pair of species; walls are species too.
class MaterialTable {
 public:
  MaterialTable() = default;
  /// All pairs share one friction, unless set_pair says otherwise.
  MaterialTable(std::vector<Elastic> species, const Friction& friction);
  void set_pair(int a, int b, const Friction& friction);

  [[nodiscard]] int count() const { return static_cast<int>(species_.size()); }
  [[nodiscard]] const Elastic& species(int a) const { return species_[a]; }
  [[nodiscard]] const PairMaterial& pair(int a, int b) const { return pairs_[a * count() + b]; }
  [[nodiscard]] std::span<const PairMaterial> pairs() const { return pairs_; }

  /// Multiplies every modulus by `factor` <= 1: larger steps for larger overlaps.
  void soften(Real factor);

 private:
  std::vector<Elastic> species_;
  std::vector<Friction> frictions_;
  std::vector<PairMaterial> pairs_;  ///< count() x count(), symmetric
};

}  // namespace porefines::dem
