// SPDX-License-Identifier: MPL-2.0
// The real Berea block and the three real slices, whole (make validate: minutes).
#include "support/real_media.hpp"

#include <gtest/gtest.h>

#include "support/scratch.hpp"

namespace porefines {
namespace {

using test::RealMedium;

class RealWhole : public ::testing::TestWithParam<RealMedium> {};

TEST_P(RealWhole, is_as_recorded) {
  const RealMedium& medium = GetParam();
  if (test::shared_file("images/" + medium.image).empty()) {
    GTEST_SKIP() << "../shared/data/images/" << medium.image << " is not there";
  }
  const test::Scratch folder;
  test::expect_as_recorded(medium, test::summary_of(medium, folder.path()));
}

/// references.md A6: codes agree to about 5 % on the same voxels; so do our two kinds of surface.
TEST(RealRock, staircase_and_smooth_surface_agree_to_five_percent) {
  const RealMedium berea{"berea_100",
                         "berea_200.tif",
                         {"geometry.crop=[[0, 100], [0, 100], [0, 100]]"},
                         0,
                         0,
                         0,
                         0,
                         0};
  if (test::shared_file("images/" + berea.image).empty()) {
    GTEST_SKIP() << "../shared/data/images/" << berea.image << " is not there";
  }
  const test::Scratch folder;
  const Real smooth = test::number(test::summary_of(berea, folder.path()), "permeability_m2");
  const Real voxel = test::number(
      test::summary_of(berea, folder.path(), {"geometry.surface=voxel"}), "permeability_m2");
  EXPECT_NEAR(voxel / smooth, 1, 0.05);
}

// Cycles: at most 12, and 16 where many throats are one cell wide (Berea and the sands).
// Mt Gambier's slice has no path of its own: walls of up to 16 pixels part its pores.
INSTANTIATE_TEST_SUITE_P(
    Sample, RealWhole,
    ::testing::Values(
        RealMedium{"berea", "berea_200.tif", {}, 0.19872, 0, 1.7266e-12, 0, 14},
        RealMedium{"sphere_pack", "spherepack_slice.tif", {}, 0.3897, 0.3897, 1.7679e-11, 0, 7},
        RealMedium{"sand", "sandpack_slice.tif", {}, 0.3597, 0.3465, 5.9795e-12, 0, 15},
        RealMedium{"gambier",
                   "gambier_slice.tif",
                   {"geometry.reconnect_gap=16"},
                   0.46609,
                   0.52549,
                   0,
                   0,
                   16}),
    [](const auto& whole) { return whole.param.name; });

}  // namespace
}  // namespace porefines
