// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>

#include "vision/detect.hpp"

namespace porefines::vision {

/// How grains look.
enum class GrainKind { automatic, none, dark, bright };

/// The median of every pixel over frames spread over the video [float]: what never moves.
/// Cost: all frames at once in memory.
[[nodiscard]] cv::Mat median_light(std::span<const cv::Mat> frames);

/// Where the grains are: nonzero.
///
/// The median light is cut in two by Otsu's threshold. Grains are the side where less moves (largest
/// deviation from the median, blurred), or the side that the user names. Automatic: there are none
/// unless fewer than 10 % of the pixels lie in the middle fifth between the two sides, which uneven
/// light alone does not do. Islands and holes smaller than `smallest` pixels go: those are particles.
/// Test: vision/still.
[[nodiscard]] cv::Mat find_grains(std::span<const cv::Mat> frames, const cv::Mat& median,
                                  GrainKind kind, int smallest);

/// The median light without the stuck particles in it, so that they are seen like the others.
///
/// What is small, round and alone in the top-hat of the median (in the closing for dark particles) is
/// replaced by what surrounds it. Grains count as the pores beside them.
/// @param stuck  how many were found; may be null
[[nodiscard]] cv::Mat without_stuck(const cv::Mat& median, const cv::Mat& grains,
                                    const DetectSettings& settings, int* stuck = nullptr);

/// Reads a mask: grains are what is dark or bright in the picture.
/// @throws InputError  unreadable, or of another size than the frames
[[nodiscard]] cv::Mat read_mask(const std::string& path, cv::Size frame, GrainKind kind);

}  // namespace porefines::vision
