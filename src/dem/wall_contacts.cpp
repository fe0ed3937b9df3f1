// SPDX-License-Identifier: MPL-2.0
#include "dem/wall_contacts.hpp"

#include <algorithm>
#include <bit>

#include "dem/contact_batch.hpp"
#include "dem/pair_state.hpp"

namespace porefines::dem {

namespace {

constexpr Real trusted =
    0.9;  ///< share of a gap that a particle may go before it is looked at again

/// A fixed surface has no Motion; moving primitives tell how fast they come.
Real speed_bound(const Surface& surface, const Particles& p) {
  Real bound = 0;
  const auto* walls = std::get_if<Primitives>(&surface);
  for (std::size_t w = 0; walls != nullptr && w < walls->size(); ++w) {
    const Motion& motion = std::visit([](const auto& wall) { return wall.motion; }, (*walls)[w]);
    Real farthest = 0;
    for (std::size_t i = 0; dot(motion.spin, motion.spin) > 0 && i < p.owned; ++i) {
      farthest = std::max(farthest, norm(p.position[i] - motion.about) + 2 * p.radius[i]);
    }
    bound = std::max(bound, norm(motion.velocity) + norm(motion.spin) * farthest);
  }
  return bound;
}

void fill(const ContactState& c, int k, ContactBatch& b) {
  b.normal.set(k, c.normal), b.slip.set(k, c.slip), b.spin.set(k, c.spin);
  b.overlap[k] = c.overlap, b.radius[k] = c.radius, b.mass[k] = c.mass, b.inertia[k] = c.inertia;
}

}  // namespace

WallContacts::WallContacts(Surfaces surfaces, std::vector<std::uint16_t> species, int history)
    : surfaces_(std::move(surfaces)), species_(std::move(species)), length_(history) {}

void WallContacts::find(const Particles& p, std::uint32_t i, std::uint32_t surface, Real reach) {
  touches_.clear();
  find_touches(surfaces_[surface], p.position[i], p.radius[i], reach, touches_);
  trouble_.lost += touches_.lost;
  trouble_.inside += touches_.inside ? 1 : 0;
  trouble_.uncovered += touches_.uncovered ? 1 : 0;
}

/// The same, from the last search where the surface stays and the particle has hardly moved since.
void WallContacts::find_again(const Particles& p, const Candidate& c, Real reach, Sight& sight) {
  const Vec3& x = p.position[c.particle];
  touches_.clear();
  if (!sight.recall(x, p.radius[c.particle], reach, touches_)) {
    find(p, c.particle, c.surface, reach);
    if (is_still_[c.surface] != 0 && !touches_.in_trouble()) {
      sight.keep(x, reach, touches_);
    }
  }
}

void WallContacts::forget_sights() {
  for (Sights& sights : sights_) {
    sights.touching.forget(), sights.near.forget();
  }
}

void WallContacts::build(const Particles& p, Real skin, Real moved, const KeptContacts& kept) {
  candidates_.clear(), entries_.clear(), anchors_.clear(), is_still_.clear();
  largest_speed_ = 0;
  ahead_ = skin;
  for (const Surface& surface : surfaces_) {
    const Real speed = speed_bound(surface, p);
    largest_speed_ = std::max(largest_speed_, speed);
    is_still_.push_back(speed == 0 ? 1 : 0);
  }
  for (std::uint32_t i = 0; !empty() && i < p.owned; ++i) {
    for (std::uint32_t part = 0; p.inverse_mass[i] > 0 && part < surfaces_.size(); ++part) {
      find(p, i, part, skin);
      if (touches_.count == 0 && !touches_.in_trouble()) {
        continue;
      }
      const auto first = static_cast<std::uint32_t>(entries_.size());
      for (const KeptContact& contact : kept.of(i)) {
        const auto feature = static_cast<std::uint32_t>(contact.partner);
        if (contact.partner >= wall_partner(0) && feature >> surface_shift == part) {
          entries_.push_back({feature, contact.normal, contact.history});
        }
      }
      const auto count = static_cast<std::uint32_t>(entries_.size()) - first;
      const Real gap = touches_.in_trouble() ? 0 : std::max<Real>(nearest_gap(skin), 0);
      candidates_.push_back({i, part, first, count, moved});
      anchors_.push_back({p.position[i], is_still_[part] != 0 ? trusted * gap : 0});
    }
  }
  sights_.resize(p.creeps ? candidates_.size() : 0);
  forget_sights();
}

/// [m] of the last search, at most `reach`.
Real WallContacts::nearest_gap(Real reach) const {
  Real gap = reach;
  for (const Touch& touch : touches_.view()) {
    gap = std::min(gap, touch.gap);
  }
  return gap;
}

/// Has a candidate that touched nothing gone less far than its gap to a surface that stays? `moved`
/// is the way of the fastest particle of all; its own is shorter.
bool WallContacts::stays_clear(const Particles& p, Real moved, std::size_t candidate) {
  Candidate& c = candidates_[candidate];
  const Anchor& anchor = anchors_[candidate];
  const Real left = anchor.gap - norm(p.position[c.particle] - anchor.at);
  if (c.count > 0 || left <= 0) {
    return false;
  }
  c.clear = moved + left;
  touches_.clear();
  return true;
}

/// Finds what a candidate touches now, or until when it cannot. Forces always come from a search
/// without reach: shares may depend on what else is in the list.
void WallContacts::look(const Particles& p, Real moved, bool creeping, std::size_t candidate) {
  if (stays_clear(p, moved, candidate)) {
    return;
  }
  Candidate& c = candidates_[candidate];
  if (c.count == 0) {
    find(p, c.particle, c.surface, ahead_);
    const Real gap = nearest_gap(ahead_);
    if (gap >= 0 && !touches_.in_trouble()) {
      const bool still = is_still_[c.surface] != 0;
      anchors_[candidate] = {p.position[c.particle], still ? trusted * gap : 0};
      c.clear = moved + (still ? trusted * gap : gap / 2);  // both may have moved
      touches_.clear();
      return;
    }
  }
  if (creeping) {
    find_again(p, c, 0, sights_[candidate].touching);
  } else {
    find(p, c.particle, c.surface, 0);
  }
  c.clear = moved;
  for (int t = 0; t < touches_.count; ++t) {
    touches_.touch[t].feature |= c.surface << surface_shift;
  }
}

/// Calls add(touch, history) for every touch of a candidate with what it remembers.
template <typename Add>
void WallContacts::match(const Candidate& c, const TouchList& touches, const Add& add) const {
  const std::span<const Entry> before{entries_.data() + c.first, c.count};
  const auto found = match_histories(touches.view(), before);
  for (int t = 0; t < touches.count; ++t) {
    const int was = found[t];
    add(touches.touch[t], was >= 0 ? before[was].history : ContactHistory{});
  }
}

void WallContacts::add_forces(const ContactModel& model, const MaterialTable& materials,
                              const Evaluation& evaluation, Real moved, Particles& p) {
  next_.clear(), standing_.clear();
  with_law(model, [&](const auto& law) {
    static thread_local ContactBatch b{};
    std::array<Filled, batch_width> filled;
    b.count = 0;
    const auto flush = [&] {
      evaluate(law, materials.pairs(), evaluation, b);
      for (int k = 0; k < b.count; ++k) {
        const auto [i, entry, share] = filled[k];
        const Vec3 force = share * b.force.get(k);
        const Real arm = p.radius[i] - 0.5 * b.overlap[k];
        p.force[i] += force;
        p.torque[i] += share * b.couple.get(k) - arm * cross(b.normal.get(k), force);
        p.pushed[i] = 1;
        HistoryNumbers numbers{};
        b.store_history(k, numbers.data(), length_);
        next_[entry].history = std::bit_cast<ContactHistory>(numbers);
        largest_overlap_ = std::max(largest_overlap_, b.overlap[k] / p.radius[i]);
        if (evaluation.account) {
          spent_.add(b.spent(k), share);
        }
      }
      b.count = 0;
    };
    for (std::size_t q = 0; q < candidates_.size(); ++q) {
      Candidate& c = candidates_[q];
      const auto first = static_cast<std::uint32_t>(next_.size());
      if (c.count > 0 || c.clear <= moved) {
        look(p, moved, evaluation.creeping, q);
        match(c, touches_, [&](const Touch& touch, const ContactHistory& history) {
          next_.push_back({touch.feature, touch.normal, history});
          const int k = b.count++;
          fill(wall_state(p, c.particle, touch), k, b);
          if (evaluation.creeping) {
            standing_.push_back(touch);
            b.mass[k] = 0;
            b.inertia[k] = p.creeping.spin_resistance[c.particle] * std::max(evaluation.dt, 1e-30);
          }
          b.pair[k] = p.species[c.particle] * materials.count() + species_[c.surface];
          b.load_history(k, std::bit_cast<HistoryNumbers>(history).data(), length_);
          filled[k] = {c.particle, static_cast<std::uint32_t>(next_.size() - 1), touch.share};
          if (b.count == batch_width) {
            flush();
          }
        });
      }
      c.first = first;
      c.count = static_cast<std::uint32_t>(next_.size()) - first;
    }
    flush();
  });
  entries_.swap(next_);
}

void WallContacts::for_contacts(const Particles& p, const MaterialTable& materials,
                                const Report& report) const {
  TouchList touches;
  for (const Candidate& c : candidates_) {
    touches.clear();
    find_touches(surfaces_[c.surface], p.position[c.particle], p.radius[c.particle], 0, touches);
    for (int t = 0; t < touches.count; ++t) {
      touches.touch[t].feature |= c.surface << surface_shift;
    }
    const PairMaterial& pair = materials.pair(p.species[c.particle], species_[c.surface]);
    match(c, touches, [&](const Touch& touch, const ContactHistory& history) {
      report(c.particle, pair, wall_state(p, c.particle, touch), history, touch.share,
             touch.feature);
    });
  }
}

void WallContacts::advance(Real dt) {
  for (Surface& surface : surfaces_) {
    if (auto* walls = std::get_if<Primitives>(&surface)) {
      dem::advance(*walls, dt);
    }
  }
}

}  // namespace porefines::dem
