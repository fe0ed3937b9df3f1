// SPDX-License-Identifier: MPL-2.0
#include "dem/pair_contacts.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "dem/contact_batch.hpp"

namespace porefines::dem {

namespace {

/// Lever arms and separations of a batch of pairs, before the normal is known.
struct PairBatch {
  ContactBatch contact;
  ContactBatch::Lane radius_i, radius_j, inverse_mass, inverse_inertia, arm_i, arm_j;
  ContactBatch::Lane3 spin_i, spin_j;
};

/// Copies what pair (i, j) needs into lane k. `normal` holds x_i - x_j for now.
inline void gather(const Particles& p, std::uint32_t i, std::uint32_t j, int k,
                   const Evaluation& evaluation, PairBatch& b) {
  b.contact.normal.set(k, p.position[i] - p.position[j]);
  b.contact.slip.set(k, p.velocity[i] - p.velocity[j]);
  b.spin_i.set(k, p.angular_velocity[i]);
  b.spin_j.set(k, p.angular_velocity[j]);
  b.radius_i[k] = p.radius[i], b.radius_j[k] = p.radius[j];
  b.inverse_mass[k] = p.inverse_mass[i] + p.inverse_mass[j];
  b.inverse_inertia[k] = p.inverse_inertia[i] + p.inverse_inertia[j];
  if (evaluation.creeping) {
    const auto& turning = p.creeping.spin_resistance;
    b.inverse_mass[k] = std::numeric_limits<Real>::infinity();
    b.inverse_inertia[k] = (1 / turning[i] + 1 / turning[j]) / std::max(evaluation.dt, 1e-30);
  }
}

/// Normal, overlap and relative motion at the point of contact, which lies in the middle of the
/// overlap: both bodies take their forces at the same point, so angular momentum is kept.
void resolve_geometry(PairBatch& b) {
  ContactBatch& c = b.contact;
  const int lanes = (c.count + 7) / 8 * 8;
#pragma omp simd
  for (int k = 0; k < lanes; ++k) {
    const Vec3 d = c.normal.get(k);
    const Real distance = std::sqrt(dot(d, d));
    const Vec3 n = (1 / distance) * d;
    const Real overlap = b.radius_i[k] + b.radius_j[k] - distance;
    const Real arm_i = b.radius_i[k] - 0.5 * overlap;
    const Real arm_j = b.radius_j[k] - 0.5 * overlap;
    const Vec3 wi = b.spin_i.get(k);
    const Vec3 wj = b.spin_j.get(k);
    c.normal.set(k, n);
    c.slip.set(k, c.slip.get(k) - cross(arm_i * wi + arm_j * wj, n));
    c.spin.set(k, wi - wj);
    c.overlap[k] = overlap;
    b.arm_i[k] = arm_i, b.arm_j[k] = arm_j;
    c.radius[k] = b.radius_i[k] * b.radius_j[k] / (b.radius_i[k] + b.radius_j[k]);
    c.mass[k] = 1 / b.inverse_mass[k];
    c.inertia[k] = 1 / b.inverse_inertia[k];
  }
}

/// Adds lane k's force and torques to its particles.
inline void scatter(const PairBatch& b, int k, std::uint32_t i, std::uint32_t j, Particles& p) {
  const Vec3 force = b.contact.force.get(k);
  const Vec3 turning = cross(b.contact.normal.get(k), force);
  const Vec3 couple = b.contact.couple.get(k);
  p.force[i] += force;
  p.force[j] -= force;
  p.torque[i] += couple - b.arm_i[k] * turning;
  p.torque[j] -= couple + b.arm_j[k] * turning;
}

}  // namespace

ContactHistory PairContacts::history_of(std::size_t pair) const {
  HistoryNumbers numbers{};
  std::copy_n(history_.begin() + static_cast<std::ptrdiff_t>(pair) * length_, length_,
              numbers.begin());
  return std::bit_cast<ContactHistory>(numbers);
}

void PairContacts::clear() {
  list_ = {};
  touching_.clear(), history_.clear(), near_.clear();
}

void PairContacts::build(const Particles& p, Real skin, const KeptContacts& kept) {
  find_pairs(p, skin, list_);
  drop_immobile(p);
  touching_.assign(list_.size(), 0);
  history_.assign(list_.size() * length_, 0);
  for (std::size_t k = 0; k < list_.size(); ++k) {
    const std::uint64_t partner = p.id[list_.second[k]];
    for (const KeptContact& contact : kept.of(list_.first[k])) {
      if (contact.partner == partner) {
        touching_[k] = 1;
        const auto numbers = std::bit_cast<HistoryNumbers>(contact.history);
        std::copy_n(numbers.begin(), length_,
                    history_.begin() + static_cast<std::ptrdiff_t>(k) * length_);
      }
    }
  }
}

/// Two held particles do not move each other.
void PairContacts::drop_immobile(const Particles& p) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < list_.size(); ++k) {
    if (p.inverse_mass[list_.first[k]] + p.inverse_mass[list_.second[k]] > 0) {
      list_.first[count] = list_.first[k];
      list_.second[count++] = list_.second[k];
    }
  }
  list_.first.resize(count), list_.second.resize(count);
}

