// SPDX-License-Identifier: MPL-2.0
// Classical deep-bed filtration in one dimension, and its fit to a run.
#pragma once

#include <cstdint>
#include <vector>

#include "analysis/bands.hpp"
#include "core/types.hpp"

namespace porefines::analysis {

/// The sample and the feed.
struct Bed {
  Real length = 1;  ///< [m]
  Real porosity = 1;
  Real feed = 0;  ///< c0, volume fraction
};

/// The two coefficients.
struct Filtration {
  Real lambda = 0;  ///< [1/m] filtration coefficient
  Real beta = 0;    ///< formation damage: k0/k = 1 + beta s
};

/// Suspended and retained fines with a constant lambda and a feed that starts at T = 0,
///
///     d(phi c + s)/dt + U dc/dx = 0,   ds/dt = lambda U c
///     c = c0 exp(-lambda x),   s = lambda L phi c0 (T - x/L) exp(-lambda x)     for T > x/L, else 0
///
/// T = U t / (phi L) pore volumes, x [m], s volume of fines per bulk volume, c per volume of water.
/// No dispersion: the front is sharp. Source: Herzig, Leclerc & Le Goff, Ind. Eng. Chem. 62 (1970) 8, their eq. 13-17;
/// Bedrikovetsky, Transp. Porous Media 75 (2008) 335, eq. 1-4.
[[nodiscard]] Real suspended(const Bed& bed, Real lambda, Real x, Real pore_volumes);
[[nodiscard]] Real retained(const Bed& bed, Real lambda, Real x, Real pore_volumes);

/// Of the whole bed, slices in series: 1 + beta <s>, with <s> = 1/L int s dx in closed form.
[[nodiscard]] Real resistance_ratio(const Bed& bed, const Filtration& f, Real pore_volumes);

/// What a run measured.
struct BedData {
  Real profile_at = 0;              ///< pore volumes of the profile
  std::vector<Real> x;              ///< [m] middles of its bins
  std::vector<Real> s;              ///< retained volume per bulk volume
  std::vector<Real> volumes;        ///< pore volumes of the samples below
  std::vector<Real> concentration;  ///< C/C0 at the outlet; NaN where unknown
  std::vector<Real> resistance;     ///< k0/k; NaN where unknown
};

struct BedFit {
  Estimate lambda;  ///< with the bootstrap's interval
  Estimate beta;
  Real lambda_deviation =
      0;  ///< standard error by the covariance, as if residuals were independent
  Real beta_deviation = 0;
  Real retention_misfit = 0;  ///< root mean square of residuals over the mean of the data
  Real breakthrough_misfit = 0;
  Real resistance_misfit = 0;
};

/// lambda and beta from retention, breakthrough after the front (T > 1) and k0/k together.
///
/// Each kind of data is weighted with the inverse of its own scatter (two rounds), so that neither their number nor their
/// unit decides. Intervals by a bootstrap over blocks of residuals, as long as their
/// correlation wants it; the covariance is given beside it.
/// @throws InputError  nothing retained, or fewer than three points of a profile
/// Test: unit/deep_bed (recovers both from the exact solution with noise; coverage of the interval).
[[nodiscard]] BedFit fit_bed(const Bed& bed, const BedData& data, Real confidence, int resamples,
                             std::uint64_t seed);

}  // namespace porefines::analysis
