// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "dem/contact_model.hpp"
#include "dem/kept_contacts.hpp"
#include "dem/pair_list.hpp"
#include "dem/particles.hpp"

namespace porefines::dem {

/// Contacts between particles: the list of neighbours, a shorter list of the pairs that may touch
/// soon, and the history of those that do.
class PairContacts {
 public:
  /// @param history  numbers of ContactHistory that the law uses
  explicit PairContacts(int history) : length_(history) {}

  /// Lists the pairs nearer than `skin` and gives touching ones their history back.
  void build(const Particles& particles, Real skin, const KeptContacts& kept);

  /// Keeps only pairs with gaps below `window` for the coming steps; ends those that have parted.
  void narrow(const Particles& particles, Real window);

  /// Adds the contact forces and torques of all pairs that touch. Order of summation: the list's.
  void add_forces(const ContactModel& model, const MaterialTable& materials,
                  const Evaluation& evaluation, Particles& particles);

  /// Calls visit(i, j) for every pair of the narrowed list.
  template <typename Visit>
  void for_near(const Visit& visit) const {
    for (const std::uint32_t k : near_) {
      visit(list_.first[k], list_.second[k]);
    }
  }
  /// Calls visit(i, j, history as i sees it) for every pair that touched at the last evaluation.
  template <typename Visit>
  void for_touching(const Visit& visit) const {
    for (std::size_t k = 0; k < list_.size(); ++k) {
      if (touching_[k] != 0) {
        visit(list_.first[k], list_.second[k], history_of(k));
      }
    }
  }
  void clear();

  [[nodiscard]] const PairList& list() const { return list_; }
  /// Largest overlap over smaller radius since the last reset.
  [[nodiscard]] Real largest_overlap() const { return largest_overlap_; }
  void reset_largest_overlap() { largest_overlap_ = 0; }

 private:
  void drop_immobile(const Particles& particles);
  void find_touching(const Particles& particles);
  [[nodiscard]] ContactHistory history_of(std::size_t pair) const;

  int length_;
  PairList list_;
  std::vector<std::uint8_t> touching_;  ///< at the last evaluation
  std::vector<Real> history_;           ///< length_ numbers per pair
  std::vector<std::uint32_t> near_;     ///< pairs that may touch before the next narrow()
  std::vector<std::uint32_t> touch_;    ///< pairs that touch now
  Real largest_overlap_ = 0;
};

}  // namespace porefines::dem
