// SPDX-License-Identifier: MPL-2.0
// Sums over particles and contacts: System's queries.
#include <algorithm>
#include <array>
#include <numbers>

#include "dem/pair_state.hpp"
#include "dem/system.hpp"

namespace porefines::dem {

namespace {

/// Energy in the springs of one contact [J].
struct Stored {
  Real normal = 0;
  Real shear = 0;
  Real rolling = 0;
};

/// Partial slip is counted as if it were elastic.
Stored stored(const ContactModel& model, const PairMaterial& pair, const ContactState& c,
              const ContactHistory& h) {
  const NormalResponse r = std::visit([&](const auto& n) { return n(pair, c); }, model.normal);
  Stored energy;
  energy.normal = std::visit([&](const auto& n) { return n.energy(pair, c); }, model.normal);
  if (r.shear_stiffness > 0) {
    energy.shear = dot(h.shear, h.shear) / (2 * r.shear_stiffness);
  }
  const Real arm = pair.rolling * c.radius;
  const Real rolling_stiffness = 2.25 * r.stiffness * arm * arm;
  if (rolling_stiffness > 0) {
    energy.rolling = dot(h.rolling, h.rolling) / (2 * rolling_stiffness);
  }
  return energy;
}

/// Adds up the contacts and their energy; those across ranks count half on each.
struct ContactSums {
  Real pairs = 0;
  Real walls = 0;
  Stored stored;
  void add(const Stored& one, Real share) {
    stored.normal += share * one.normal, stored.shear += share * one.shear;
    stored.rolling += share * one.rolling;
  }
};

}  // namespace

Totals System::totals() const {
  const Particles& p = particles_;
  Vec3 momentum;
  Vec3 angular;
  Real kinetic = 0;
  Real rotational = 0;
  Real potential = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    momentum += p.mass[i] * p.velocity[i];
    angular +=
        p.mass[i] * cross(p.position[i], p.velocity[i]) + p.inertia(i) * p.angular_velocity[i];
    kinetic += 0.5 * p.mass[i] * dot(p.velocity[i], p.velocity[i]);
    rotational += 0.5 * p.inertia(i) * dot(p.angular_velocity[i], p.angular_velocity[i]);
    potential -= p.mass[i] * dot(settings_.gravity, p.position[i]);
  }
  ContactSums contacts;
  pairs_.for_touching([&](std::uint32_t i, std::uint32_t j, const ContactHistory& history) {
    const Real share = j < p.owned ? 1 : 0.5;  // the other half is on the ghost's owner
    contacts.pairs += share;
    const PairMaterial& pair = settings_.materials.pair(p.species[i], p.species[j]);
    contacts.add(stored(settings_.model, pair, pair_state(p, i, j), history), share);
  });
  walls_.for_contacts(p, settings_.materials,
                      [&](std::uint32_t /*i*/, const PairMaterial& pair, const ContactState& c,
                          const ContactHistory& h, Real share, std::uint32_t /*feature*/) {
                        contacts.walls += 1;
                        contacts.add(stored(settings_.model, pair, c, h), share);
                      });
  Spent spent = pairs_.spent();
  spent.add(walls_.spent(), 1);
  const Stored& held = contacts.stored;
  spent.sliding -= held.shear, spent.rolling -= held.rolling;
  std::array<Real, 16> sums{static_cast<Real>(p.owned),
                            contacts.pairs,
                            contacts.walls,
                            momentum.x,
                            momentum.y,
                            momentum.z,
                            angular.x,
                            angular.y,
                            angular.z,
                            kinetic,
                            rotational,
                            potential,
                            held.normal + held.shear + held.rolling,
                            spent.normal,
                            spent.sliding,
                            spent.rolling};
  comm_.sum(sums);
  const auto whole = [&sums](int at) { return static_cast<Index>(std::llround(sums[at])); };
  Totals t;
  t.particles = whole(0), t.contacts = whole(1), t.wall_contacts = whole(2);
  t.momentum = {sums[3], sums[4], sums[5]}, t.angular_momentum = {sums[6], sums[7], sums[8]};
  t.kinetic = sums[9], t.rotational = sums[10], t.potential = sums[11], t.elastic = sums[12];
  t.dissipated = settings_.account ? Spent{sums[13], sums[14], sums[15]} : Spent{};
  return t;
}

std::vector<ContactRecord> System::contacts() const {
  const Particles& p = particles_;
  std::vector<ContactRecord> records;
  with_law(settings_.model, [&](const auto& law) {
    pairs_.for_touching([&](std::uint32_t i, std::uint32_t j, ContactHistory history) {
      const PairMaterial& pair = settings_.materials.pair(p.species[i], p.species[j]);
      const ContactState c = pair_state(p, i, j);
      const ContactForce f = law(pair, c, 0, history);
      records.push_back({p.id[i], p.id[j], false, c.normal, c.overlap, f.force});
    });
    walls_.for_contacts(
        p, settings_.materials,
        [&](std::uint32_t i, const PairMaterial& pair, const ContactState& c, ContactHistory h,
            Real share, std::uint32_t feature) {
          const ContactForce f = law(pair, c, 0, h);
          records.push_back({p.id[i], feature, true, c.normal, c.overlap, share * f.force});
        });
  });
  return records;
}

Real System::largest_overlap() const {
  return comm_.max(std::max(pairs_.largest_overlap(), walls_.largest_overlap()));
}

void System::reset_largest_overlap() {
  pairs_.reset_largest_overlap();
  walls_.reset_largest_overlap();
}

Real System::top_speed() const {
  Real square = 0;
  for (std::size_t i = 0; i < particles_.owned; ++i) {
    square = std::max(square, dot(particles_.velocity[i], particles_.velocity[i]));
  }
  return comm_.max(std::sqrt(square));
}

Real System::contact_duration(Real speed) const {
  Real shortest = 1e300;
  const Particles& p = particles_;
  const auto duration = [&](const PairMaterial& pair, Real mass, Real radius) {
    if (const auto* linear = std::get_if<LinearSpring>(&settings_.model.normal)) {
      return std::numbers::pi * std::sqrt(mass / linear->stiffness);
    }
    return 2.868266 * std::pow(mass * mass / (radius * pair.modulus * pair.modulus * speed), 0.2);
  };
  for (std::size_t i = 0; i < p.owned; ++i) {  // a pair's duration lies between those with a twin
    for (int other = 0; other < settings_.materials.count(); ++other) {
      const PairMaterial& pair = settings_.materials.pair(p.species[i], other);
      shortest = std::min(shortest, duration(pair, p.mass[i] / 2, p.radius[i] / 2));
    }
  }
  return comm_.min(shortest);
}

}  // namespace porefines::dem
