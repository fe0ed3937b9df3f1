// SPDX-License-Identifier: MPL-2.0
// How long until something happens, from repeats of which some ended before it did.
#pragma once

#include <vector>

#include "core/types.hpp"

namespace porefines::analysis {

/// One repeat: fines that escaped, or time, until the clog, or until the run ended without one.
struct Lifetime {
  Real at = 0;
  bool happened = true;  ///< false: censored, it lived at least so long
};

/// Survivors just after `at`, with a pointwise confidence interval.
struct SurvivalStep {
  Real at = 0;
  Index at_risk = 0;  ///< just before
  Index events = 0;
  Real survival = 1;
  Real deviation = 0;  ///< Greenwood's standard error
  Real low = 1;
  Real high = 1;
};

/// Kaplan-Meier estimate; one step per distinct time at which something happened.
///
///     S = prod (1 - d_i / n_i),   s^2 = S^2 sum d_i / (n_i (n_i - d_i))       (Greenwood)
///     band: S^exp(+-z s / (S ln S)), the log(-log) form, which stays within 0..1
///
/// A censored one at the time of an event counts as at risk. Where S falls to 0
/// the upper end stays where it was. @param confidence  0.95
/// Source: Kaplan & Meier, JASA 53 (1958) 457; Kalbfleisch & Prentice 1980 for the band.
/// Test: unit/statistics (Freireich's 6-MP data).
[[nodiscard]] std::vector<SurvivalStep> kaplan_meier(std::vector<Lifetime> lives, Real confidence);

/// Lives that end at a constant rate.
struct ExponentialFit {
  Index events = 0;
  Real exposure = 0;  ///< sum of all lives
  Real mean = 0;      ///< exposure / events; infinite without events
  Real low = 0;       ///< confidence interval of the mean
  Real high = 0;
};

/// Maximum likelihood with censoring, and an interval from chi-square,
///
///     mean = T / r,    2 T / chi2(1 - a/2; 2 r + 2)  to  2 T / chi2(a/2; 2 r)
///
/// the cautious one for runs that end at a fixed time (exact where they end at the r-th event but for
/// the 2 r + 2). Without events high is infinite. For counts of escapees the same, geometric, up to 1 / mean.
/// Source: Epstein & Sobel, JASA 48 (1953) 486; Cox 1953.
[[nodiscard]] ExponentialFit fit_exponential(const std::vector<Lifetime>& lives, Real confidence);

/// A share and its interval.
struct Proportion {
  Index hits = 0;
  Index trials = 0;
  Real share = 0;
  Real low = 0;
  Real high = 1;
};

/// Wilson's score interval, good for few trials and shares near 0 and 1.
///
///     (p + z^2/2n +- z sqrt(p (1-p)/n + z^2/4n^2)) / (1 + z^2/n)
///
/// Source: Wilson, JASA 22 (1927) 209. Test: unit/statistics (81 of 263, Newcombe 1998).
[[nodiscard]] Proportion wilson(Index hits, Index trials, Real confidence);

}  // namespace porefines::analysis
