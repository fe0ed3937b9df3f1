// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <array>

#include "dem/material.hpp"

namespace porefines::dem {

/// One contact as the law sees it. Body j may be a wall: 1/radius = 1/mass = 1/inertia = 0.
struct ContactState {
  Vec3 normal;       ///< unit, from j to i: for a wall out of the surface, towards the centre
  Real overlap = 0;  ///< [m] > 0
  Vec3 slip;         ///< [m/s] velocity of i minus that of j at the point of contact
  Vec3 spin;         ///< [rad/s] angular velocity of i minus that of j
  Real radius = 0;   ///< [m]  R, 1/R = 1/R1 + 1/R2
  Real mass = 0;     ///< [kg] m, 1/m = 1/m1 + 1/m2
  Real inertia = 0;  ///< [kg m^2] 1/I = 1/I1 + 1/I2
};

/// What a contact remembers from step to step; zero when it forms.
struct ContactHistory {
  Vec3 shear;               ///< [N] tangential spring force on i
  Real contact_radius = 0;  ///< [m] of the last step
  Vec3 rolling;             ///< [N m] rolling spring moment on i
  Real normal_force = 0;    ///< [N] of the last step     (this and the rest: partial slip only)
  Real unload = 0;          ///< [N] shear force at which the last unloading began
  Real reload = 0;          ///< [N] shear force at which the last reloading began
  Vec3 axis;                ///< direction in which the contact was first sheared
  Real branch = 0;          ///< 0 first loading, 1 unloading, 2 reloading
};
/// Length of the history as plain numbers.
inline constexpr int history_size = sizeof(ContactHistory) / sizeof(Real);
inline constexpr int basic_history = 7;  ///< without partial slip

/// How a loop over contacts is to be evaluated.
struct Evaluation {
  Real dt = 0;  ///< [s] over which springs stretch; 0 leaves them
  /// Overdamped: the liquid takes the place of mass, dashpots are off (mass 0) and what stops a
  /// rotation within the step is its resistance times dt instead of its inertia.
  bool creeping = false;
  bool account = false;  ///< sum up the work of contacts, see Spent
};

/// Work [J] that contacts took: by dashpots along the normal; against friction and against rolling,
/// springs included, so that what these hold at the moment comes off before it is called dissipated.
///
///     normal  += F_viscous (v_n - F_n dt / (2 m)) dt            the mean over the step
///     sliding -= (F_t - T + (T_before + T)/2) . v_t dt          T: the spring's share of F_t
///     rolling -= (M - S + (S_before + S)/2) . w dt              S: the spring's share of M
///
/// Springs count with their mean over the step, whose ends velocity Verlet's half-step velocities join:
/// a spring that only stretches and relaxes takes nothing. Test: verification/dem_energy.
struct Spent {
  Real normal = 0;
  Real sliding = 0;
  Real rolling = 0;
  void add(const Spent& other, Real share) {
    normal += share * other.normal, sliding += share * other.sliding;
    rolling += share * other.rolling;
  }
};

using HistoryNumbers = std::array<Real, history_size>;

/// Force and couple on body i; j takes the opposite, at the same point.
struct ContactForce {
  Vec3 force;       ///< [N]
  Vec3 couple;      ///< [N m] rolling resistance, without the lever arm's share
  Real normal = 0;  ///< [N] part of the force along the normal
};

/// What the normal model hands to the others.
struct NormalResponse {
  Real force = 0;            ///< [N] positive pushes apart
  Real stiffness = 0;        ///< [N/m] dF/d(overlap)
  Real contact_radius = 0;   ///< [m]
  Real shear_stiffness = 0;  ///< [N/m]
  Real shear_damping = 0;    ///< [N s/m]
};

/// Damped Hertz contact.
///
///     F = (4/3) E sqrt(R) d^(3/2) + 2 sqrt(5/6) zeta sqrt(S m) v,    S = 2 E sqrt(R d)
///
/// with overlap d and closing speed v. The restitution is then the requested one at every speed,
/// because the contact ends where the overlap does: the weak pull at the end of a rebound stays
/// (cutting it turns e = 0.50 into 0.55). `cut_pull` cuts it all the same, for comparisons.
/// Valid for d/R < 0.1. Refs: Tsuji, Tanaka & Ishida 1992; Antypov & Elliott 2011; thesis eq. 3a.
/// Tests: verification/impact.
struct Hertz {
  bool cut_pull = false;

