// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/six.hpp"
#include "dem/contact_model.hpp"
#include "dem/exchange.hpp"
#include "dem/pair_contacts.hpp"
#include "dem/wall_contacts.hpp"
#include "par/communicator.hpp"

namespace porefines::dem {

/// How a contact answers to slip: k_n n n + k_t (1 - n n - s s), s where it slides, zero where it sticks.
struct Tangent {
  Real normal = 0;  ///< [N/m]
  Real shear = 0;   ///< [N/m]
  Vec3 sliding;     ///< unit, or zero

  [[nodiscard]] Vec3 times(const Vec3& n, const Vec3& slip) const {
    const Real along = dot(n, slip);
    return normal * along * n + shear * (slip - along * n - dot(sliding, slip) * sliding);
  }
};

/// Velocities of overdamped particles at the end of a substep, by the linearly implicit Euler method:
///
///     R (U - W) = F + F_external - dt sum_c K_c (slip of c)
///
/// and the same for rotation: exact where nothing touches, the balance of forces where nothing moves,
/// and stable for every dt, where the explicit rule asks for dt < R/K. What presses a particle is
/// thousands of times stiffer than the liquid around it, so this saves thousands of substeps in a clog.
/// The matrix is symmetric and positive: conjugate gradients, preconditioned by each particle's own six
/// rows, from the velocities of the substep before. Tests: verification/dem_overdamped.
class CreepBalance {
 public:
  /// Finds how the contacts of the last evaluation answer. @param dt  [s] of the substep to come
  void collect(const Particles& particles, const PairContacts& pairs, const WallContacts& walls,
               const ContactModel& model, const MaterialTable& materials, Real dt);
  /// Sets velocity and angular_velocity of all owned particles that are not held; collective.
  /// Afterwards those of the ghosts are out of date. @return iterations
  int solve(Particles& particles, Real dt, Exchange& exchange, const par::Communicator& comm);

  /// [N/m] sum of the stiffnesses at particle i
  [[nodiscard]] Real stiffness(std::size_t i) const { return stiffness_[i]; }
  /// Nothing of this rank touches.
  [[nodiscard]] bool none() const { return bodies_.empty(); }

 private:
  struct Arm {  ///< of a contact at one of its bodies, into which its normal points
    Vec3 normal;
    Real lever = 0;  ///< [m] from the centre
  };
  struct Link {  ///< two particles that touch
    std::uint32_t i, j;
    Arm at_i, at_j;
    Tangent tangent;
  };
  struct Body {  ///< a particle that touches; vectors are (U, a omega) and what is dual to them
    std::uint32_t particle;
    SixBySix stiffness{};  ///< of all its contacts
    Six given{};           ///< stiffness times what is known of the other side's velocity
    SixBySix lower{};      ///< of the preconditioner
    Six motion{}, residual{}, direction{}, answer{};
  };
  Body* body_of(const Particles& particles, std::size_t i);
  void begin(const Particles& particles, Real dt);
  void apply(Particles& particles, Real dt, Six Body::*x);
  void show(Particles& particles, Real dt, Six Body::*x, Exchange& exchange);
  [[nodiscard]] Real precondition();
  [[nodiscard]] Real enough(const Particles& particles, const par::Communicator& comm) const;
  void drift_alone(Particles& particles) const;

  std::vector<std::int32_t> place_;  ///< of a particle's body; -1: it touches nothing
  std::vector<Body> bodies_;
  std::vector<Link> links_;
  std::vector<Real> stiffness_;
};

}  // namespace porefines::dem
