// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "dem/contact_model.hpp"
#include "dem/kept_contacts.hpp"
#include "dem/pair_list.hpp"
#include "dem/particles.hpp"

namespace porefines::dem {

/// Touching pairs side by side: what does not change while they touch, and their history. In the
/// order of the pair list; arrays are padded to whole vectors.
struct TouchingPairs {
  std::size_t count = 0;
  std::vector<std::uint32_t> pair;  ///< place in the pair list
  AlignedVector<std::int32_t> first;
  AlignedVector<std::int32_t> second;
  AlignedVector<std::int32_t> row;                  ///< of the material table
  AlignedVector<Real> radius_first, radius_second;  ///< [m]
  AlignedVector<Real> radius, mass, inertia;        ///< reduced, as ContactState has them
  std::array<AlignedVector<Real>, history_size> history;

  template <typename Self, typename Visit>
  static void for_arrays(Self& self, int history_length, const Visit& visit) {
    visit(self.pair), visit(self.first), visit(self.second), visit(self.row);
    visit(self.radius_first), visit(self.radius_second);
    visit(self.radius), visit(self.mass), visit(self.inertia);
    for (int h = 0; h < history_length; ++h) {
      visit(self.history[static_cast<std::size_t>(h)]);
    }
  }
};

/// Contacts between particles: the list of neighbours, a shorter list of the pairs that may touch
/// soon, and those that do.
class PairContacts {
 public:
  /// @param history  numbers of ContactHistory that the law uses
  explicit PairContacts(int history) : length_(history) {}

  /// Lists the pairs nearer than `skin` and gives touching ones their history back.
  /// @param species  rows of the material table
  void build(const Particles& particles, Real skin, const KeptContacts& kept, int species);

  /// Keeps only pairs with gaps below `window` for the coming steps; ends those that have parted.
  void narrow(const Particles& particles, Real window);

  /// Adds the contact forces and torques of all pairs that touch. Order of summation: the list's.
  void add_forces(const ContactModel& model, const MaterialTable& materials,
                  const Evaluation& evaluation, Particles& particles);

  /// Calls visit(i, j) for every pair of the narrowed list.
  template <typename Visit>
  void for_near(const Visit& visit) const {
    for (std::size_t k = 0; k < near_.pair.size(); ++k) {
      visit(static_cast<std::uint32_t>(near_.first[k]),
            static_cast<std::uint32_t>(near_.second[k]));
    }
  }

  /// One per particle: whether it is in a pair of the narrowed list.
  [[nodiscard]] std::vector<std::uint8_t> marked_near(std::size_t particles) const;

  /// Calls visit(i, j, history as i sees it) for every pair that touched at the last evaluation.
  template <typename Visit>
  void for_touching(const Visit& visit) const {
    for (std::size_t k = 0; k < touching_.count; ++k) {
      visit(static_cast<std::uint32_t>(touching_.first[k]),
            static_cast<std::uint32_t>(touching_.second[k]), history_of(k));
    }
  }
  void clear();

  [[nodiscard]] const PairList& list() const { return list_; }
  /// Largest overlap over smaller radius since the last reset.
  [[nodiscard]] Real largest_overlap() const { return largest_overlap_; }
  void reset_largest_overlap(Real to = 0) { largest_overlap_ = to; }
  /// Of all contacts since the start, those across ranks by half.
  [[nodiscard]] const Spent& spent() const { return spent_; }
  void reset_spent(const Spent& to) { spent_ = to; }

 private:
  /// Pairs that may touch before the next narrow().
  struct Near {
    std::vector<std::uint32_t> pair;
    AlignedVector<std::int32_t> first;
    AlignedVector<std::int32_t> second;
    AlignedVector<Real> range;        ///< [m^2] square of the sum of radii
    AlignedVector<std::uint8_t> now;  ///< touches
    AlignedVector<std::uint8_t> was;  ///< is in touching_
  };
  void drop_immobile(const Particles& particles);
  void find_touching(const Particles& particles);
  void renew_touching(const Particles& particles);
  void copy_run(std::size_t from, std::size_t count, std::size_t to);
  void resize_touching(TouchingPairs& touching, std::size_t count) const;
  void begin(const Particles& particles, std::uint32_t pair, TouchingPairs& touching,
             std::size_t at) const;
  [[nodiscard]] ContactHistory history_of(std::size_t at) const;

  int length_;
  int species_ = 1;
  PairList list_;
  Near near_;
  TouchingPairs touching_;
  TouchingPairs next_;
  Real largest_overlap_ = 0;
  Spent spent_;
};

}  // namespace porefines::dem
