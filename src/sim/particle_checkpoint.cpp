// SPDX-License-Identifier: MPL-2.0
#include "sim/particle_checkpoint.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::sim {
namespace {

constexpr int contact_columns = dem::history_size + 3;  ///< history and normal

/// Arrays of particles have no names of their own: they are numbered in for_arrays' order.
std::string name_of(std::size_t array) {
  return fmt::format("particles_{:02}", array);
}

template <typename T>
void put_array(io::Checkpoint& checkpoint, const std::string& name, const T& values) {
  using Value = typename T::value_type;
  if constexpr (std::is_same_v<Value, Vec3>) {
    const Real* first = values.empty() ? nullptr : &values[0].x;
    checkpoint.rows(name, std::span<const Real>(first, 3 * values.size()), 3);
  } else {
    checkpoint.rows(name, std::span<const Value>(values.data(), values.size()));
  }
}

template <typename T>
void get_array(const io::CheckpointReader& reader, const std::string& name, T& values) {
  using Value = typename T::value_type;
  if constexpr (std::is_same_v<Value, Vec3>) {
    const std::vector<Real> numbers = reader.rows<Real>(name, 3);
    values.resize(numbers.size() / 3);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
    }
  } else {
    const std::vector<Value> numbers = reader.rows<Value>(name);
    values.assign(numbers.begin(), numbers.end());
  }
}

void put_contacts(io::Checkpoint& checkpoint, const dem::KeptContacts& contacts) {
  std::vector<std::uint32_t> counts;
  for (std::size_t i = 0; i + 1 < contacts.start.size(); ++i) {
    counts.push_back(contacts.start[i + 1] - contacts.start[i]);
  }
  std::vector<std::uint64_t> partners;
  std::vector<Real> numbers;
  for (const dem::KeptContact& contact : contacts.entries) {
    partners.push_back(contact.partner);
    const auto history = std::bit_cast<dem::HistoryNumbers>(contact.history);
    numbers.insert(numbers.end(), history.begin(), history.end());
    numbers.insert(numbers.end(), {contact.normal.x, contact.normal.y, contact.normal.z});
  }
  checkpoint.rows("contacts_counts", std::move(counts));
  checkpoint.rows("contacts_partners", std::move(partners));
  checkpoint.rows("contacts_numbers", std::move(numbers), contact_columns);
}

dem::KeptContacts get_contacts(const io::CheckpointReader& reader) {
  dem::KeptContacts contacts;
  for (const std::uint32_t count : reader.rows<std::uint32_t>("contacts_counts")) {
    contacts.start.push_back(contacts.start.back() + count);
  }
  const auto partners = reader.rows<std::uint64_t>("contacts_partners");
  const auto numbers = reader.rows<Real>("contacts_numbers", contact_columns);
  if (partners.size() != contacts.start.back()) {
    throw RunError(fmt::format("{}: {} contacts for counts that add up to {}", reader.path(),
                               partners.size(), contacts.start.back()));
  }
  for (std::size_t k = 0; k < partners.size(); ++k) {
    const Real* at = numbers.data() + k * contact_columns;
    dem::HistoryNumbers history;
    std::copy_n(at, dem::history_size, history.begin());
    const Real* n = at + dem::history_size;
    contacts.entries.push_back(
        {partners[k], std::bit_cast<dem::ContactHistory>(history), {n[0], n[1], n[2]}});
  }
  return contacts;
}

/// Where walls of simple shape are: the others do not move.
std::vector<Real> places_of(const dem::Surfaces& walls) {
  std::vector<Real> places;
  for (const dem::Surface& surface : walls) {
    if (const auto* primitives = std::get_if<dem::Primitives>(&surface)) {
      const auto some = dem::places(*primitives);
      places.insert(places.end(), some.begin(), some.end());
    }
  }
  return places;
}

void put_back(const io::CheckpointReader& reader, dem::Surfaces& walls) {
  const auto places = reader.whole<Real>("walls_places");
  if (places.size() != places_of(walls).size()) {
    throw RunError(fmt::format("{}: it has other walls than the case", reader.path()));
  }
  std::span<const Real> left(places);
  for (dem::Surface& surface : walls) {
    if (auto* primitives = std::get_if<dem::Primitives>(&surface)) {
      left = dem::put_back(*primitives, left);
    }
  }
}

}  // namespace

void put_snapshot(io::Checkpoint& checkpoint, const dem::Snapshot& snapshot) {
  std::size_t array = 0;
  dem::Particles::for_arrays(snapshot.particles, [&](const auto& values) {
    put_array(checkpoint, name_of(array++), values);
  });
  put_contacts(checkpoint, snapshot.contacts);
  const dem::Spent& a = snapshot.spent_among;
  const dem::Spent& b = snapshot.spent_on_walls;
  checkpoint.rows("contacts_spent",
                  std::vector<Real>{a.normal, a.sliding, a.rolling, b.normal, b.sliding, b.rolling},
                  6);
  checkpoint.rows("largest_overlap", std::vector<Real>{snapshot.largest_overlap});
  checkpoint.whole("walls_places", places_of(snapshot.walls));
  checkpoint.whole("lists",
                   std::vector<Real>{snapshot.skin, snapshot.moved, snapshot.listed ? 1.0 : 0.0});
  checkpoint.whole("creeps", std::vector<std::uint8_t>{
                                 snapshot.particles.creeps ? std::uint8_t{1} : std::uint8_t{0}});
}

dem::Snapshot get_snapshot(const io::CheckpointReader& reader, dem::Surfaces walls) {
  dem::Snapshot snapshot;
  snapshot.particles.creeps = reader.whole<std::uint8_t>("creeps").at(0) != 0;
  std::size_t array = 0;
  dem::Particles::for_arrays(snapshot.particles,
                             [&](auto& values) { get_array(reader, name_of(array++), values); });
  snapshot.particles.owned = snapshot.particles.size();
  snapshot.contacts = get_contacts(reader);
  for (const Real overlap : reader.rows<Real>("largest_overlap")) {
    snapshot.largest_overlap = std::max(snapshot.largest_overlap, overlap);
  }
  const auto spent = reader.rows<Real>("contacts_spent", 6);
  for (std::size_t at = 0; at < spent.size(); at += 6) {
    snapshot.spent_among.add({spent[at], spent[at + 1], spent[at + 2]}, 1);
    snapshot.spent_on_walls.add({spent[at + 3], spent[at + 4], spent[at + 5]}, 1);
  }
  const auto lists = reader.whole<Real>("lists");
  snapshot.skin = lists.at(0), snapshot.moved = lists.at(1), snapshot.listed = lists.at(2) != 0;
  put_back(reader, walls);
  snapshot.walls = std::move(walls);
  return snapshot;
}

}  // namespace porefines::sim
