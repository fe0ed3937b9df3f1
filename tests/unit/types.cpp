// SPDX-License-Identifier: MPL-2.0
#include "core/types.hpp"

#include <gtest/gtest.h>

namespace porefines {

TEST(Types, cross_product_is_right_handed) {
  EXPECT_EQ(cross(Vec3{1, 0, 0}, Vec3{0, 1, 0}), (Vec3{0, 0, 1}));
}

TEST(Types, box_faces_know_their_axis_and_side) {
  EXPECT_EQ(box_face(1, true), BoxFace::y_high);
  EXPECT_EQ(axis_of(BoxFace::z_low), 2);
  EXPECT_FALSE(is_high(BoxFace::z_low));
}

}  // namespace porefines