  [[nodiscard, gnu::always_inline]] NormalResponse operator()(const PairMaterial& pair,
                                                              const ContactState& c) const {
    const Real a = std::sqrt(c.radius * c.overlap);
    const Real root = std::sqrt(a * c.mass);
    const Real closing = -dot(c.normal, c.slip);
    const Real force =
        (4.0 / 3.0) * pair.modulus * a * c.overlap + pair.normal_viscous * root * closing;
    return {cut_pull ? std::max(force, 0.0) : force, 2 * pair.modulus * a, a, 8 * pair.shear * a,
            pair.shear_viscous * root};
  }
  /// [N] without the dashpot
  [[nodiscard, gnu::always_inline]] Real elastic(const PairMaterial& pair,
                                                 const ContactState& c) const {
    return (4.0 / 3.0) * pair.modulus * std::sqrt(c.radius * c.overlap) * c.overlap;
  }
  /// [J] stored in the normal spring
  [[nodiscard]] Real energy(const PairMaterial& pair, const ContactState& c) const {
    return 8.0 / 15.0 * pair.modulus * std::sqrt(c.radius * c.overlap) * c.overlap * c.overlap;
  }
};

/// Linear spring and dashpot: F = k d + 2 zeta sqrt(k m) v; the contact lasts
/// pi / sqrt((k/m) (1 - zeta^2)) at every speed. Shear stiffness = ratio times k.
/// Refs: Cundall & Strack 1979; Schafer, Dippel & Wolf 1996. Tests: verification/impact.
struct LinearSpring {
  Real stiffness = 0;          ///< [N/m]
  Real shear_ratio = 2.0 / 7;  ///< [-]
  bool cut_pull = false;

  [[nodiscard, gnu::always_inline]] NormalResponse operator()(const PairMaterial& pair,
                                                              const ContactState& c) const {
    const Real viscous = 2 * pair.damping * std::sqrt(stiffness * c.mass);
    const Real force = stiffness * c.overlap - viscous * dot(c.normal, c.slip);
    return {cut_pull ? std::max(force, 0.0) : force, stiffness, std::sqrt(c.radius * c.overlap),
            shear_ratio * stiffness, viscous * std::sqrt(shear_ratio)};
  }
  [[nodiscard, gnu::always_inline]] Real elastic(const PairMaterial& /*pair*/,
                                                 const ContactState& c) const {
    return stiffness * c.overlap;
  }
  [[nodiscard]] Real energy(const PairMaterial& /*pair*/, const ContactState& c) const {
    return stiffness * c.overlap * c.overlap / 2;
  }
};

/// No tangential force, or no resistance to rolling.
struct Unresisted {
  static constexpr int memory = 0;
  [[nodiscard, gnu::always_inline]] Vec3 operator()(const PairMaterial& /*pair*/,
                                                    const ContactState& /*contact*/,
                                                    const NormalResponse& /*normal*/, Real /*dt*/,
                                                    ContactHistory& /*history*/) const {
    return {};
  }
};

/// Tangential spring without micro-slip, capped by Coulomb's law (the default).
///
///     dT = -k_t v_t dt,  k_t = 8 G sqrt(R d);   T shrinks with k_t while the bodies part;
///     |T| <= mu F_n;  F_t = T - gamma_t v_t, again within mu F_n
///
/// T is kept as a force, so that pressing harder does not add energy to a stretched spring.
/// Where the normal force pulls (see Hertz) there is no friction. T turns with the contact plane.
/// Refs: Mindlin 1949; Thornton, Cummins & Cleary 2011; thesis eq. 3b. Tests: verification/friction.
struct Mindlin {
  static constexpr int memory = 4;
  [[nodiscard, gnu::always_inline]] Vec3 operator()(const PairMaterial& pair, const ContactState& c,
                                                    const NormalResponse& normal, Real dt,
                                                    ContactHistory& h) const {
    const Real cap = pair.sliding * std::max(normal.force, 0.0);
    const Vec3 v = c.slip - dot(c.slip, c.normal) * c.normal;
    const bool parting = normal.contact_radius < h.contact_radius;
    const Real keep = parting ? normal.contact_radius / h.contact_radius : 1.0;
    Vec3 spring = keep * (h.shear - dot(h.shear, c.normal) * c.normal);
    spring -= (normal.shear_stiffness * dt) * v;
    spring *= shrink(spring, cap);
    h.shear = spring;
    h.contact_radius = normal.contact_radius;
    const Vec3 force = spring - normal.shear_damping * v;
    return shrink(force, cap) * force;
  }

