// SPDX-License-Identifier: MPL-2.0
#include "core/suggest.hpp"

#include <gtest/gtest.h>

namespace porefines {

TEST(EditDistance, counts_typing_errors) {
  EXPECT_EQ(edit_distance("cell_size", "cell_size"), 0);
  EXPECT_EQ(edit_distance("cell_sise", "cell_size"), 1);
  EXPECT_EQ(edit_distance("cel_size", "cell_size"), 1);
  EXPECT_EQ(edit_distance("cell_zise", "cell_size"), 2);
  EXPECT_EQ(edit_distance("cell_siez", "cell_size"), 1);  // neighbours swapped
  EXPECT_EQ(edit_distance("", "abc"), 3);
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
}

TEST(Closest, finds_the_word_meant_or_none) {
  EXPECT_EQ(closest("viscosty", {"density", "viscosity"}), "viscosity");
  EXPECT_EQ(closest("colour", {"density", "viscosity"}), "");
  EXPECT_EQ(closest(std::string(1000, 'x'), {"density"}), "");
}

}  // namespace porefines
