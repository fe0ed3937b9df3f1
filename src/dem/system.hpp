// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "dem/box.hpp"
#include "dem/contact_model.hpp"
#include "dem/creep_balance.hpp"
#include "dem/exchange.hpp"
#include "dem/kept_contacts.hpp"
#include "dem/pair_contacts.hpp"
#include "dem/particles.hpp"
#include "dem/wall_contacts.hpp"
#include "par/communicator.hpp"

namespace porefines::dem {

/// What a system of particles is given once.
struct Settings {
  Box box;
  Blocks blocks;  ///< one per rank: make_blocks (the flow's) or even_blocks
  MaterialTable materials;
  ContactModel model;
  Surfaces walls;  ///< whole on every rank, or what its block and the reach of its particles need
  std::vector<std::uint16_t> wall_species;  ///< material of each wall; empty: all species 0
  Vec3 gravity;                             ///< [m/s^2]
  bool account = false;                     ///< sum up what contacts dissipate: Totals::dissipated
  /// [kg/m^3] of a fluid that has to move with a particle: half of its density. Then particles that keep
  /// what creep() needs are moved by advance() all the same.
  Real added_density = 0;
  Real skin = 0;  ///< [m] pairs nearer than this are listed; 0: a fifth of the mean diameter
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
  Spent dissipated;       ///< [J] since the start, where Settings::account asks for it
  Real potential = 0;     ///< [J] -m g.x
};

/// How much a run has done on this rank so far.
struct Work {
  Index steps = 0;
  Index rebuilds = 0;      ///< of the neighbour lists
  Index narrowings = 0;    ///< of the list of pairs that may touch soon
  Index listed_pairs = 0;  ///< in the present lists
  Index messages = 0;
};

/// Everything that a run needs to go on: N + N steps equal 2 N steps bit for bit on the same number
/// of ranks. On another number the particles find their new owners and the sums agree to round-off.
struct Snapshot {
  Particles particles;  ///< owned ones, in their present order
  KeptContacts contacts;
  Surfaces walls;
  Real skin = 0;             ///< [m]
  Real moved = 0;            ///< [m] farthest way since the lists were built
  bool listed = true;        ///< there were lists: not right after particles came or went
  Spent spent_among;         ///< [J] by contacts of particles, on this rank
  Spent spent_on_walls;      ///< [J]
  Real largest_overlap = 0;  ///< System::largest_overlap, of this rank
};

/// How far System::creep may go: what meets comes nearer by at most `approach` in a substep; the step
/// ends early where somebody has gone `travel`, since what the flow would do there is no longer known:
/// what grains held lets go at the speed that the drag on it gives in the open.
struct CreepBounds {
  Real approach = 0;                                    ///< [m]
  Real travel = std::numeric_limits<Real>::infinity();  ///< [m] of the fastest, in a step
};

/// What one step of System::creep took.
struct CreepReport {
  Index substeps = 0;
  Real shortest = 0;  ///< [s] substep
  Real elapsed = 0;   ///< [s] of the step
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
  /// Contacts keep their histories; afterwards contacts and forces are those of the moment.
  /// @throws InputError for a radius, density or species out of range, or a centre outside the box
  void insert(std::span<const Body> bodies);

  /// Removes owned particles for which gone(particles, i) holds; collective, as insert.
  /// @return how many left this rank
  Index remove(const std::function<bool(const Particles&, std::size_t)>& gone);

  /// Moves all particles by `steps` steps of `dt`; collective. Afterwards positions and velocities
  /// belong to the same time, and `force` and `torque` hold the contact forces there.
  /// @throws RunError when a particle's speed is no longer a number
  void advance(Real dt, Index steps);

  /// Keeps what creep() needs with each particle (Particles::creeping, zero at first); collective.
  void start_creeping();

  /// Moves all particles through one step `dt` of the flow as overdamped bodies; collective.
  ///
  ///     U = W + (F_contact + F_external)/R,    W = U* - F*/R extrapolated by AB2
  ///
  /// and the same for rotation. In: Particles::creeping's U*, F*, R and their rotational partners.
  /// Positions advance in substeps by the linearly implicit rule of CreepBalance, short enough for
  /// `bounds`; without contacts, in one.
  /// Out: mean_force and mean_torque, the contact forces averaged over the step: what the next solve
  /// is told as F*. Inertia, dashpots and gravity play no part (algorithm.md section 5).
  /// Tests: verification/dem_overdamped, mpi/dem.
  CreepReport creep(Real dt, const CreepBounds& bounds);

  /// Multiplies every modulus, see softening() in step_size.hpp; above 1: takes softening back.
  void soften(Real factor);

  /// Tells the system that positions, radii, species or fixed flags were changed from outside.
  void rebuild();

  [[nodiscard]] Snapshot save() const;
  /// Goes on from a snapshot; collective. @param same_ranks  saved by this rank of as many ranks
  void restore(Snapshot snapshot, bool same_ranks);

  [[nodiscard]] Particles& particles() { return particles_; }
  [[nodiscard]] const Particles& particles() const { return particles_; }
  [[nodiscard]] const Settings& settings() const { return settings_; }

  /// Largest overlap divided by the smaller radius seen since the last reset; collective.
  [[nodiscard]] Real largest_overlap() const;
  void reset_largest_overlap();

  /// [m/s] of the fastest particle; collective
  [[nodiscard]] Real top_speed() const;

  /// [s] shortest duration of an impact at this closing speed [m/s]; collective.
  /// A step is a fraction of it: 1/30 unless there is a reason (thesis eq. 14).
  [[nodiscard]] Real contact_duration(Real speed) const;

  /// What surfaces could not answer on this rank so far; lost and uncovered also stop advance().
  [[nodiscard]] const WallTrouble& wall_trouble() const { return walls_.trouble(); }

  [[nodiscard]] Totals totals() const;  ///< collective
  [[nodiscard]] const Work& work() const { return work_; }
  /// Touching pairs with at least one owned particle; a pair across ranks is on both.
  [[nodiscard]] std::vector<ContactRecord> contacts() const;

 private:
  void keep_contacts();
  [[nodiscard]] KeptContacts collected_contacts() const;
  void build_lists(bool sort);
  void narrow_lists();
  void update_lists(Real fastest, Real dt);
  void contact_forces(const Evaluation& evaluation);
  void prepare();
  void find_contacts();
  void creep_forces(Real stretched);
  [[nodiscard]] Real creep_limit(Real longest, Real allowed);
  void check_walls() const;

  par::Communicator comm_;
  Settings settings_;
  Exchange exchange_;
  Particles particles_;
  KeptContacts kept_;
  PairContacts pairs_;
  WallContacts walls_;
  bool moves_ = false;  ///< it has begun: the skin stays
  bool lists_hold_ = false;
  bool forces_hold_ = false;
  CreepBalance balance_;
  Real skin_ = 0;
  Real moved_ = 0;         ///< [m] since the lists were built, at most, by any particle
  Real window_ = 0;        ///< [m] pairs nearer than this were kept by the last narrowing
  Real moved_narrow_ = 0;  ///< [m] since then
  Real moved_per_step_ = 0;
  Work work_;
};

}  // namespace porefines::dem
