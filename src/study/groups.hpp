// SPDX-License-Identifier: MPL-2.0
// Members that differ in their seed alone, as statistics.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/collect.hpp"
#include "study/study.hpp"

namespace porefines::study {

/// Repeats of one point of the axes.
struct Group {
  std::vector<std::size_t> at;  ///< which point of every axis
  std::string name;
  Index members = 0;
  Index done = 0;
  bool clogs = false;  ///< has a clogging log
  analysis::Proportion clogged;
  std::vector<analysis::Lifetime> time, volumes, escapees;
  std::vector<analysis::Estimate> readings;  ///< means with bootstrap intervals
  std::array<std::vector<analysis::BandPoint>, curve_kinds.size()> bands;
};

/// @param results  per member; empty where it is not done
/// Test: unit/study.
[[nodiscard]] std::vector<Group> make_groups(const Study& study, const std::vector<Member>& members,
                                             const std::vector<std::optional<Result>>& results);

/// members.csv, groups.csv, survival.csv, bands.csv and study.json.
void write_tables(const std::string& output, const Study& study, const std::vector<Member>& members,
                  const std::vector<std::optional<Result>>& results,
                  const std::vector<Group>& groups);

/// Clogging probability, survival, every reading against the first axis, every curve with its bands, as PNG.
/// @return  their names
std::vector<std::string> draw_charts(const std::string& output, const Study& study,
                                     const std::vector<Group>& groups);

}  // namespace porefines::study
