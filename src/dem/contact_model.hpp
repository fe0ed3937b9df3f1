// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <type_traits>
#include <variant>

#include "dem/contact_law.hpp"
#include "dem/partial_slip.hpp"

namespace porefines::dem {

/// The law of a contact: one normal, one tangential and one rolling model.
///
/// The same function serves particle-particle and particle-grain contacts. It has no branches that
/// the compiler could not turn into selections, so that loops over contacts run in vector registers.
template <typename Normal, typename Tangential, typename Rolling>
struct ContactLaw {
  Normal normal;
  Tangential tangential;
  Rolling rolling;
  /// Leading numbers of ContactHistory that the models use.
  static constexpr int memory = std::max(Tangential::memory, Rolling::memory);

  /// @param dt  [s] step over which the springs stretch; 0 leaves them
  [[nodiscard, gnu::always_inline]] ContactForce operator()(const PairMaterial& pair,
                                                            const ContactState& contact, Real dt,
                                                            ContactHistory& history) const {
    const NormalResponse response = normal(pair, contact);
    ContactForce out;
    out.force = tangential(pair, contact, response, dt, history);
    out.force += response.force * contact.normal;
    out.couple = rolling(pair, contact, response, dt, history);
    out.normal = response.force;
    return out;
  }
};

/// The models that the user chose.
struct ContactModel {
  std::variant<Hertz, LinearSpring> normal = Hertz{};
  std::variant<Mindlin, MindlinDeresiewicz, Unresisted> tangential = Mindlin{};
  std::variant<Unresisted, ConstantTorque, RollingSpring> rolling = Unresisted{};
};

/// Calls use(law) with the law that the model names: once per loop, not per contact.
template <typename Use>
decltype(auto) with_law(const ContactModel& model, const Use& use) {
  return std::visit(
      [&use](const auto& normal, const auto& tangential, const auto& rolling) {
        using Law = ContactLaw<std::decay_t<decltype(normal)>, std::decay_t<decltype(tangential)>,
                               std::decay_t<decltype(rolling)>>;
        return use(Law{normal, tangential, rolling});  // clang 14 cannot deduce aggregates
      },
      model.normal, model.tangential, model.rolling);
}

/// Numbers of ContactHistory that the model uses.
[[nodiscard]] inline int history_length(const ContactModel& model) {
  return with_law(model, [](const auto& law) { return std::decay_t<decltype(law)>::memory; });
}

}  // namespace porefines::dem