  /// The factor in [0, 1] that brings a force within its cap.
  [[nodiscard, gnu::always_inline]] static Real shrink(const Vec3& force, Real cap) {
    const Real size = std::sqrt(dot(force, force));
    return size > cap ? cap / size : 1.0;
  }
};

/// Rolling moment of constant size mu_r R F_n against the relative rotation (without its part about
/// the normal), no larger than what stops the rotation within the step.
/// Ref: Ai, Chen, Rotter & Ooi 2011, model A. Test: verification/friction.
struct ConstantTorque {
  static constexpr int memory = 0;
  [[nodiscard, gnu::always_inline]] Vec3 operator()(const PairMaterial& pair, const ContactState& c,
                                                    const NormalResponse& normal, Real dt,
                                                    ContactHistory& /*history*/) const {
    const Vec3 w = c.spin - dot(c.spin, c.normal) * c.normal;
    const Real cap = pair.rolling * c.radius * std::max(normal.force, 0.0);
    const Real stopping = c.inertia / std::max(dt, 1e-30);
    const Real size = std::sqrt(dot(w, w));
    return -(size * stopping > cap ? cap / size : stopping) * w;
  }
};

/// Elastic-plastic rolling spring with dashpot.
///
///     dM = -k_r w dt, |M| <= mu_r R F_n,  k_r = 2.25 k_n (mu_r R)^2;
///     while the spring holds, a dashpot -2 eta sqrt(I_c k_r) w adds to it, I_c about the contact: 7/2 I
///
/// Ref: Iwashita & Oda 1998; Ai, Chen, Rotter & Ooi 2011, model C. Test: verification/friction.
struct RollingSpring {
  static constexpr int memory = 7;
  [[nodiscard, gnu::always_inline]] Vec3 operator()(const PairMaterial& pair, const ContactState& c,
                                                    const NormalResponse& normal, Real dt,
                                                    ContactHistory& h) const {
    const Vec3 w = c.spin - dot(c.spin, c.normal) * c.normal;
    const Real arm = pair.rolling * c.radius;
    const Real cap = arm * std::max(normal.force, 0.0);
    const Real stiffness = 2.25 * normal.stiffness * arm * arm;
    Vec3 spring = h.rolling - dot(h.rolling, c.normal) * c.normal - (stiffness * dt) * w;
    const Real keep = Mindlin::shrink(spring, cap);
    spring *= keep;
    h.rolling = spring;
    const Real viscous = 2 * pair.rolling_damping * std::sqrt(3.5 * c.inertia * stiffness);
    return spring - (keep < 1 ? 0.0 : viscous) * w;
  }
};

}  // namespace porefines::dem
