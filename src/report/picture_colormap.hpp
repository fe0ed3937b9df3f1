// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>

#include "core/types.hpp"

namespace porefines::report {

using Rgb = std::array<std::uint8_t, 3>;

enum class Colormap {
  speed,      ///< sequential, dark indigo to light yellow: the eye follows the fast paths
  pressure,   ///< sequential, pale to deep blue
  diverging,  ///< blue, near white, red: deviations from the middle
  pale,       ///< sequential, near white to mid blue: a ground to draw on
  rock,       ///< sequential, near white to brownish grey: a ground to draw on
};

/// Colour at `position` in [0, 1]; outside it is clamped, NaN is white.
///
/// The maps are curves in OKLab (Ottosson 2020), walked at constant speed, so equal steps of the
/// value look equally different; lightness is monotone (on each side of the middle for
/// `diverging`), so they survive grey printing.
/// Tests: unit/io_picture (steps uniform within 25 %, lightness monotone).
[[nodiscard]] Rgb colour(Colormap map, Real position);

/// Perceived lightness of a colour, 0 black to 1 white (L of OKLab).
[[nodiscard]] Real lightness(const Rgb& colour);

/// Perceived difference of two colours: distance in OKLab.
[[nodiscard]] Real difference(const Rgb& a, const Rgb& b);

}  // namespace porefines::report
