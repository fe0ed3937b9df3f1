// SPDX-License-Identifier: MPL-2.0
#include "report/draw_chart.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace porefines::report {
namespace {

/// Coloured pixels of the first picture that the second one has not.
int lost(const Picture& first, const Picture& second) {
  int count = 0;
  for (std::size_t at = 0; at < first.rgb.size(); at += 3) {
    const auto* a = &first.rgb[at];
    const auto* b = &second.rgb[at];
    const bool coloured = std::abs(a[0] - a[2]) > 60;
    count += coloured && (a[0] != b[0] || a[1] != b[1] || a[2] != b[2]) ? 1 : 0;
  }
  return count;
}

/// A curve from corner to corner leaves two free, and one that climbs and stays high the lower right one.
TEST(DrawChart, the_legend_covers_no_curve) {
  for (const int shape : {0, 1, 2}) {
    Curve curve;
    for (int i = 0; i <= 20; ++i) {
      const Real x = 0.05 * i;
      curve.x.push_back(x);
      curve.y.push_back(shape == 0 ? x : shape == 1 ? 1 - x : std::min(1.0, 8 * x));
    }
    const Picture bare = draw_chart({curve}, {.title = "t"});
    curve.name = "a curve with a name that takes some room";
    EXPECT_EQ(lost(bare, draw_chart({curve}, {.title = "t"})), 0) << shape;
  }
}

}  // namespace
}  // namespace porefines::report
