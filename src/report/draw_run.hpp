// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "analysis/run_sample.hpp"
#include "report/picture.hpp"

namespace porefines::report {

/// A fine to draw.
struct DrawnFine {
  Vec3 centre;      ///< [m]
  Real radius = 0;  ///< [m]
  Real speed = 0;   ///< [m/s]
  analysis::Fate fate = analysis::Fate::piping;
};

/// What a picture of a run shows besides the flow.
struct RunView {
  Vec3 low;  ///< [m] corner of the grid that the slices are cut from
  std::vector<DrawnFine> fines;
  std::vector<std::array<Vec3, 2>> clogged;  ///< [m] chords of clogged throats
};

enum class FineColour {
  speed,  ///< the scale of the flow: who is darker than the fluid around lags behind it
  fate,   ///< piping, bridging, clogged, resting, with their numbers; the flow is pale
};

struct RunStyle {
  std::string title = {};
  FineColour colour = FineColour::fate;
  std::optional<std::array<Real, 2>> range = {};  ///< [m/s]; fix it for movies
  std::optional<BoxFace> flow_to = {};
  int longer_side = 1600;  ///< [pixels] of the plot area, about
};

[[nodiscard]] Rgb colour_of(analysis::Fate fate);

/// All fines of a chip from above over the speed of its flow.
/// @param flow  [m/s] the middle plane, or the mean over the depth; axes x, y
[[nodiscard]] Picture draw_chip(const Slice& flow, const RunView& view, const RunStyle& style);

/// Three planes through the middle with the flow and the fines that they cut, as discs of that cut.
/// @param flow  normal to x, y, z in this order, as mid_slice makes them
[[nodiscard]] Picture draw_planes(const std::array<Slice, 3>& flow, const RunView& view,
                                  const RunStyle& style);

/// All fines seen along the three axes, the nearer over the farther; behind them how much of the
/// line of sight is rock.
/// @param rock  solid fraction averaged along x, y, z in this order; see mean_along
[[nodiscard]] Picture draw_projections(const std::array<Slice, 3>& rock, const RunView& view,
                                       const RunStyle& style);

/// A volume averaged along an axis.
/// @param values  x fastest, then y, z
[[nodiscard]] SliceValues mean_along(std::span<const float> values, const Int3& cells,
                                     const Vec3& spacing, int axis);

}  // namespace porefines::report
