// SPDX-License-Identifier: MPL-2.0
// Neighbour lists of a System, and what outlives them: histories and snapshots.
#include <algorithm>

#include "dem/system.hpp"

namespace porefines::dem {

namespace {

/// Share of the mean diameter that pairs are listed beyond contact.
constexpr Real default_skin = 0.2;
/// Steps that a narrowed list should last.
constexpr Real narrow_steps = 32;

}  // namespace

/// Hands the history of every contact to its particles and drops lists and ghosts.
void System::keep_contacts() {
  if (!lists_hold_) {
    return;
  }
  kept_ = collected_contacts();
  particles_.resize(particles_.owned);
  pairs_.clear();
  lists_hold_ = false;
}

void System::build_lists(bool sort) {
  if (skin_ == 0) {
    Real radii = 0;
    for (std::size_t i = 0; i < particles_.owned; ++i) {
      radii += particles_.radius[i];
    }
    const Index count = comm_.sum(static_cast<Index>(particles_.owned));
    const Real mean = count == 0 ? 0 : 2 * comm_.sum(radii) / static_cast<Real>(count);
    skin_ = settings_.skin > 0 ? settings_.skin : default_skin * mean;
  }
  if (sort) {
    exchange_.migrate(particles_, kept_);
    const Real largest = particles_.owned == 0 ? 0.0
                                               : *std::max_element(particles_.radius.begin(),
                                                                   particles_.radius.end());
    const auto order = spatial_order(particles_, 2 * largest + skin_);
    particles_.reorder(order), kept_.reorder(order);
    moved_ = 0;
  }
  exchange_.make_ghosts(particles_, skin_ + 2 * moved_);
  pairs_.build(particles_, skin_, kept_, settings_.materials.count());
  walls_.build(particles_, skin_, moved_, kept_);
  lists_hold_ = true;
  ++work_.rebuilds;
  work_.listed_pairs = static_cast<Index>(pairs_.list().size());
  narrow_lists();
  work_.messages = exchange_.messages();
}

void System::narrow_lists() {
  const Real left = skin_ - 2 * moved_;
  window_ = std::min(left, std::max(2 * narrow_steps * moved_per_step_, skin_ / 16));
  moved_narrow_ = 0;
  pairs_.narrow(particles_, window_);
  exchange_.restrict_to(pairs_.marked_near(particles_.size()), particles_.owned);
  ++work_.narrowings;
}

Snapshot System::save() const {
  Snapshot s;
  s.particles = particles_;
  s.particles.resize(particles_.owned);
  s.walls = walls_.surfaces();
  s.skin = skin_, s.moved = moved_, s.listed = lists_hold_;
  s.spent_among = pairs_.spent(), s.spent_on_walls = walls_.spent();
  s.largest_overlap = std::max(pairs_.largest_overlap(), walls_.largest_overlap());
  s.contacts = lists_hold_ ? collected_contacts() : kept_;
  return s;
}

/// Every particle's contacts, with other particles first, then with walls.
KeptContacts System::collected_contacts() const {
  KeptContacts kept;
  kept.start.assign(particles_.owned + 1, 0);
  const auto for_ends = [this](const auto& visit) {  // visit(particle, partner, history, normal)
    pairs_.for_touching([&](std::uint32_t i, std::uint32_t j, const ContactHistory& history) {
      visit(i, KeptContact{particles_.id[j], history, {}});
      if (j < particles_.owned) {
        visit(j, KeptContact{particles_.id[i], seen_by_partner(history), {}});
      }
    });
    walls_.for_touching([&](std::uint32_t i, const KeptContact& contact) { visit(i, contact); });
  };
  for_ends([&](std::uint32_t i, const KeptContact&) { ++kept.start[i + 1]; });
  for (std::size_t i = 1; i < kept.start.size(); ++i) {
    kept.start[i] += kept.start[i - 1];
  }
  kept.entries.resize(kept.start.back());
  std::vector<std::uint32_t> next(kept.start.begin(), kept.start.end() - 1);
  for_ends([&](std::uint32_t i, const KeptContact& contact) { kept.entries[next[i]++] = contact; });
  return kept;
}

void System::restore(Snapshot snapshot, bool same_ranks) {
  particles_ = std::move(snapshot.particles);
  kept_ = std::move(snapshot.contacts);
  walls_ = WallContacts(snapshot.walls, settings_.wall_species, history_length(settings_.model));
  skin_ = snapshot.skin;
  moved_ = snapshot.moved;
  pairs_.reset_spent(snapshot.spent_among);
  walls_.reset_spent(snapshot.spent_on_walls);
  pairs_.reset_largest_overlap(snapshot.largest_overlap);
  moves_ = true;
  lists_hold_ = false;
  forces_hold_ = true;
  if (same_ranks && snapshot.listed) {
    build_lists(false);
  }
}

}  // namespace porefines::dem