void PairContacts::narrow(const Particles& p, Real window) {
  near_.clear();
  for (std::uint32_t k = 0; k < list_.size(); ++k) {
    const std::uint32_t i = list_.first[k];
    const std::uint32_t j = list_.second[k];
    const Vec3 d = p.position[i] - p.position[j];
    const Real range = p.radius[i] + p.radius[j] + window;
    if (dot(d, d) < range * range) {
      near_.push_back(k);
    } else if (touching_[k] != 0) {
      touching_[k] = 0;
      std::fill_n(history_.begin() + static_cast<std::ptrdiff_t>(k) * length_, length_, 0.0);
    }
  }
}

void PairContacts::add_forces(const ContactModel& model, const MaterialTable& materials,
                              const Evaluation& evaluation, Particles& p) {
  find_touching(p);
  const int species = materials.count();
  with_law(model, [&](const auto& law) {
    static thread_local PairBatch b{};
    for (std::size_t first = 0; first < touch_.size(); first += batch_width) {
      const int count = static_cast<int>(std::min<std::size_t>(batch_width, touch_.size() - first));
      b.contact.count = count;
      for (int k = 0; k < count; ++k) {
        const std::uint32_t pair = touch_[first + k];
        const std::uint32_t i = list_.first[pair];
        const std::uint32_t j = list_.second[pair];
        gather(p, i, j, k, evaluation, b);
        b.contact.pair[k] = p.species[i] * species + p.species[j];
        b.contact.load_history(k, history_.data() + std::size_t{pair} * length_, length_);
      }
      resolve_geometry(b);
      evaluate(law, materials.pairs(), evaluation.dt, b.contact);
      for (int k = 0; k < count; ++k) {
        const std::uint32_t pair = touch_[first + k];
        scatter(b, k, list_.first[pair], list_.second[pair], p);
        b.contact.store_history(k, history_.data() + std::size_t{pair} * length_, length_);
      }
      for (int k = 0; k < count; ++k) {
        const Real smaller = std::min(b.radius_i[k], b.radius_j[k]);
        largest_overlap_ = std::max(largest_overlap_, b.contact.overlap[k] / smaller);
      }
    }
  });
}

void PairContacts::find_touching(const Particles& p) {
  touch_.resize(near_.size());
  std::size_t count = 0;
  for (const std::uint32_t k : near_) {
    const std::uint32_t i = list_.first[k];
    const std::uint32_t j = list_.second[k];
    const Vec3 d = p.position[i] - p.position[j];
    const Real range = p.radius[i] + p.radius[j];
    if (dot(d, d) < range * range) {
      touching_[k] = 1;
      touch_[count++] = k;
    } else if (touching_[k] != 0) {
      touching_[k] = 0;
      std::fill_n(history_.begin() + static_cast<std::ptrdiff_t>(k) * length_, length_, 0.0);
    }
  }
  touch_.resize(count);
}

}  // namespace porefines::dem
