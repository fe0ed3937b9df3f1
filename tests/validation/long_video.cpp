// SPDX-License-Identifier: MPL-2.0
// Memory of `porefines track` does not grow with the video.
#include <filesystem>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "vision/scenes.hpp"

namespace porefines::vision {
namespace {

/// Peak memory over this many frames, of which sixty are different.
Real peak_of(const porefines::test::Scratch& folder, int frames) {
  const auto name = [&](int f) -> std::string {
    return folder / fmt::format("v{}/{:06}.png", frames, f);
  };
  make_folder(folder / fmt::format("v{}", frames));
  Microscope m;
  m.width = 200;
  m.height = 160;
  const cv::Mat light = still_light(m, {});
  const auto w = test::flow_walkers({m.width, m.height}, 40, 60, 0.2);
  for (int f = 0; f < frames; ++f) {
    if (f >= 60) {
      std::filesystem::create_hard_link(name(f % 60), name(f));
      continue;
    }
    std::vector<Seen> seen;
    for (const Spot& s : w.frames[static_cast<std::size_t>(f)]) {
      seen.push_back({s.x, s.y, 0, 4});
    }
    cv::imwrite(name(f), expose(m, light, seen, f));
  }
  const std::string out = fmt::format("out{}", frames);
  const auto result = porefines::test::porefines_in(
      folder.path(), {"track", fmt::format("v{}", frames), "video.pixel_size=1 um",
                      "video.frame_rate=10 Hz", "--no-video", "-o", out});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  const std::string summary = porefines::test::read_text(folder / (out + "/summary.json"));
  EXPECT_EQ(porefines::test::number(summary, "frames"), frames);
  return porefines::test::number(summary, "peak_memory_bytes");
}

TEST(LongVideo, ten_thousand_frames_take_the_memory_of_a_thousand) {
  const porefines::test::Scratch folder;
  const Real few = peak_of(folder, 1000);
  const Real many = peak_of(folder, 10000);
  std::printf("peak memory: 1,000 frames %.1f MB, 10,000 frames %.1f MB\n", 1e-6 * few,
              1e-6 * many);
  // One line of the series and a few numbers per track stay: less than 3 kB a frame.
  EXPECT_LT(many - few, 9000 * 3000.0);
}

}  // namespace
}  // namespace porefines::vision
