// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <deque>
#include <span>
#include <unordered_map>
#include <vector>

#include "vision/track_table.hpp"

namespace porefines::vision {

/// A number with its 95 % band.
struct Banded {
  Real value = TrackRow::unknown;
  Real low = TrackRow::unknown;
  Real high = TrackRow::unknown;
};

/// What is said of all particles of one time.
struct Moment {
  Real time = 0;
  Index particles = 0;  ///< mobile ones; only these count below
  Index retained = 0;
  Banded speed;    ///< [m/s] mean of |(u, v)|
  Banded sigma_x;  ///< [m] sqrt(sum (x - mean)^2 / N), the thesis's eq. 19
  Banded sigma_y;
  Real mean_x = TrackRow::unknown;
  Real mean_y = TrackRow::unknown;
};

/// Bands are percentile bootstrap: `resamples` times as many particles are drawn with replacement, by a
/// counter-based generator that is addressed by the seed and the time's number, so that they are always
/// the same.
/// Source: Efron & Tibshirani 1993. Test: vision/statistics.
[[nodiscard]] Moment moment_of(std::span<const TrackRow> rows, std::uint64_t number,
                               int resamples = 200);

/// Mean-square displacement against lag over all tracks and starts, with what all particles do
/// together taken away.
class MeanSquares {
 public:
  explicit MeanSquares(int lags) : lags_(static_cast<std::size_t>(lags)), sums_(lags_ + 1) {}
  /// Mobile rows of the next time.
  void add(int frame, std::span<const TrackRow> rows);

  struct Lag {
    Real mean_square = 0;  ///< [m^2] in the plane
    Index count = 0;
  };
  /// Index = lag in frames; [0] is empty.
  [[nodiscard]] const std::vector<Lag>& lags() const { return sums_; }

 private:
  struct Seen {
    int frame;
    Real x;
    Real y;
  };
  std::size_t lags_;
  std::vector<Lag> sums_;  ///< mean_square holds sums until result()
  std::unordered_map<Index, std::deque<Seen>> past_;
  Real drift_x_ = 0;
  Real drift_y_ = 0;

 public:
  /// lags() with the sums divided.
  [[nodiscard]] std::vector<Lag> result() const;
};

/// msd = 4 D t + 4 e^2, least squares over the first `lags` lags weighted by their counts / lag^2.
struct Diffusion {
  Real coefficient = TrackRow::unknown;  ///< D [m^2/s]
  Real error =
      TrackRow::unknown;  ///< e [m] of a centre along one axis; 0 when the fit is below zero
};
[[nodiscard]] Diffusion fit_diffusion(const std::vector<MeanSquares::Lag>& lags, Real frame_time,
                                      int first_lags);

}  // namespace porefines::vision
