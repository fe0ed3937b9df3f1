// SPDX-License-Identifier: MPL-2.0
// Tracers in a computed flow -> synthetic video -> tracks -> comparison with what was put in.
#include <filesystem>

#include <gtest/gtest.h>

#include "vision/compare.hpp"
#include "vision/micromodel.hpp"
#include "vision/synthesize.hpp"
#include "vision/track.hpp"

namespace porefines::vision {
namespace {

TEST(ClosedLoop, agrees_with_the_run) {
  const porefines::test::Scratch folder;
  const FlowField field = test::computed_flow(folder);
  SynthesisRequest film;
  film.source = folder / "run";
  film.output_dir = folder / "video";
  film.microscope.width = film.microscope.height = 0;
  film.pixel_size = 1e-6;
  film.diameter = 4e-6;
  film.tracers.count = 150;
  film.tracers.frames = 60;
  film.tracers.stuck = 6;
  film.tracers.frame_time = 5e-6 / test::mean_speed(field);  // five pixels a frame
  ASSERT_EQ(synthesize(film), 60);
  std::filesystem::copy_file(folder / "video/truth/tracks.csv", folder / "run/tracks.csv");

  TrackRequest request;
  request.video = folder / "video/frames";
  request.output_dir = folder / "tracks";
  request.threads = 2;
  request.settings = load_track(
      folder / "video/track.toml",
      {"link.velocity_field=" + (folder / "run"), "video.annotate=false", "link.min_length=1"});
  ASSERT_EQ(track(request), 0);
  const RunAgreement a = compare({folder / "run", folder / "tracks", folder / "compared", {}});
  std::printf(
      "agreement %.4f, speed %.4f (at most %.4f), sigma x %.4f (%.4f), sigma y %.4f (%.4f), "
      "histogram %.4f, streamlines %.4f, stuck %.3f\n",
      a.agreement, a.speed_nrms, a.speed_largest, a.sigma_x_nrms, a.sigma_x_largest, a.sigma_y_nrms,
      a.sigma_y_largest, a.histogram_overlap, a.streamline_overlap, a.retained_matched);
  EXPECT_GT(a.agreement, 0.98);
  EXPECT_LT(a.speed_largest, 0.02);
  EXPECT_LT(a.sigma_x_largest, 0.02);
  EXPECT_LT(a.sigma_y_largest, 0.02);
  EXPECT_EQ(a.retained_matched, 1) << "all stuck particles are found";
  EXPECT_EQ(porefines::test::number(porefines::test::read_text(folder / "tracks/summary.json"),
                                    "tracks_stuck"),
            6)
      << "nothing else is taken for stuck";
  EXPECT_NEAR(a.alignment.angle, 0, 2e-3);
  EXPECT_NEAR(a.alignment.scale, 1, 2e-3);
}

}  // namespace
}  // namespace porefines::vision
