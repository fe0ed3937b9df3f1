// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "vision/link_video.hpp"
#include "vision/results.hpp"

namespace porefines::vision {

/// Second pass over the linked spots: tracks.csv, arrows.png of a frame in the middle, of the hundredth at most, annotated.avi when
/// the request wants it, and the results.
void write_rows(const TrackRequest& request, const LinkedVideo& linked, const Scale& scale,
                int diameter, TrackResults& results);

}  // namespace porefines::vision
