// SPDX-License-Identifier: MPL-2.0
#include "study/groups.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::study {
namespace {

constexpr int band_points = 101;
constexpr std::uint64_t bootstrap_seed = 1;

using Results = std::vector<const Result*>;

void add_lifetimes(Group& group, const Results& results, Real confidence) {
  Index clogged = 0;
  Index logs = 0;
  for (const Result* result : results) {
    if (result->clogs) {
      ++logs;
      clogged += result->time.happened ? 1 : 0;
      group.time.push_back(result->time);
      group.volumes.push_back(result->volumes);
      group.escapees.push_back(result->escapees);
    }
  }
  group.clogs = logs > 0;
  group.clogged = analysis::wilson(clogged, logs, confidence);
}

void add_readings(Group& group, const Results& results, const Study& study) {
  for (std::size_t k = 0; k < study.readings.size(); ++k) {
    std::vector<Real> values;
    for (const Result* result : results) {
      if (std::isfinite(result->readings[k])) {
        values.push_back(result->readings[k]);
      }
    }
    group.readings.push_back(
        analysis::bootstrap_mean(values, study.confidence, study.resamples, bootstrap_seed));
  }
}

void add_bands(Group& group, const Results& results, const Study& study) {
  for (std::size_t k = 0; k < curve_kinds.size(); ++k) {
    std::vector<analysis::Sampled> curves;
    for (const Result* result : results) {
      if (!result->curves[k].x.empty()) {
        curves.push_back(result->curves[k]);
      }
    }
    group.bands[k] =
        analysis::bands(curves, band_points, study.confidence, study.resamples, bootstrap_seed);
  }
}

}  // namespace

std::vector<Group> make_groups(const Study& study, const std::vector<Member>& members,
                               const std::vector<std::optional<Result>>& results) {
  std::vector<Group> groups(members.empty() ? 0 : members.back().group + 1);
  std::vector<Results> of_group(groups.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    Group& group = groups[members[i].group];
    group.at = members[i].at;
    group.name = describe_group(study, members[i]);
    ++group.members;
    if (results[i]) {
      ++group.done;
      of_group[members[i].group].push_back(&*results[i]);
    }
  }
  for (std::size_t g = 0; g < groups.size(); ++g) {
    add_lifetimes(groups[g], of_group[g], study.confidence);
    add_readings(groups[g], of_group[g], study);
    add_bands(groups[g], of_group[g], study);
  }
  return groups;
}

}  // namespace porefines::study
