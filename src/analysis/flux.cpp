// SPDX-License-Identifier: MPL-2.0
#include "analysis/flux.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace porefines::analysis {

Real mean(std::span<const Real> values) {
  return std::accumulate(values.begin(), values.end(), Real{0}) / static_cast<Real>(values.size());
}

Real flux_variation(std::span<const Real> plane_fluxes) {
  const auto [least, most] = std::minmax_element(plane_fluxes.begin(), plane_fluxes.end());
  const Real middle = std::abs(mean(plane_fluxes));
  return middle > 0 ? (*most - *least) / middle : NAN;
}

Real window_pressure_drop(std::span<const Real> layer_pressures, const Window& window, Real at_low,
                          Real at_high) {
  const auto plane = [&](int layer) {
    const auto above = static_cast<std::size_t>(layer);
    return (layer_pressures[above - 1] + layer_pressures[above]) / 2;
  };
  const bool ends_at_face = window.past == static_cast<int>(layer_pressures.size());
  return (window.first == 0 ? at_low : plane(window.first)) -
         (ends_at_face ? at_high : plane(window.past));
}

Real face_pressure(std::span<const Real> layer_pressures, bool high) {
  const std::size_t n = layer_pressures.size();
  const Real nearest = layer_pressures[high ? n - 1 : 0];
  const Real next = n < 2 ? nearest : layer_pressures[high ? n - 2 : 1];
  return nearest + (nearest - next) / 2;
}

}  // namespace porefines::analysis
