// SPDX-License-Identifier: MPL-2.0
#include "analysis/shedding.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace porefines::analysis {
namespace {

/// Mean over [from, to], both inside the record, by the trapezoidal rule.
Real mean_between(std::span<const Real> time, std::span<const Real> value, Real from, Real to) {
  const auto at = [&](Real t) {
    const auto next = std::upper_bound(time.begin(), time.end(), t) - time.begin();
    const auto i = std::clamp<std::ptrdiff_t>(next, 1, std::ssize(time) - 1);
    const Real share = (t - time[i - 1]) / (time[i] - time[i - 1]);
    return (1 - share) * value[i - 1] + share * value[i];
  };
  Real sum = 0;
  Real t = from;
  Real v = at(from);
  for (std::size_t i = 0; i < time.size(); ++i) {
    if (time[i] > from && time[i] < to) {
      sum += (v + value[i]) / 2 * (time[i] - t);
      t = time[i];
      v = value[i];
    }
  }
  sum += (v + at(to)) / 2 * (to - t);
  return sum / (to - from);
}

}  // namespace

Shedding find_shedding(std::span<const Real> time, std::span<const Real> drag,
                       std::span<const Real> lift) {
  constexpr Real little = 1e-3;
  Shedding found;
  if (time.size() < 4) {
    found.drag = drag.empty() ? 0 : drag.back();
    return found;
  }
  const Real middle = (time.front() + time.back()) / 2;
  const auto first = std::lower_bound(time.begin(), time.end(), middle) - time.begin();
  const auto late = lift.subspan(static_cast<std::size_t>(first));
  const auto [low, high] = std::minmax_element(late.begin(), late.end());
  const Real mean = (*low + *high) / 2;
  found.lift = (*high - *low) / 2;
  found.drag = mean_between(time, drag, (middle + time.back()) / 2, time.back());
  if (found.lift < little * std::abs(found.drag)) {
    return found;
  }
  std::vector<Real> crossings;
  for (std::size_t i = static_cast<std::size_t>(first) + 1; i < time.size(); ++i) {
    const Real before = lift[i - 1] - mean;
    const Real after = lift[i] - mean;
    if (before < 0 && after >= 0) {
      crossings.push_back(time[i - 1] + (time[i] - time[i - 1]) * before / (before - after));
    }
  }
  if (crossings.size() > 2) {
    found.periods = static_cast<int>(crossings.size()) - 1;
    found.frequency = found.periods / (crossings.back() - crossings.front());
    found.drag = mean_between(time, drag, crossings.front(), crossings.back());
  }
  return found;
}

}  // namespace porefines::analysis
