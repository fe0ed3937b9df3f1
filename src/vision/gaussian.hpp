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

/// The pixels of a disc, as far as it lies in the frame: line j holds columns left[j] to right[j] - 1.
struct Patch {
  int x = 0;  ///< [pixels] of column 0 of the patch
  int y = 0;
  int columns = 0;
  std::vector<int> left;
  std::vector<int> right;
  std::vector<Real> light;  ///< [lines][columns]

  [[nodiscard]] int lines() const { return static_cast<int>(left.size()); }
  [[nodiscard]] int pixels() const;
};

/// Takes the light of a particle from the patch.
void take_away(const Gaussian& g, Patch& patch);

/// Least squares in all five by Levenberg-Marquardt, from g on; the width stays within a factor of two
/// of what is usual. A Gaussian is a product: ten exponentials a line and column instead of one a pixel,
/// and the sums of the normal equations go line by line over powers of the distance.
[[nodiscard]] Gaussian fit_gaussian(const Patch& patch, Gaussian g, Real usual_width);

}  // namespace porefines::vision
