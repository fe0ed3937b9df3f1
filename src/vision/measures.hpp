// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <vector>

#include "core/types.hpp"

namespace porefines::vision {

/// Where a particle was in one frame [pixels].
struct PathPoint {
  int frame = 0;
  Real x = 0;
  Real y = 0;
};
using Path = std::vector<PathPoint>;  ///< frames rising; some may be missing

/// How far tracks are from the truth.
///
/// With d the distance between two tracks, summed over frames and never more than the gate in one
/// (the gate where only one of them is there), and every true track X paired with a found one or with
/// none such that the sum of d is least:
///
///     alpha = 1 - d(X, Y) / d(X, none)
///     beta  = (d(X, none) - d(X, Y)) / (d(X, none) + d(found without a partner, none))
///     jaccard = TP / (TP + FN + FP)    of positions closer than the gate in paired tracks; of tracks
///     rmse  = over the true positive positions [pixels]
///
/// Source: Chenouard et al., Nature Methods 11 (2014) 281. Test: unit/vision_measures.
struct Agreement {
  Real alpha = 0;
  Real beta = 0;
  Real jaccard = 0;
  Real jaccard_tracks = 0;
  Real rmse = 0;
};

inline constexpr Real isbi_gate = 5;  ///< [pixels]

[[nodiscard]] Agreement measure(const std::vector<Path>& truth, const std::vector<Path>& found,
                                Real gate = isbi_gate);

}  // namespace porefines::vision
