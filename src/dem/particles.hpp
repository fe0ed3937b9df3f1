// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/aligned.hpp"
#include "core/types.hpp"

namespace porefines::dem {

/// Bits of Particles::flags. A particle without any is mobile.
namespace flag {
inline constexpr std::uint8_t fixed = 1;  ///< held: its velocity is prescribed, forces are recorded
inline constexpr std::uint8_t retained = 2;  ///< counted as caught; moves like any other
}  // namespace flag

/// One sphere as it enters or leaves the arrays.
struct Body {
  std::uint64_t id = 0;   ///< unique in the run, never given twice
  Vec3 position;          ///< [m]
  Vec3 velocity;          ///< [m/s]
  Vec3 angular_velocity;  ///< [rad/s]
  Real radius = 0;        ///< [m]
  Real density = 0;       ///< [kg/m^3]
  std::uint16_t species = 0;
  std::uint8_t flags = 0;
};

/// What the overdamped integrator knows of each particle beside its place; empty when not in use.
struct Creeping {
  AlignedVector<Vec3> free_velocity;    ///< [m/s] U* of the last fluid solve
  AlignedVector<Vec3> free_spin;        ///< [rad/s]
  AlignedVector<Vec3> told_force;       ///< [N] F*, the contact force that this solve was told
  AlignedVector<Vec3> told_torque;      ///< [N m]
  AlignedVector<Real> resistance;       ///< [N s/m] R, e.g. 6 pi mu a
  AlignedVector<Real> spin_resistance;  ///< [N m s] e.g. 8 pi mu a^3
  AlignedVector<Vec3> mean_force;       ///< [N] mean contact force of the step: tell the next solve
  AlignedVector<Vec3> mean_torque;      ///< [N m]
  AlignedVector<Vec3> mean_velocity;    ///< [m/s] way of the step over its length
  AlignedVector<Vec3> drift;            ///< [m/s] W = U* - F*/R of the step before
  AlignedVector<Vec3> drift_spin;       ///< [rad/s]
  AlignedVector<Real> drift_step;       ///< [s] length of that step; 0: there was none
  AlignedVector<Vec3> way;              ///< [m/s] W of this step, extrapolated to its middle
  AlignedVector<Vec3> way_spin;         ///< [rad/s]

  template <typename Self, typename Visit>
  static void for_arrays(Self& self, const Visit& visit) {
    visit(self.free_velocity), visit(self.free_spin), visit(self.told_force);
    visit(self.told_torque), visit(self.resistance), visit(self.spin_resistance);
    visit(self.mean_force), visit(self.mean_torque);
    visit(self.mean_velocity);
    visit(self.drift), visit(self.drift_spin), visit(self.drift_step);
    visit(self.way), visit(self.way_spin);
  }
};

/// The spheres of one rank as structure of arrays: [0, owned) belong to it, the rest are ghosts,
/// copies of neighbours' particles (or of its own beyond a periodic border).
///
/// Ghosts hold position, velocity, angular_velocity, radius, inverse_mass, inverse_inertia, id and
/// species; their forces are scratch. The order changes whenever the neighbour lists are rebuilt:
/// keep ids, not indices, across System::advance.
struct Particles {
  std::size_t owned = 0;
  AlignedVector<Vec3> position;          ///< [m]
  AlignedVector<Vec3> velocity;          ///< [m/s]
  AlignedVector<Vec3> angular_velocity;  ///< [rad/s]
  AlignedVector<Vec3> force;             ///< [N] from contacts
  AlignedVector<Vec3> torque;            ///< [N m] from contacts
  AlignedVector<Vec3> external_force;   ///< [N] set by the caller (fluid, colloid), kept over steps
  AlignedVector<Vec3> external_torque;  ///< [N m]
  AlignedVector<Real> radius;           ///< [m]
  AlignedVector<Real> mass;             ///< [kg]
  AlignedVector<Real> inverse_mass;     ///< [1/kg] zero where fixed
  AlignedVector<Real> inverse_inertia;  ///< [1/(kg m^2)] of a homogeneous sphere; zero where fixed
  std::vector<std::uint64_t> id;
  std::vector<std::uint16_t> species;
  std::vector<std::uint8_t> flags;
  std::vector<std::uint8_t> pushed;  ///< 0: force and torque are zero and need not be looked at
  Creeping creeping;
  bool creeps = false;  ///< whether `creeping` is kept

  [[nodiscard]] std::size_t size() const { return position.size(); }
  [[nodiscard]] bool is_fixed(std::size_t i) const { return (flags[i] & flag::fixed) != 0; }
  [[nodiscard]] Real inertia(std::size_t i) const { return 0.4 * mass[i] * radius[i] * radius[i]; }

  /// Calls visit(array) for every array, in a fixed order: resizing, sorting and saving use it.
  template <typename Self, typename Visit>
  static void for_arrays(Self& self, const Visit& visit) {
    visit(self.position), visit(self.velocity), visit(self.angular_velocity);
    visit(self.force), visit(self.torque);
    visit(self.external_force), visit(self.external_torque);
    visit(self.radius), visit(self.mass), visit(self.inverse_mass), visit(self.inverse_inertia);
    visit(self.id), visit(self.species), visit(self.flags), visit(self.pushed);
    if (self.creeps) {
      Creeping::for_arrays(self.creeping, visit);
    }
  }

  void resize(std::size_t count);
  void clear_forces();

  /// Appends an owned particle; ghosts must have been dropped (size() == owned).
  void append(const Body& body);

  /// Holds or frees particle i: sets the flag and the inverse mass and inertia.
  void set_fixed(std::size_t i, bool fixed);

  /// New order: entry k becomes what was entry order[k]. May be shorter than before (removal).
  void reorder(std::span<const std::uint32_t> order);
};

}  // namespace porefines::dem
