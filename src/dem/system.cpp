// SPDX-License-Identifier: MPL-2.0
#include "dem/system.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/motion.hpp"

namespace porefines::dem {

namespace {

Settings completed(Settings settings, const par::Communicator& comm) {
  if (settings.blocks.cuts[0].empty()) {
    settings.blocks = even_blocks(settings.box, comm.size(), settings.gravity);
  }
  settings.wall_species.resize(settings.walls.size(), 0);
  for (const std::uint16_t species : settings.wall_species) {
    if (species >= settings.materials.count()) {
      throw InputError(fmt::format("a wall is of species {}, but there are {}: number them from 0",
                                   species, settings.materials.count()));
    }
  }
  return settings;
}

void check(const Body& body, const Settings& settings) {
  if (!(body.radius > 0) || !(body.density > 0)) {
    throw InputError(
        fmt::format("particle {}: radius {:g} m, density {:g} kg/m^3: both must be positive",
                    body.id, body.radius, body.density));
  }
  if (body.species >= settings.materials.count()) {
    throw InputError(fmt::format("particle {}: species {}, but there are {}: number them from 0",
                                 body.id, body.species, settings.materials.count()));
  }
  for (int a = 0; a < 3; ++a) {
    const Real x = body.position[a];
    const bool inside = x >= settings.box.low[a] && x <= settings.box.high[a];
    if (!std::isfinite(x) || (!inside && !settings.box.periodic[a])) {
      throw InputError(fmt::format("particle {}: {} = {:g} m is outside the box [{:g}, {:g}]",
                                   body.id, "xyz"[a], x, settings.box.low[a],
                                   settings.box.high[a]));
    }
  }
}

}  // namespace

System::System(const par::Communicator& comm, Settings settings)
    : comm_(comm),
      settings_(completed(std::move(settings), comm)),
      exchange_(comm, settings_.box, settings_.blocks),
      pairs_(history_length(settings_.model)),
      walls_(settings_.walls, settings_.wall_species, history_length(settings_.model)) {}

void System::insert(std::span<const Body> bodies) {
  for (const Body& body : bodies) {
    check(body, settings_);
  }
  keep_contacts();
  for (const Body& body : bodies) {
    Body inside = body;
    inside.position = settings_.box.wrapped(body.position);
    inside.density += settings_.added_density;
    if (settings_.blocks.owner(inside.position) == comm_.rank()) {
      particles_.append(inside);
      kept_.append({});
    }
  }
  if (!bodies.empty()) {
    find_contacts();
  }
}

Index System::remove(const std::function<bool(const Particles&, std::size_t)>& gone) {
  std::vector<std::uint32_t> order;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    if (!gone(particles_, i)) {
      order.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const auto left = static_cast<Index>(particles_.owned - order.size());
  if (comm_.sum(left) > 0) {
    keep_contacts();
    particles_.reorder(order), kept_.reorder(order);
    particles_.owned = order.size();
    find_contacts();
  }
  return left;
}

void System::rebuild() {
  keep_contacts();
  forces_hold_ = false;
}

void System::advance(Real dt, Index steps) {
  if (steps == 0) {
    return;
  }
  prepare();
  moves_ = true;
  const Kick motion{settings_.gravity, dt, has_external_forces(particles_)};
  for (Index step = 0; step < steps; ++step) {
    const int kicks = step == 0 ? 1 : 2;
    const Real speed_squared = kick_and_drift(particles_, motion, kicks, true);
    walls_.advance(dt);
    update_lists(std::sqrt(speed_squared), dt);
    contact_forces({dt, false, settings_.account});
    ++work_.steps;
  }
  kick_and_drift(particles_, motion, 1, false);
  check_walls();
}

void System::update_lists(Real fastest, Real dt) {
  fastest = std::max(fastest, walls_.largest_speed());
  fastest = comm_.size() > 1 ? comm_.max(fastest) : fastest;
  if (!std::isfinite(fastest)) {
    throw RunError(fmt::format(
        "a particle's velocity is no longer a number at step {} ({:g} s a step): try a smaller "
        "step, or look for particles that start deep inside each other",
        work_.steps, dt));
  }
  moved_per_step_ = fastest * dt;
  moved_ += moved_per_step_;
  moved_narrow_ += moved_per_step_;
  if (2 * moved_ > skin_) {
    keep_contacts();
    build_lists(true);
    return;
  }
  const bool narrow = 2 * moved_narrow_ > window_;
  exchange_.refresh(particles_, narrow);
  if (narrow) {
    narrow_lists();
  }
  work_.messages = exchange_.messages();
}

void System::contact_forces(const Evaluation& evaluation) {
  pairs_.add_forces(settings_.model, settings_.materials, evaluation, particles_);
  if (!walls_.empty()) {
    walls_.add_forces(settings_.model, settings_.materials, evaluation, moved_, particles_);
  }
}

void System::soften(Real factor) {
  settings_.materials.soften(factor);
}

void System::prepare() {
  if (comm_.max(lists_hold_ ? 0.0 : 1.0) > 0) {
    keep_contacts();
    build_lists(true);
  }
  if (comm_.max(forces_hold_ ? 0.0 : 1.0) > 0) {
    particles_.clear_forces();
    contact_forces({0, particles_.creeps && settings_.added_density == 0});
    forces_hold_ = true;
  }
}

/// Contacts and forces of the moment, after particles came or went.
void System::find_contacts() {
  if (!moves_) {
    skin_ = 0;  // not all particles of the start were there when it was chosen
  }
  forces_hold_ = false;
  prepare();
}

void System::check_walls() const {
  const Index stuck = walls_.trouble().lost + walls_.trouble().uncovered;
  const Index anywhere = walls_.empty() ? 0 : comm_.sum(stuck);
  if (anywhere > 0) {
    throw RunError(fmt::format(
        "{} contacts with walls could not be found: more than {} touches on one particle, or a "
        "particle beyond the known part of the grains",
        anywhere, TouchList::capacity));
  }
}

}  // namespace porefines::dem
