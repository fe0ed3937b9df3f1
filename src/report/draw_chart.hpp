// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "report/picture.hpp"

namespace porefines::report {

/// One quantity against another, SI. Points that are not finite leave a gap.
struct Curve {
  enum class Look { line, points, bars, dashed };

  std::string name = {};
  std::vector<Real> x = {};
  std::vector<Real> y = {};
  std::vector<Real> low = {};  ///< a confidence band around it; may be empty
  std::vector<Real> high = {};
  Look look = Look::line;
};

struct ChartStyle {
  std::string title = {};
  std::string x_name = {};
  std::string x_unit = {};  ///< SI; prefixes are chosen here
  std::string y_name = {};
  std::string y_unit = {};
  bool logarithmic = false;  ///< both axes; what is not above zero is left out
  bool from_zero = true;     ///< the y axis begins at zero where no value is below
};

/// Curves with their bands, ticks, units and a legend when there are several.
/// Test: unit/io_picture.
[[nodiscard]] Picture draw_chart(const std::vector<Curve>& curves, const ChartStyle& style);

}  // namespace porefines::report
