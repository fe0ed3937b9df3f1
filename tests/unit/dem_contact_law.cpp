// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "dem/contact_model.hpp"

namespace porefines::dem {

namespace {

PairMaterial glass() {
  const Elastic e{"glass", 48e9, 0.2};
  return combine(e, e, {0.9, 0.4, 0.01, 0.3});
}

ContactState pressed(Real overlap) {
  ContactState c;
  c.normal = {0, 0, 1};
  c.overlap = overlap;
  c.radius = 5e-3;
  c.mass = 1e-3;
  c.inertia = 1e-9;
  return c;
}

}  // namespace

TEST(ContactLaw, hertz_without_motion) {
  // F = 4/3 E sqrt(R) d^1.5, E = 25 GPa.
  const NormalResponse r = Hertz{}(glass(), pressed(1e-6));
  EXPECT_NEAR(r.force, 4.0 / 3 * 25e9 * std::sqrt(5e-3) * 1e-9, 1e-9 * r.force);
  EXPECT_NEAR(r.stiffness, 1.5 * r.force / 1e-6, 1e-9 * r.stiffness);
  EXPECT_NEAR(r.shear_stiffness / r.stiffness, 4 * glass().shear / glass().modulus, 1e-12);
}

TEST(ContactLaw, friction_is_capped_and_opposes_slip) {
  ContactState c = pressed(1e-6);
  c.slip = {0.1, 0.05, 0};
  ContactHistory h;
  ContactForce f;
  const ContactLaw law{Hertz{}, Mindlin{}, Unresisted{}};
  for (int step = 0; step < 1000; ++step) {
    f = law(glass(), c, 1e-7, h);
  }
  const Vec3 shear = f.force - f.normal * c.normal;
  EXPECT_NEAR(norm(shear), 0.4 * f.normal, 1e-12 * f.normal);
  EXPECT_NEAR(dot(shear, c.slip), -norm(shear) * norm(c.slip), 1e-12 * f.normal);
}

TEST(ContactLaw, rolling_spring_reaches_its_cap) {
  ContactState c = pressed(1e-6);
  c.spin = {0, 10, 3};  // the part about the normal does not count
  ContactHistory h;
  const ContactLaw law{Hertz{}, Unresisted{}, RollingSpring{}};
  ContactForce f;
  for (int step = 0; step < 1000; ++step) {
    f = law(glass(), c, 1e-6, h);
  }
  EXPECT_NEAR(f.couple.y, -0.01 * 5e-3 * f.normal, 1e-12 * f.normal);
  EXPECT_EQ(f.couple.z, 0);
}

TEST(ContactLaw, constant_torque_stops_and_does_not_reverse) {
  ContactState c = pressed(1e-6);
  c.spin = {1e-6, 0, 0};
  ContactHistory h;
  const ContactForce f = ContactLaw{Hertz{}, Unresisted{}, ConstantTorque{}}(glass(), c, 1e-6, h);
  EXPECT_NEAR(f.couple.x * 1e-6 / c.inertia, -1e-6, 1e-18);
}

TEST(Materials, say_what_is_wrong) {
  const Elastic good{"glass", 48e9, 0.2};
  const Elastic soft{"jelly", -1, 0.2};
  EXPECT_THROW((void)combine(good, soft, {}), InputError);
  EXPECT_THROW((void)combine(good, good, {0.0, 0.5}), InputError);
  EXPECT_THROW((void)combine(good, good, {0.9, -0.5}), InputError);
}

TEST(Materials, mixed_pairs) {
  MaterialTable table({{"a", 1e9, 0.3}, {"b", 1e12, 0.3}}, {});
  table.set_pair(0, 1, {0.5, 0.1});
  EXPECT_EQ(table.pair(1, 0).sliding, 0.1);
  EXPECT_EQ(table.pair(0, 0).sliding, 0.5);
  EXPECT_NEAR(table.pair(0, 1).modulus / (1e9 / 0.91), 1 / 1.001, 1e-12);
  const Real before = table.pair(0, 1).modulus;
  table.soften(0.01);
  EXPECT_NEAR(table.pair(0, 1).modulus, 0.01 * before, 1e-9 * before);
}

}  // namespace porefines::dem
