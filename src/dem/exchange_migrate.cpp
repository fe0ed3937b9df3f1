// SPDX-License-Identifier: MPL-2.0
// Particles that go to the rank whose block holds them.
#include <array>
#include <cstdlib>

#include "dem/exchange.hpp"
#include "dem/parcels.hpp"

namespace porefines::dem {

namespace {

/// A particle as it travels to a new owner; its kept contacts follow.
struct Traveller {
  Vec3 position, velocity, angular_velocity, force, torque, external_force, external_torque;
  Real radius, mass;
  std::uint64_t id;
  std::uint32_t contacts;
  std::uint16_t species;
  std::uint8_t flags;
};

void pack(const Particles& p, const KeptContacts& kept, std::size_t i,
          std::vector<std::byte>& out) {
  const auto contacts = kept.of(i);
  const Traveller t{p.position[i],
                    p.velocity[i],
                    p.angular_velocity[i],
                    p.force[i],
                    p.torque[i],
                    p.external_force[i],
                    p.external_torque[i],
                    p.radius[i],
                    p.mass[i],
                    p.id[i],
                    static_cast<std::uint32_t>(contacts.size()),
                    p.species[i],
                    p.flags[i]};
  put(out, &t);
  put(out, contacts.data(), contacts.size());
  if (p.creeps) {
    Creeping::for_arrays(p.creeping, [&](const auto& array) { put(out, &array[i]); });
  }
}

void unpack(const std::vector<std::byte>& in, Particles& p, KeptContacts& kept) {
  std::vector<KeptContact> contacts;
  for (const std::byte* at = in.data(); at != in.data() + in.size();) {
    Traveller t;
    at = take(at, &t);
    contacts.resize(t.contacts);
    at = take(at, contacts.data(), contacts.size());
    p.resize(p.owned + 1);
    const std::size_t i = p.owned++;
    p.position[i] = t.position, p.velocity[i] = t.velocity;
    p.angular_velocity[i] = t.angular_velocity;
    p.force[i] = t.force, p.torque[i] = t.torque;
    p.external_force[i] = t.external_force, p.external_torque[i] = t.external_torque;
    p.radius[i] = t.radius, p.mass[i] = t.mass, p.id[i] = t.id;
    p.species[i] = t.species, p.flags[i] = t.flags, p.pushed[i] = 1;
    p.set_fixed(i, (t.flags & flag::fixed) != 0);
    kept.append(contacts);
    if (p.creeps) {
      Creeping::for_arrays(p.creeping, [&](auto& array) { at = take(at, &array[i]); });
    }
  }
}

}  // namespace

bool Exchange::move_along(int axis, Particles& p, KeptContacts& kept) {
  const int parts = blocks_.ranks[axis];
  std::array<std::vector<std::byte>, 2> out;
  std::vector<std::uint32_t> stay;
  for (std::uint32_t i = 0; i < p.owned; ++i) {
    int hops = blocks_.coordinates(blocks_.owner(p.position[i]))[axis] - here_[axis];
    if (box_.periodic[axis] && 2 * std::abs(hops) > parts) {
      hops -= hops > 0 ? parts : -parts;
    }
    if (hops == 0) {
      stay.push_back(i);
    } else {
      pack(p, kept, i, out[hops < 0 ? 0 : 1]);
    }
  }
  if (stay.size() < p.owned) {
    p.reorder(stay), kept.reorder(stay);
    p.owned = stay.size();
  }
  for (int side = 0; side < 2; ++side) {
    const Leg& leg = legs_[axis][side];
    unpack(pass_on(comm_.handle(), out[side], leg.to, leg.from), p, kept);
    messages_ += leg.to >= 0 ? 1 : 0;
  }
  return !out[0].empty() || !out[1].empty();
}

void Exchange::migrate(Particles& p, KeptContacts& kept) {
  for (std::size_t i = 0; i < p.owned; ++i) {
    p.position[i] = box_.wrapped(p.position[i]);
  }
  bool travelled = comm_.size() > 1;
  while (travelled) {  // twice as a rule: one block at a time until nobody moves
    bool moved = false;
    for (int a = 0; a < 3; ++a) {
      moved = (blocks_.ranks[a] > 1 && move_along(a, p, kept)) || moved;
    }
    travelled = comm_.max(moved ? 1.0 : 0.0) > 0;
  }
}

}  // namespace porefines::dem
