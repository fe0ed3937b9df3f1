// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/types.hpp"

namespace porefines::vision {

/// b + a exp(-((x - x0)^2 + (y - y0)^2) / 2 s^2); lengths in pixels.
struct Gaussian {
  Real x = 0;
  Real y = 0;
  Real height = 0;
  Real width = 1;
  Real base = 0;
};

/// The pixels of a disc, as far as it lies in the frame: line j holds columns left[j] to right[j] - 1, and
/// zeros up to the stride, so that sums over all are sums over the disc.
struct Patch {
  int x = 0;  ///< [pixels] of column 0 of the patch
  int y = 0;
  int columns = 0;
  std::vector<int> left;
  std::vector<int> right;
  std::vector<Real> light;   ///< [lines][stride]
  std::vector<Real> inside;  ///< [lines][stride] 1 in the disc, otherwise 0

  [[nodiscard]] int lines() const { return static_cast<int>(left.size()); }
  /// Whole vectors of eight.
  [[nodiscard]] int stride() const { return (columns + 7) / 8 * 8; }
  struct Sums {
    Real pixels = 0;
    Real light = 0;
    Real squares = 0;  ///< of the light
  };
  [[nodiscard]] Sums sums() const;
};

/// Takes the light of a particle from the patch.
void take_away(const Gaussian& g, Patch& patch);

/// Least squares in all five by Levenberg-Marquardt, from g on; the width stays within a factor of two
/// of what is usual. A Gaussian is a product of two bells, each a recurrence from its middle, so the sums of
/// the normal equations go over lines first and over columns at the end, with powers of the distances.
[[nodiscard]] Gaussian fit_gaussian(const Patch& patch, Gaussian g, Real usual_width);

}  // namespace porefines::vision
