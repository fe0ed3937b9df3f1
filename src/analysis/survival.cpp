// SPDX-License-Identifier: MPL-2.0
#include "analysis/survival.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/distributions.hpp"

namespace porefines::analysis {
namespace {

/// The log(-log) band of S with Greenwood's sum g = (s / S)^2.
void add_band(SurvivalStep& step, Real greenwood, Real z) {
  step.deviation = step.survival * std::sqrt(greenwood);
  const Real spread = z * std::sqrt(greenwood) / std::abs(std::log(step.survival));
  step.low = std::pow(step.survival, std::exp(spread));
  step.high = std::pow(step.survival, std::exp(-spread));
}

}  // namespace

std::vector<SurvivalStep> kaplan_meier(std::vector<Lifetime> lives, Real confidence) {
  std::sort(lives.begin(), lives.end(),
            [](const Lifetime& a, const Lifetime& b) { return a.at < b.at; });
  const Real z = normal_quantile(0.5 + confidence / 2);
  std::vector<SurvivalStep> steps;
  Real survival = 1;
  Real greenwood = 0;
  for (std::size_t i = 0; i < lives.size();) {
    const auto n = static_cast<Index>(lives.size() - i);
    SurvivalStep step{.at = lives[i].at, .at_risk = n};
    for (; i < lives.size() && lives[i].at == step.at; ++i) {
      step.events += lives[i].happened ? 1 : 0;
    }
    if (step.events == 0) {
      continue;
    }
    const auto d = static_cast<Real>(step.events);
    const auto at_risk = static_cast<Real>(n);
    survival *= 1 - d / at_risk;
    step.survival = survival;
    if (survival > 0) {
      greenwood += d / (at_risk * (at_risk - d));
      add_band(step, greenwood, z);
    } else {
      step.low = 0;
      step.high = steps.empty() ? 1 : steps.back().high;  // the last one gone says nothing more
    }
    steps.push_back(step);
  }
  return steps;
}

ExponentialFit fit_exponential(const std::vector<Lifetime>& lives, Real confidence) {
  constexpr Real endless = std::numeric_limits<Real>::infinity();
  ExponentialFit fit;
  for (const Lifetime& life : lives) {
    fit.exposure += life.at;
    fit.events += life.happened ? 1 : 0;
  }
  const Real tail = 0.5 - confidence / 2;
  const auto r = static_cast<Real>(fit.events);
  fit.mean = fit.events > 0 ? fit.exposure / r : endless;
  fit.low = 2 * fit.exposure / chi_square_quantile(1 - tail, 2 * r + 2);
  fit.high = fit.events > 0 ? 2 * fit.exposure / chi_square_quantile(tail, 2 * r) : endless;
  return fit;
}

Proportion wilson(Index hits, Index trials, Real confidence) {
  if (trials == 0) {
    return {.share = std::nan("")};
  }
  const Real z = normal_quantile(0.5 + confidence / 2);
  const auto n = static_cast<Real>(trials);
  const Real p = static_cast<Real>(hits) / n;
  const Real centre = p + z * z / (2 * n);
  const Real half = z * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  const Real scale = 1 + z * z / n;
  return {hits, trials, p, std::max(0.0, (centre - half) / scale),
          std::min(1.0, (centre + half) / scale)};
}

}  // namespace porefines::analysis
