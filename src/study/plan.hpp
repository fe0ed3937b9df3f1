// SPDX-License-Identifier: MPL-2.0
// What a study will cost.
#pragma once

#include <vector>

#include "study/study.hpp"

namespace porefines::study {

/// Of one member.
struct Cost {
  Real seconds = 0;  ///< wall time on study.ranks
  Real memory = 0;   ///< [bytes]
};

struct StudyPlan {
  std::vector<Cost> groups;  ///< of a member of each
  int cores = 1;             ///< physical ones that we may use
  Real available = 0;        ///< [bytes]
  int side_by_side = 1;
  Real seconds = 0;  ///< of all members that are not done, about
  Real most_memory = 0;
};

/// Dry runs of the first member of every group with something left to do, one after the other; `plan.json` of each
/// is kept in DIR/plans.
/// @param wanted  per member: still to be run
/// @throws InputError  a member that cannot fit, with the dry run's advice
[[nodiscard]] StudyPlan plan_study(const Study& study, const std::vector<Member>& members,
                                   const std::vector<bool>& wanted, const std::string& output);

/// How many at a time: cores / ranks and memory / the most that one needs, at least one, at most what the study says.
/// @throws InputError  one member alone needs more than there is
[[nodiscard]] int choose_side_by_side(const Study& study, int cores, Real available,
                                      Real most_memory);

}  // namespace porefines::study
