// SPDX-License-Identifier: MPL-2.0
// Many curves as one with bands.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/types.hpp"

namespace porefines::analysis {

/// A reading of one repeat against time or pore volumes; x rises.
struct Sampled {
  std::vector<Real> x;
  std::vector<Real> y;
  bool holds = false;  ///< it keeps its last value after its end: a run that stopped at a clog
};

/// An estimate with its interval.
struct Estimate {
  Real value = 0;
  Real low = 0;
  Real high = 0;
};

/// Of the repeats at one x.
struct BandPoint {
  Real x = 0;
  Index members = 0;  ///< repeats that reach it, or hold
  Estimate mean;      ///< with its bootstrap interval
  Real lower = 0;     ///< percentiles of the repeats, 10 %
  Real median = 0;
  Real upper = 0;  ///< 90 %
};

/// Straight between samples, the first and the last value beyond the ends; NaN without samples.
[[nodiscard]] Real value_at(const Sampled& curve, Real x);

/// The quantile of sorted values, straight between them (R's type 7).
[[nodiscard]] Real quantile(std::span<const Real> sorted, Real share);

/// Mean with its percentile bootstrap interval: `resamples` draws with replacement, the same every time.
///
/// One value: its interval is empty (NaN ends). Source: Efron & Tibshirani 1993, ch. 13.
[[nodiscard]] Estimate bootstrap_mean(std::span<const Real> values, Real confidence, int resamples,
                                      std::uint64_t seed);

/// Bands on `points` equal steps from 0 to where the first of the repeats that do not hold ends (to the
/// last end where all hold), so that no repeat drops out on the way. Cost O(points (members + resamples)).
/// Test: unit/statistics.
[[nodiscard]] std::vector<BandPoint> bands(const std::vector<Sampled>& curves, int points,
                                           Real confidence, int resamples, std::uint64_t seed);

}  // namespace porefines::analysis
