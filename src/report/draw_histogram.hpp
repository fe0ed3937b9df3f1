// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "geom/metrics.hpp"
#include "report/picture.hpp"

namespace porefines::report {

/// What a histogram says.
struct HistogramStyle {
  std::string title = {};
  std::string quantity = {};  ///< along x, e.g. "throat width"
  std::string share = {};     ///< along y, e.g. "share of throats"
  std::string unit = "m";
  Real mark = 0;  ///< SI; a further line, e.g. four cells; 0: none
  std::string mark_name = {};
  int bins = 28;
};

/// Histogram up to the 99.5 % quantile (what lies beyond is in the last bin) with median and mean.
/// @param sizes  sorted
[[nodiscard]] Picture draw_histogram(const geom::SizeDistribution& sizes,
                                     const HistogramStyle& style);

}  // namespace porefines::report
