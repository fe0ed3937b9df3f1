// SPDX-License-Identifier: MPL-2.0
// Real 1 um latex spheres in water; skipped where ../shared/data is absent.
#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "support/shared_data.hpp"
#include "vision/track.hpp"

namespace porefines::vision {

/// references.md F: D = 0.417 um^2/s by another tracker, 0.35 to 0.49 accepted; Stokes-Einstein 0.49.
TEST(BulkWater, particles_and_diffusion) {
  const std::string frames = test::shared_file("videos/bulk_water");
  if (frames.empty()) {
    GTEST_SKIP() << "../shared/data/videos is not here";
  }
  const test::Scratch folder;
  TrackRequest request;
  request.video = frames;
  request.output_dir = folder / "out";
  request.threads = 2;
  request.settings = load_track(
      "", {"video.pixel_size=0.350877 um", "video.frame_rate=24 Hz", "video.annotate=false"});
  ASSERT_EQ(track(request), 0);
  const std::string json = test::read_text(folder / "out/summary.json");
  const double found = test::number(json, "diffusion_coefficient_m2_s");
  std::printf("[ measured ] D = %.3f um^2/s\n", 1e12 * found);
  EXPECT_GT(found, 0.35e-12);
  EXPECT_LT(found, 0.49e-12);
  EXPECT_GT(test::number(json, "particles_per_frame_mean"), 350);
  EXPECT_LT(test::number(json, "particles_per_frame_mean"), 400);
}

}  // namespace porefines::vision
