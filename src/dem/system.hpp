// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "dem/box.hpp"
#include "dem/contact_law.hpp"
#include "dem/particles.hpp"
#include "par/communicator.hpp"

namespace porefines::dem {

/// What a system of particles is given once.
struct Settings {
  Box box;
  Blocks blocks;  ///< one per rank: make_blocks (the flow's) or even_blocks
  MaterialTable materials;
  ContactModel model;
  Vec3 gravity;   ///< [m/s^2]
  Real skin = 0;  ///< [m] pairs nearer than this are listed; 0: a tenth of the mean diameter
};

/// Sums over all particles and contacts of all ranks.
struct Totals {
  Index particles = 0;
  Index contacts = 0;  ///< between particles, each counted once
  Index wall_contacts = 0;
  Vec3 momentum;          ///< [kg m/s]
  Vec3 angular_momentum;  ///< [kg m^2/s] about the origin
  Real kinetic = 0;       ///< [J] of translation
  Real rotational = 0;    ///< [J]
  Real elastic = 0;       ///< [J] in contacts: normal, shear and rolling springs
  Real potential = 0;     ///< [J] -m g.x
};

/// How much a run has done on this rank so far.
struct Work {
  Index steps = 0;
  Index rebuilds = 0;      ///< of the neighbour lists
  Index listed_pairs = 0;  ///< in the present lists
  Index messages = 0;
};

/// One touching pair, for output.
struct ContactRecord {
  std::uint64_t first = 0;   ///< particle's id
  std::uint64_t second = 0;  ///< particle's id, or the wall's number
  bool wall = false;
  Vec3 normal;       ///< from second to first
  Real overlap = 0;  ///< [m]
  Vec3 force;        ///< [N] on first
};

/// Spheres that touch each other and walls, moved by Newton's and Euler's equations.
///
///     m dv/dt = m g + F_contact + F_external,    I dw/dt = T_contact + T_external   (thesis eq. 2)
///
/// Velocity Verlet; contact forces with the velocities of the half step, as in LAMMPS and LIGGGHTS.
/// Particles are owned by the rank whose block holds their centre. Collective calls are marked.
class System {
 public:
  System(const par::Communicator& comm, Settings settings);

  /// Adds spheres; collective: every rank passes the same list and keeps what lies in its block.
  /// @throws InputError for a radius, density or species out of range, or a centre outside the box
  void insert(std::span<const Body> bodies);

  /// Removes owned particles for which gone(particles, i) holds; collective.
  /// @return how many left this rank
  Index remove(const std::function<bool(const Particles&, std::size_t)>& gone);

  /// Moves all particles by `steps` steps of `dt`; collective. Afterwards positions and velocities
  /// belong to the same time, and `force` and `torque` hold the contact forces there.
  /// @throws RunError when a particle's speed is no longer a number
  void advance(Real dt, Index steps);

  /// Tells the system that positions, radii or species were changed from outside; collective.
  void rebuild();

  [[nodiscard]] Particles& particles() { return particles_; }
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }

  /// Largest overlap divided by the smaller radius seen since the last reset; collective.
  [[nodiscard]] Real largest_overlap() const;
  void reset_largest_overlap() { largest_overlap_ = 0; }

  [[nodiscard]] Totals totals() const;  ///< collective
  [[nodiscard]] const Work& work() const { return work_; }
  /// Touching pairs with at least one owned particle; a pair across ranks is on both.
  [[nodiscard]] std::vector<ContactRecord> contacts() const;

 private:
  struct Pair {
    std::uint32_t i;
    std::uint32_t j;
    ContactHistory history;
  };
  void find_pairs();
  void contact_forces(Real dt);

  par::Communicator comm_;
  Settings settings_;
  Particles particles_;
  std::vector<Pair> pairs_;
  bool lists_hold_ = false;
  Real largest_overlap_ = 0;
  Work work_;
};

}  // namespace porefines::dem
