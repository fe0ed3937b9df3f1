// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "dem/contact_model.hpp"
#include "dem/kept_contacts.hpp"
#include "dem/particles.hpp"
#include "dem/surface.hpp"
#include "dem/wall_sight.hpp"

namespace porefines::dem {

/// What the surfaces could not answer: none of it may pass in silence.
struct WallTrouble {
  Index lost = 0;       ///< touches beyond the capacity of a TouchList
  Index inside = 0;     ///< particles whose centre is inside a grain, counted every step
  Index uncovered = 0;  ///< particles beyond the known part of a surface, counted every step
};

/// Contacts of particles with walls and grains: who is near, who touches where, and the history.
class WallContacts {
 public:
  /// @param species  material of each surface
  WallContacts(Surfaces surfaces, std::vector<std::uint16_t> species, int history);

  /// Lists the owned particles nearer than `skin` to a surface, with their history.
  /// @param moved  [m] farthest way of any particle or wall since the lists count it
  void build(const Particles& particles, Real skin, Real moved, const KeptContacts& kept);
  /// @param moved  [m] as for build: a particle is looked at again only when it may have arrived
  void add_forces(const ContactModel& model, const MaterialTable& materials,
                  const Evaluation& evaluation, Real moved, Particles& particles);

  /// Calls visit(i, touch, wall's species) for every touch nearer than `reach`.
  template <typename Visit>
  void for_near(const Particles& particles, Real reach, Real moved, const Visit& visit) {
    for (std::size_t q = 0; q < candidates_.size(); ++q) {
      const Candidate& c = candidates_[q];
      if (c.clear < moved + reach) {
        find_again(particles, c, reach, sights_[q].near);
        for (const Touch& touch : touches_.view()) {
          visit(c.particle, touch, species_[c.surface]);
        }
      }
    }
  }
  /// Looks at every surface afresh: a run that goes on and one that is resumed then see the same.
  void forget_sights();
  /// Moving walls go on for dt.
  void advance(Real dt);
  /// [m/s] no wall moves faster within `reach` of the particles.
  [[nodiscard]] Real largest_speed() const { return largest_speed_; }

  /// Calls visit(i, kept contact) for every touch of the last evaluation.
  template <typename Visit>
  void for_touching(const Visit& visit) const {
    for (const Candidate& c : candidates_) {
      for (std::uint32_t e = c.first; e < c.first + c.count; ++e) {
        const Entry& entry = entries_[e];
        visit(c.particle, KeptContact{wall_partner(entry.feature), entry.history, entry.normal});
      }
    }
  }
  /// Calls visit(i, touch, wall's species, history) for every touch of the last creeping evaluation.
  template <typename Visit>
  void for_standing(const Visit& visit) const {
    for (const Candidate& c : candidates_) {
      for (std::uint32_t e = c.first; e < c.first + c.count; ++e) {
        visit(c.particle, standing_[e], species_[c.surface], entries_[e].history);
      }
    }
  }
  /// The contacts as the law sees them, found afresh: for sums and records.
  using Report = std::function<void(std::uint32_t particle, const PairMaterial& pair,
                                    const ContactState& contact, const ContactHistory& history,
                                    Real share, std::uint32_t feature)>;
  void for_contacts(const Particles& particles, const MaterialTable& materials,
                    const Report& report) const;

  [[nodiscard]] bool empty() const { return surfaces_.empty(); }
  [[nodiscard]] const Surfaces& surfaces() const { return surfaces_; }
  [[nodiscard]] const WallTrouble& trouble() const { return trouble_; }
  [[nodiscard]] Real largest_overlap() const { return largest_overlap_; }
  void reset_largest_overlap(Real to = 0) { largest_overlap_ = to; }
  [[nodiscard]] const Spent& spent() const { return spent_; }
  void reset_spent(const Spent& to) { spent_ = to; }

 private:
  struct Candidate {  ///< a particle near a surface
    std::uint32_t particle;
    std::uint32_t surface;
    std::uint32_t first;  ///< its touches of the last evaluation in entries_
    std::uint32_t count;
    Real clear;  ///< [m] it cannot touch before `moved` gets there
  };
  struct
      Anchor {  ///< where a candidate was when it was last looked at, and how far from the surface
    Vec3 at;
    Real gap = 0;
  };
  struct Entry {  ///< a touch and what it remembers
    std::uint32_t feature;
    Vec3 normal;
    ContactHistory history;
  };
  struct Filled {
    std::uint32_t particle;
    std::uint32_t entry;
    Real share;
  };
  struct Sights {  ///< of a candidate in a creeping flow
    Sight touching, near;
  };
  void find(const Particles& particles, std::uint32_t i, std::uint32_t surface, Real reach);
  void find_again(const Particles& particles, const Candidate& candidate, Real reach, Sight& sight);
  [[nodiscard]] Real nearest_gap(Real reach) const;
  [[nodiscard]] bool stays_clear(const Particles& particles, Real moved, std::size_t candidate);
  void look(const Particles& particles, Real moved, bool creeping, std::size_t candidate);
  template <typename Add>
  void match(const Candidate& candidate, const TouchList& touches, const Add& add) const;

  Surfaces surfaces_;
  std::vector<std::uint16_t> species_;
  int length_;
  std::vector<Candidate> candidates_;
  std::vector<Anchor> anchors_;         ///< of every candidate
  std::vector<Sights> sights_;          ///< of every candidate, where particles creep
  std::vector<std::uint8_t> is_still_;  ///< of every surface: it does not move
  std::vector<Entry> entries_;
  std::vector<Entry> next_;
  std::vector<Touch> standing_;  ///< of every entry, where particles creep
  TouchList touches_;
  WallTrouble trouble_;
  Real ahead_ = 0;  ///< [m] how far around a particle that does not touch is searched
  Real largest_speed_ = 0;
  Real largest_overlap_ = 0;
  Spent spent_;
};

}  // namespace porefines::dem
