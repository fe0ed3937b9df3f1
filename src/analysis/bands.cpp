// SPDX-License-Identifier: MPL-2.0
#include "analysis/bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/random.hpp"

namespace porefines::analysis {
namespace {

constexpr Real lower_share = 0.1;
constexpr Real upper_share = 0.9;

Real mean_of(std::span<const Real> values) {
  return std::accumulate(values.begin(), values.end(), Real{0}) / static_cast<Real>(values.size());
}

Real common_end(const std::vector<Sampled>& curves) {
  Real shortest = std::numeric_limits<Real>::infinity();
  Real longest = 0;
  for (const Sampled& curve : curves) {
    if (!curve.x.empty()) {
      longest = std::max(longest, curve.x.back());
      shortest = curve.holds ? shortest : std::min(shortest, curve.x.back());
    }
  }
  return std::isfinite(shortest) ? shortest : longest;
}

}  // namespace

Real value_at(const Sampled& curve, Real x) {
  if (curve.x.empty()) {
    return std::nan("");
  }
  const auto after = std::upper_bound(curve.x.begin(), curve.x.end(), x) - curve.x.begin();
  if (after == 0) {
    return curve.y.front();
  }
  const auto i = static_cast<std::size_t>(after) - 1;
  if (i + 1 == curve.x.size()) {
    return curve.y.back();
  }
  const Real share = (x - curve.x[i]) / (curve.x[i + 1] - curve.x[i]);
  return (1 - share) * curve.y[i] + share * curve.y[i + 1];
}

Real quantile(std::span<const Real> sorted, Real share) {
  const Real at = share * static_cast<Real>(sorted.size() - 1);
  const auto i = static_cast<std::size_t>(at);
  const std::size_t next = std::min(i + 1, sorted.size() - 1);
  const Real rest = at - static_cast<Real>(i);
  return (1 - rest) * sorted[i] + rest * sorted[next];
}

Estimate bootstrap_mean(std::span<const Real> values, Real confidence, int resamples,
                        std::uint64_t seed) {
  if (values.size() < 2) {
    return {values.empty() ? std::nan("") : values[0], std::nan(""), std::nan("")};
  }
  Draws draws(seed, Stream::bootstrap, 0);
  const auto n = static_cast<Real>(values.size());
  std::vector<Real> means(static_cast<std::size_t>(resamples));
  for (Real& mean : means) {
    Real sum = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      sum += values[static_cast<std::size_t>(draws.uniform() * n)];
    }
    mean = sum / n;
  }
  std::sort(means.begin(), means.end());
  const Real tail = 0.5 - confidence / 2;
  return {mean_of(values), quantile(means, tail), quantile(means, 1 - tail)};
}

std::vector<BandPoint> bands(const std::vector<Sampled>& curves, int points, Real confidence,
                             int resamples, std::uint64_t seed) {
  std::vector<BandPoint> out;
  const Real end = common_end(curves);
  for (int k = 0; k < points && end > 0; ++k) {
    BandPoint point;
    point.x = end * k / (points - 1);
    std::vector<Real> values;
    for (const Sampled& curve : curves) {
      if (const Real y = value_at(curve, point.x); std::isfinite(y)) {
        values.push_back(y);
      }
    }
    if (values.empty()) {
      continue;
    }
    std::sort(values.begin(), values.end());
    point.members = static_cast<Index>(values.size());
    point.mean = bootstrap_mean(values, confidence, resamples, seed);
    point.lower = quantile(values, lower_share);
    point.median = quantile(values, 0.5);
    point.upper = quantile(values, upper_share);
    out.push_back(point);
  }
  return out;
}

}  // namespace porefines::analysis
