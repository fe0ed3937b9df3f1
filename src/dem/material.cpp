// SPDX-License-Identifier: MPL-2.0
#include "dem/material.hpp"

#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::dem {

namespace {

void require(bool holds, const std::string& what, Real value, const char* advice) {
  if (!holds) {
    throw InputError(fmt::format("{} = {:g}: {}", what, value, advice));
  }
}

void check(const Elastic& e) {
  require(e.young > 0, e.name + " young", e.young, "must be positive, e.g. \"3.4 GPa\"");
  require(e.poisson > -1 && e.poisson <= 0.5, e.name + " poisson", e.poisson,
          "must lie between -1 and 0.5, e.g. 0.3");
}

void check(const Friction& f) {
  require(f.restitution > 0 && f.restitution <= 1, "restitution", f.restitution,
          "must lie in (0, 1], e.g. 0.9");
  require(f.sliding >= 0, "friction", f.sliding, "must not be negative, e.g. 0.5");
  require(f.rolling >= 0, "rolling_friction", f.rolling, "must not be negative, e.g. 0.01");
  require(f.rolling_damping >= 0, "rolling_damping", f.rolling_damping, "must not be negative");
}

}  // namespace

PairMaterial combine(const Elastic& a, const Elastic& b, const Friction& friction) {
  check(a), check(b), check(friction);
  const auto normal_softness = [](const Elastic& e) {
    return (1 - e.poisson * e.poisson) / e.young;
  };
  const auto shear_softness = [](const Elastic& e) {
    return (2 - e.poisson) * 2 * (1 + e.poisson) / e.young;
  };
  const Real log_e = std::log(friction.restitution);
  PairMaterial m;
  m.modulus = 1 / (normal_softness(a) + normal_softness(b));
  m.shear = 1 / (shear_softness(a) + shear_softness(b));
  m.damping = -log_e / std::sqrt(log_e * log_e + std::numbers::pi * std::numbers::pi);
  m.sliding = friction.sliding;
  m.rolling = friction.rolling;
  m.rolling_damping = friction.rolling_damping;
  m.normal_viscous = 2 * std::sqrt(5.0 / 6.0) * m.damping * std::sqrt(2 * m.modulus);
  m.shear_viscous = 2 * std::sqrt(5.0 / 6.0) * m.damping * std::sqrt(8 * m.shear);
  return m;
}

MaterialTable::MaterialTable(std::vector<Elastic> species, const Friction& friction)
    : species_(std::move(species)) {
  frictions_.assign(species_.size() * species_.size(), friction);
  pairs_.resize(frictions_.size());
  for (int a = 0; a < count(); ++a) {
    for (int b = 0; b <= a; ++b) {
      set_pair(a, b, friction);
    }
  }
}

void MaterialTable::set_pair(int a, int b, const Friction& friction) {
  const PairMaterial both = combine(species_[a], species_[b], friction);
  frictions_[a * count() + b] = frictions_[b * count() + a] = friction;
  pairs_[a * count() + b] = pairs_[b * count() + a] = both;
}

void MaterialTable::soften(Real factor) {
  require(factor > 0, "softening factor", factor, "must be positive");
  for (Elastic& e : species_) {
    e.young *= factor;
  }
  for (int a = 0; a < count(); ++a) {
    for (int b = 0; b <= a; ++b) {
      set_pair(a, b, frictions_[a * count() + b]);
    }
  }
}

}  // namespace porefines::dem
