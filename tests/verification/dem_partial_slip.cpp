// SPDX-License-Identifier: MPL-2.0
// Mindlin & Deresiewicz (1953): a sphere pressed on another and sheared to and fro.
#include <gtest/gtest.h>

#include "dem/contact_model.hpp"

namespace porefines::dem {

namespace {

constexpr Real mu = 0.4;

/// One contact at a fixed overlap, sheared step by step.
struct Sheared {
  explicit Sheared(int steps_per_slip) {
    const Elastic glass{"glass", 48e9, 0.2};
    pair = combine(glass, glass, {1.0, mu});
    contact.normal = {0, 0, 1};
    contact.overlap = 1e-6;
    contact.radius = 5e-3;
    contact.mass = 1e-3;
    contact.inertia = 1e-9;
    const NormalResponse r = Hertz{}(pair, contact);
    normal = r.force;
    stiffness = r.shear_stiffness;
    // Displacement at which everything slips: 3 mu N / (2 k).
    full_slip = 1.5 * mu * normal / stiffness;
    step = full_slip / steps_per_slip;
    (void)shear(0);
  }

  /// Moves by `distance` along x and gives the force that resists.
  Real shear(Real distance) {
    const ContactLaw law{Hertz{}, MindlinDeresiewicz{}, Unresisted{}};
    const int steps = std::max(1, static_cast<int>(std::lround(std::abs(distance) / step)));
    for (int n = 0; n < steps; ++n) {
      contact.slip.x = distance / steps;
      const Real before = force;
      force = -law(pair, contact, 1.0, history).force.x;
      work += (before + force) / 2 * contact.slip.x;
    }
    return force;
  }

  PairMaterial pair;
  ContactState contact;
  ContactHistory history;
  Real normal = 0, stiffness = 0, full_slip = 0, step = 0, force = 0, work = 0;
};

/// T / mu N on first loading to the share s of full slip; the others by Masing's rule, twice as long.
Real backbone(Real s) {
  return s >= 1 ? 1 : 1 - std::pow(1 - s, 1.5);
}

}  // namespace

TEST(PartialSlip, loading_unloading_reloading) {
  for (const int steps : {20, 200}) {
    Sheared c(steps);
    const Real cap = mu * c.normal;
    Real at = 0;
    const auto to = [&](Real share) {
      const Real force = c.shear((share - at) * c.full_slip);
      at = share;
      return force / cap;
    };
    const Real top = 0.7;
    for (const Real s : {0.1, 0.3, 0.5, 0.7}) {
      EXPECT_NEAR(to(s), backbone(s), 5e-3);
    }
    const Real t1 = backbone(top);
    for (const Real s : {0.6, 0.2, -0.2, -0.6}) {
      EXPECT_NEAR(to(s), t1 - 2 * backbone((top - s) / 2), 5e-3);
    }
    EXPECT_NEAR(to(-top), -t1, 5e-3);  // the loop is symmetric
    for (const Real s : {-0.4, 0.0, 0.4, 0.7}) {
      EXPECT_NEAR(to(s), -t1 + 2 * backbone((s + top) / 2), 5e-3);
    }
    EXPECT_NEAR(to(0.9), backbone(0.9), 5e-3);  // beyond the old top: first loading again
    EXPECT_NEAR(to(1.2), 1, 1e-12);             // everything slips
  }
}

TEST(PartialSlip, energy_lost_per_cycle) {
  // Johnson 1985, eq. 7.57: W = 36/5 (mu N)^2 / k [1 - x^(5/3) - (5 t / 6)(1 + x^(2/3))],
  // t = T / mu N, x = 1 - t, k = 8 G a.
  Sheared c(400);
  const Real cap = mu * c.normal;
  const Real top = 0.6;
  (void)c.shear(top * c.full_slip);
  (void)c.shear(-2 * top * c.full_slip);
  (void)c.shear(2 * top * c.full_slip);
  c.work = 0;
  (void)c.shear(-2 * top * c.full_slip);
  (void)c.shear(2 * top * c.full_slip);
  const Real t = backbone(top);
  const Real x = 1 - t;
  const Real lost = 36.0 / 5 * cap * cap / c.stiffness *
                    (1 - std::pow(x, 5.0 / 3) - 5 * t / 6 * (1 + std::pow(x, 2.0 / 3)));
  EXPECT_NEAR(c.work / lost, 1, 5e-3);
}

TEST(PartialSlip, no_slip_while_the_normal_force_grows_faster) {
  // dT < mu dN: the contact sticks, T follows the spring (Mindlin & Deresiewicz, oblique loading).
  Sheared c(100);
  const NormalResponse before = Hertz{}(c.pair, c.contact);
  Real expected = 0;
  for (int n = 0; n < 100; ++n) {
    const Real old_force = Hertz{}(c.pair, c.contact).force;
    c.contact.overlap *= 1.01;
    const NormalResponse r = Hertz{}(c.pair, c.contact);
    c.contact.slip.x = 0.5 * mu * (r.force - old_force) / r.shear_stiffness;
    expected += r.shear_stiffness * c.contact.slip.x;
    const ContactLaw law{Hertz{}, MindlinDeresiewicz{}, Unresisted{}};
    EXPECT_NEAR(-law(c.pair, c.contact, 1.0, c.history).force.x / expected, 1, 5e-3);
  }
  EXPECT_NEAR(expected / (0.5 * mu * (Hertz{}(c.pair, c.contact).force - before.force)), 1, 1e-9);
}

}  // namespace porefines::dem
