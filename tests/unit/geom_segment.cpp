// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "geom/segment.hpp"

namespace porefines::geom {

namespace {

/// Grey image with two noisy populations around 60 and 170; a third of it is bright.
GreyVolume two_populations() {
  GreyVolume image{{60, 60, 1}, {}};
  for (int v = 0; v < 3600; ++v) {
    image.grey.push_back(static_cast<std::uint8_t>((v % 3 == 0 ? 170 : 60) + v * 7 % 41 - 20));
  }
  return image;
}

Real porosity(const Voxels& voxels) {
  Real sum = 0;
  for (const auto p : voxels.pore) {
    sum += p;
  }
  return sum / static_cast<Real>(voxels.pore.size());
}

}  // namespace

TEST(Segment, otsu_lies_between_the_populations) {
  EXPECT_NEAR(otsu_threshold(two_populations(), "image"), 115, 2);
  EXPECT_THROW((void)otsu_threshold({{2, 1, 1}, {5, 5}}, "image"), InputError);
}

TEST(Segment, threshold_takes_bright_or_dark) {
  Segmentation how;
  how.otsu = true;
  EXPECT_NEAR(porosity(segment(two_populations(), how, "image")), 1.0 / 3, 1e-9);
  how.pore_is_bright = false;
  EXPECT_NEAR(porosity(segment(two_populations(), how, "image")), 2.0 / 3, 1e-9);
  how.otsu = false;
  how.threshold = 255;
  EXPECT_THROW((void)segment(two_populations(), how, "image"), InputError);  // all pore
}

TEST(Segment, binary_image_needs_its_pore_value_and_a_grey_one_a_threshold) {
  const GreyVolume labels{{4, 1, 1}, {0, 7, 7, 3}};
  Segmentation how;
  how.pore_value = 7;
  EXPECT_NEAR(porosity(segment(labels, how, "image")), 0.5, 1e-12);
  how.pore_value = 255;
  EXPECT_THROW((void)segment(labels, how, "image"), InputError);
  how.pore_value = 60;
  EXPECT_THROW((void)segment(two_populations(), how, "image"), InputError);
}

TEST(Segment, crop_keeps_the_part_asked_for) {
  GreyVolume image{{4, 3, 1}, {0, 1, 2, 3, 10, 11, 12, 13, 20, 21, 22, 23}};
  const GreyVolume part = crop(image, {1, 1, 0}, {3, 3, 0}, "image");
  EXPECT_EQ(part.n, (Int3{2, 2, 1}));
  EXPECT_EQ(part.grey, (std::vector<std::uint8_t>{11, 12, 21, 22}));
  EXPECT_EQ(crop(image, {}, {}, "image").n, image.n);
  EXPECT_THROW((void)crop(image, {1, 1, 0}, {5, 3, 1}, "image"), InputError);
}

}  // namespace porefines::geom
