// SPDX-License-Identifier: MPL-2.0
// ten Cate's settling sphere: a quarter of an hour on one core.
#include "support/ten_cate.hpp"

namespace porefines::test {

/// Peak speed over the terminal one, 12 cells per diameter: 0.947 (Re 1.5) and 0.955 (Re 31.9) in the experiment.
/// Found: 0.915 (9 cells) and 0.9432. references.md B7 accepts 5 %, as its two digitised figures differ by 3 to 5 %.
TEST(SettlingValidation, peak_speeds) {
  const Real slow = settle(slow_settling, 12, 0.5).peak;
  const Real fast = settle(fast_settling, 12, 0.5).peak;
  std::printf("peak speeds: %.4f, %.4f\n", slow, fast);
  EXPECT_NEAR(slow / 0.947, 1, 0.05);
  EXPECT_NEAR(fast / 0.955, 1, 0.03);
}

}  // namespace porefines::test
