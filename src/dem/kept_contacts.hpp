// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <vector>

#include "dem/contact_law.hpp"

namespace porefines::dem {

/// A contact's history as its particle carries it through sorting, migration and restart.
struct KeptContact {
  std::uint64_t partner = 0;  ///< id of the other particle, or wall_partner
  ContactHistory history;     ///< as body i = the carrier sees it
  Vec3 normal;                ///< of the last step, on walls: several touches may share a feature
};

/// Names a touch's feature among the partners. Ids of particles stay below 2^63.
[[nodiscard]] constexpr std::uint64_t wall_partner(std::uint32_t feature) {
  return std::uint64_t{1} << 63 | feature;
}

/// The same history seen by the other body.
[[nodiscard]] inline ContactHistory seen_by_partner(ContactHistory h) {
  h.shear *= -1, h.rolling *= -1, h.axis *= -1;
  return h;
}

/// Kept contacts of all owned particles, particle by particle.
struct KeptContacts {
  std::vector<std::uint32_t> start{0};  ///< particles + 1
  std::vector<KeptContact> entries;

  [[nodiscard]] std::span<const KeptContact> of(std::size_t i) const {
    return {entries.data() + start[i], entries.data() + start[i + 1]};
  }
  /// The history with a partner; zero when there was no contact.
  [[nodiscard]] ContactHistory find(std::size_t i, std::uint64_t partner) const {
    for (const KeptContact& k : of(i)) {
      if (k.partner == partner) {
        return k.history;
      }
    }
    return {};
  }
  void append(std::span<const KeptContact> contacts) {
    entries.insert(entries.end(), contacts.begin(), contacts.end());
    start.push_back(static_cast<std::uint32_t>(entries.size()));
  }
  void reorder(std::span<const std::uint32_t> order) {
    KeptContacts sorted;
    sorted.entries.reserve(entries.size()), sorted.start.reserve(order.size() + 1);
    for (const std::uint32_t i : order) {
      sorted.append(of(i));
    }
    *this = std::move(sorted);
  }
};

}  // namespace porefines::dem
