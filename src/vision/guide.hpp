// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <span>
#include <vector>

#include <opencv2/core.hpp>

#include "vision/detect.hpp"

namespace porefines::vision {

using Spots = std::vector<Spot>;

/// How fast particles somewhere move [pixels a frame].
struct Step {
  cv::Point2d mean;
  Real xx = 1;  ///< covariance about the mean
  Real xy = 0;
  Real yy = 1;
};

/// Expected steps on a grid of square cells; see mean_flow().
struct Guide {
  Real cell = 32;  ///< [pixels]
  int nx = 0;
  int ny = 0;
  std::vector<Step> steps;  ///< [ny][nx], at the centres of the cells
};

/// Bilinear between the centres of the cells, constant beyond them.
[[nodiscard]] Step expected(const Guide& guide, const cv::Point2d& at);

/// Where a particle is after `frames` frames in the guide's mean steps (Heun, at most 0.7 cells a substep).
[[nodiscard]] cv::Point2d advect(const Guide& guide, cv::Point2d at, Real frames);

/// Mean distance between particles, 1 / sqrt(number per area) [pixels].
[[nodiscard]] Real spacing(std::span<const Spots> frames, cv::Size size);

/// The mean flow from positions alone, without any links.
///
/// For every cell, the histogram of the displacements from particles to all particles of the next frame
/// within `range`, with their middles in the cell: chance pairs fill it evenly, true ones pile up where the flow goes. The pile
/// (connected bins above a third of the highest, chance taken away) has the mean and the covariance.
/// A cell whose pile does not stand out five deviations above chance asks its neighbours, up to two
/// cells away, and after them the whole frame.
/// Cost: pairs within the range, once.
/// Source: the correlation of particle positions, as in PIV (Adrian 1991) and PTV (Baek & Lee 1996).
/// @param frames  of consecutive frames; breaks[i]: no pairs between i and i + 1; may be empty
/// @param range   [pixels]
/// Test: vision/guide.
[[nodiscard]] Guide mean_flow(std::span<const Spots> frames, const std::vector<bool>& breaks,
                              cv::Size size, Real range);

/// A step that was linked, and its middle.
struct SeenStep {
  cv::Point2d middle;
  cv::Point2d step;
};

/// A finer guide from steps that were linked with a coarse one, which counts as four steps a cell.
[[nodiscard]] Guide refined(const Guide& coarse, cv::Size size, Real cell,
                            std::span<const SeenStep> seen);

/// A guide of known steps, such as those of a computed velocity field.
/// @param step    mean displacement at a point [pixels]
/// @param spread  standard deviation about it, as a share of the step
[[nodiscard]] Guide known_flow(cv::Size size, Real cell, Real spread,
                               const std::function<cv::Point2d(const cv::Point2d&)>& step);

}  // namespace porefines::vision
