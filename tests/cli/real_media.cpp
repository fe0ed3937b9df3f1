// SPDX-License-Identifier: MPL-2.0
// Parts of the real Berea block and of the real slices; the whole of them is in validation/.
#include "support/real_media.hpp"

#include <gtest/gtest.h>

#include "support/scratch.hpp"

namespace porefines {
namespace {

using test::RealMedium;

class RealPart : public ::testing::TestWithParam<RealMedium> {};

TEST_P(RealPart, is_as_recorded) {
  const RealMedium& medium = GetParam();
  if (test::shared_file("images/" + medium.image).empty()) {
    GTEST_SKIP() << "../shared/data/images/" << medium.image << " is not there";
  }
  const test::Scratch folder;
  const std::string summary = test::summary_of(medium, folder.path());
  test::expect_as_recorded(medium, summary);
  if (medium.voxel_permeability > 0) {  // references.md A6: codes agree to about 5 %
    EXPECT_NEAR(test::number(summary, "permeability_m2") / medium.voxel_permeability, 1, 0.05);
  }
}

const std::string corner = "geometry.crop=[[0, 192], [0, 192]]";
INSTANTIATE_TEST_SUITE_P(
    Sample, RealPart,
    ::testing::Values(RealMedium{"berea_100",
                                 "berea_200.tif",
                                 {"geometry.crop=[[0, 100], [0, 100], [0, 100]]"},
                                 0.22402,
                                 0.22354,
                                 9.927e-13,
                                 9.485e-13,
                                 12},
                      RealMedium{"sphere_pack",
                                 "spherepack_slice.tif",
                                 {corner, "geometry.reconnect_gap=3"},
                                 0.4932,
                                 0.4929,
                                 1.4466e-10,
                                 0,
                                 7},
                      RealMedium{"sand",
                                 "sandpack_slice.tif",
                                 {corner, "geometry.reconnect_gap=3"},
                                 0.2729,
                                 0.2488,
                                 2.195e-12,
                                 0,
                                 12},
                      RealMedium{"gambier",
                                 "gambier_slice.tif",
                                 {corner, "geometry.reconnect_gap=3"},
                                 0.6548,
                                 0.5816,
                                 1.1502e-11,
                                 0,
                                 12}),
    [](const auto& part) { return part.param.name; });

}  // namespace
}  // namespace porefines
