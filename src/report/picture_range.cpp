// SPDX-License-Identifier: MPL-2.0
// Which values the ends of the colour bar stand for.
#include <algorithm>
#include <cmath>

#include "report/picture.hpp"
#include "report/picture_parts.hpp"

namespace porefines::report {
namespace {

constexpr Real decades = 4;  ///< shown at most below the largest value

template <class Visit>
void for_each_fluid_value(std::span<const Slice> slices, Visit visit) {
  for (const Slice& slice : slices) {
    for (std::size_t cell = 0; cell < slice.values.size(); ++cell) {
      if ((slice.grain.empty() || slice.grain[cell] == 0) && std::isfinite(slice.values[cell])) {
        visit(slice.values[cell]);
      }
    }
  }
}

std::vector<float> fluid_values(std::span<const Slice> slices, bool positive_only) {
  std::vector<float> values;
  for_each_fluid_value(slices, [&](float value) {
    if (value > 0 || !positive_only) {
      values.push_back(value);
    }
  });
  return values;
}

Real quantile(std::vector<float>& values, Real fraction) {
  const auto place =
      static_cast<std::ptrdiff_t>(std::lround(fraction * static_cast<Real>(values.size() - 1)));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

}  // namespace

std::array<Real, 2> value_range(std::span<const Slice> slices, const PictureStyle& style) {
  std::vector<float> values = fluid_values(slices, style.logarithmic);
  if (values.empty()) {
    return style.logarithmic ? std::array{0.1, 1.0} : std::array{0.0, 1.0};
  }
  Real low = quantile(values, 0.001);
  Real high = quantile(values, 0.999);
  if (style.logarithmic) {
    high = std::max(high, 10 * low);
    return {std::max(low, high * std::pow(10.0, -decades)), high};
  }
  if (style.colormap == Colormap::diverging && low < 0 && high > 0) {
    high = std::max(high, -low);
    low = -high;
  } else if (low >= 0 && low < 0.5 * high) {
    low = 0;
  }
  const Real least = 1e-6 * std::max(std::abs(low), std::abs(high));
  if (!(high - low > least)) {  // all the same: open the range around it
    const Real middle = 0.5 * (low + high);
    const Real half = middle != 0 ? 0.5 * std::abs(middle) : 0.5;
    return {middle - half, middle + half};
  }
  return {low, high};
}

ColourScale colour_scale(std::span<const Slice> slices, const PictureStyle& style) {
  const auto [low, high] = style.range.value_or(value_range(slices, style));
  return {low, high, style.logarithmic, style.colormap};
}

bool exceeds(std::span<const Slice> slices, const ColourScale& scale) {
  bool found = false;
  // A little above the end cannot be told from it by its colour.
  for_each_fluid_value(slices, [&](float value) { found = found || scale.position(value) > 1.01; });
  return found;
}

}  // namespace porefines::report
