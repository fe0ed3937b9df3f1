// SPDX-License-Identifier: MPL-2.0
// Forces of touching pairs, in vector registers: gather, geometry, law, scatter.
#include <algorithm>

#include "dem/contact_batch.hpp"
#include "dem/pair_contacts.hpp"

namespace porefines::dem {

namespace {

/// A batch of pairs with the lever arms of their forces.
struct PairBatch {
  ContactBatch contact;
  ContactBatch::Lane arm_i, arm_j;
  ContactBatch::Lane3 torque_i, torque_j;
};

/// Copies what does not need the particles from the touching pairs [first, first + count).
void load(const TouchingPairs& t, std::size_t first, int length, PairBatch& b) {
  ContactBatch& c = b.contact;
  const auto at = static_cast<std::ptrdiff_t>(first);
  std::copy_n(t.radius.begin() + at, c.count, c.radius.begin());
  std::copy_n(t.mass.begin() + at, c.count, c.mass.begin());
  std::copy_n(t.inertia.begin() + at, c.count, c.inertia.begin());
  std::copy_n(t.row.begin() + at, c.count, c.pair.begin());
  for (int h = 0; h < length; ++h) {
    std::copy_n(t.history[h].begin() + at, c.count, c.history[h].begin());
  }
}

void store(const PairBatch& b, std::size_t first, int length, TouchingPairs& t) {
  for (int h = 0; h < length; ++h) {
    std::copy_n(b.contact.history[h].begin(), b.contact.count,
                t.history[h].begin() + static_cast<std::ptrdiff_t>(first));
  }
}

[[gnu::always_inline]] inline Vec3 at(const Real* values, std::int32_t i) {
  return {values[i], values[i + 1], values[i + 2]};
}

/// Normal, overlap and relative motion at the point of contact, which lies in the middle of the
/// overlap: both bodies take their forces at the same point, so angular momentum is kept.
void gather(const Particles& p, const TouchingPairs& t, std::size_t begin, PairBatch& b) {
  ContactBatch& c = b.contact;
  const Real* x = &p.position[0].x;
  const Real* v = &p.velocity[0].x;
  const Real* w = &p.angular_velocity[0].x;
  const std::int32_t* first = t.first.data() + begin;
  const std::int32_t* second = t.second.data() + begin;
  const Real* radius_i = t.radius_first.data() + begin;
  const Real* radius_j = t.radius_second.data() + begin;
  const int lanes = (c.count + 7) / 8 * 8;  // padding holds old, valid indices
#pragma omp simd
  for (int k = 0; k < lanes; ++k) {
    const std::int32_t i = 3 * first[k];
    const std::int32_t j = 3 * second[k];
    const Vec3 d = at(x, i) - at(x, j);
    const Real distance = std::sqrt(dot(d, d));
    const Vec3 n = (1 / distance) * d;
    const Real overlap = radius_i[k] + radius_j[k] - distance;
    const Real arm_i = radius_i[k] - 0.5 * overlap;
    const Real arm_j = radius_j[k] - 0.5 * overlap;
    const Vec3 wi = at(w, i);
    const Vec3 wj = at(w, j);
    c.normal.set(k, n);
    c.slip.set(k, at(v, i) - at(v, j) - cross(arm_i * wi + arm_j * wj, n));
    c.spin.set(k, wi - wj);
    c.overlap[k] = overlap;
    b.arm_i[k] = arm_i, b.arm_j[k] = arm_j;
  }
}

/// The liquid in place of mass and inertia, see Evaluation.
void replace_inertia(const Particles& p, const TouchingPairs& t, std::size_t begin, Real dt,
                     ContactBatch& c) {
  const auto& turning = p.creeping.spin_resistance;
  for (int k = 0; k < c.count; ++k) {
    const std::int32_t i = t.first[begin + k];
    const std::int32_t j = t.second[begin + k];
    c.mass[k] = 0;
    c.inertia[k] = std::max(dt, 1e-30) / (1 / turning[i] + 1 / turning[j]);
  }
}

void lever(PairBatch& b) {
  const int lanes = (b.contact.count + 7) / 8 * 8;
#pragma omp simd
  for (int k = 0; k < lanes; ++k) {
    const Vec3 turning = cross(b.contact.normal.get(k), b.contact.force.get(k));
    const Vec3 couple = b.contact.couple.get(k);
    b.torque_i.set(k, couple - b.arm_i[k] * turning);
    b.torque_j.set(k, couple + b.arm_j[k] * turning);
  }
}

void scatter(const PairBatch& b, const TouchingPairs& t, std::size_t begin, Particles& p) {
  for (int k = 0; k < b.contact.count; ++k) {
    const std::int32_t i = t.first[begin + k];
    const std::int32_t j = t.second[begin + k];
    const Vec3 force = b.contact.force.get(k);
    p.force[i] += force, p.force[j] -= force;
    p.torque[i] += b.torque_i.get(k), p.torque[j] -= b.torque_j.get(k);
    p.pushed[i] = 1, p.pushed[j] = 1;
  }
}

[[nodiscard]] Real deepest(const PairBatch& b, const TouchingPairs& t, std::size_t begin) {
  Real most = 0;
  for (int k = 0; k < b.contact.count; ++k) {
    const Real smaller = std::min(t.radius_first[begin + k], t.radius_second[begin + k]);
    most = std::max(most, b.contact.overlap[k] / smaller);
  }
  return most;
}

}  // namespace

void PairContacts::add_forces(const ContactModel& model, const MaterialTable& materials,
                              const Evaluation& evaluation, Particles& p) {
  find_touching(p);
  with_law(model, [&](const auto& law) {
    static thread_local PairBatch b{};
    for (std::size_t begin = 0; begin < touching_.count; begin += batch_width) {
      b.contact.count =
          static_cast<int>(std::min<std::size_t>(batch_width, touching_.count - begin));
      load(touching_, begin, length_, b);
      gather(p, touching_, begin, b);
      if (evaluation.creeping) {
        replace_inertia(p, touching_, begin, evaluation.dt, b.contact);
      }
      evaluate(law, materials.pairs(), evaluation, b.contact);
      lever(b);
      scatter(b, touching_, begin, p);
      store(b, begin, length_, touching_);
      largest_overlap_ = std::max(largest_overlap_, deepest(b, touching_, begin));
      for (int k = 0; evaluation.account && k < b.contact.count; ++k) {
        const bool whole = static_cast<std::size_t>(touching_.second[begin + k]) < p.owned;
        spent_.add(b.contact.spent(k), whole ? 1 : 0.5);  // the other half is on the ghost's owner
      }
    }
  });
}

}  // namespace porefines::dem
