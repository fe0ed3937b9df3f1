// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "dem/injection.hpp"
#include "dem/system.hpp"
#include "geom/build.hpp"
#include "sim/beds.hpp"
#include "sim/ledger.hpp"

namespace porefines::sim {

/// Energy that came and went with particles [J].
struct EnergyBook {
  Real start = 0;
  Real injected = 0;
  Real out = 0;
};

/// What a dry run remembers besides the particles: the same on every rank. With System::save() all
/// that a checkpoint needs (dry_checkpoint.cpp).
struct DryState {
  Real time = 0;  ///< [s]
  Index steps = 0;
  Real step = 0;  ///< [s] the last one
  std::uint64_t next_id = 0;
  std::vector<dem::InletState> inlets;
  Ledger ledger;
  EnergyBook energy;
  std::array<Index, config::output_kinds> written{};  ///< samples of each kind of output

  [[nodiscard]] Index& written_of(config::OutputKind kind) {
    return written[static_cast<std::size_t>(kind)];
  }
};

/// A dry run in progress.
struct DryRun {
  const config::Case& the_case;
  const par::Communicator& comm;
  dem::System system;
  std::vector<dem::Inlet> inlets;
  DryState state;
  bool in_fluid = false;  ///< the flow solve takes up weight and outer forces, not the integrator
};

/// Sets up box and walls; no particles yet. Collective.
/// @throws InputError  anything wrong with them; nothing was run
[[nodiscard]] DryRun make_dry_run(const config::Case& the_case, const geom::Sample& sample,
                                  const par::Communicator& comm);

/// Puts in the particles of the start. Collective.
/// @return remarks for the user
/// @throws InputError  as make_dry_run
[[nodiscard]] std::vector<std::string> place_particles(DryRun& run);

/// The sums of the moment. Energy is NaN where there is no balance: a force along a periodic axis
/// has no potential, moving walls do work.
struct Moment {
  dem::Totals totals;
  Real mean_speed = 0;    ///< [m/s]
  Vec3 mean;              ///< [m] position
  Vec3 sigma;             ///< [m] its standard deviation (thesis eq. 19)
  Real energy = 0;        ///< [J] kinetic + rotational + elastic + potential of gravity and forces
  Real energy_lost = 0;   ///< [J] since the start: what is missing in `energy`
  Real dissipated = 0;    ///< [J] by contacts, added up step by step: the same, were steps exact
  Real coordination = 0;  ///< contacts with others per particle
  Real max_overlap = 0;   ///< of a radius, since the start
};

/// Collective.
[[nodiscard]] Moment look(const DryRun& run);

/// [J] potential of the external force on the particles, and NaN where there is none.
[[nodiscard]] bool has_energy_balance(const config::Case& the_case);

/// Gives every particle the force of its species.
void set_forces(DryRun& run);

// The sentences of the loop; all collective.

/// What became due in (from, to].
void inject_due(DryRun& run, Real from, Real to);

/// [s] of the next sample of any output after now, or the end.
[[nodiscard]] Real next_sample(const DryRun& run);

/// [s] that contacts allow a step of System::advance.
[[nodiscard]] Real longest_step(const DryRun& run);

/// The next stretch of equal steps, up to the next sample or to when particles may have come a
/// radius further.
struct Stretch {
  Real step = 0;  ///< [s]
  Index count = 0;
};
[[nodiscard]] Stretch choose_stretch(const DryRun& run);

void advance(DryRun& run, const Stretch& stretch);

/// Time and steps after a stretch; exactly `due` [s] where that is meant.
void advance_clock(DryState& state, const Stretch& stretch, Real due);

/// Takes out what crossed an open face.
/// @return their last rows for tracks.csv, on rank 0
/// @throws RunError  a particle went through a wall
[[nodiscard]] std::string take_out(DryRun& run);

/// @throws RunError  overlaps beyond contact.max_overlap, with the modulus that would do
void require_healthy(const DryRun& run);

}  // namespace porefines::sim
