// SPDX-License-Identifier: MPL-2.0
#include "vision/settings.hpp"

#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace porefines::vision {
namespace {

TEST(Settings, are_read_in_si) {
  const TrackSettings s =
      load_track("", {"video.pixel_size=0.351 um", "video.frame_rate=24 Hz", "detect.polarity=dark",
                      "link.method=thesis", "link.flow=x-", "video.region=[1, 2, 30, 40]"});
  EXPECT_DOUBLE_EQ(s.pixel_size, 0.351e-6);
  EXPECT_DOUBLE_EQ(s.frame_rate, 24);
  EXPECT_EQ(s.detect.dark, true);
  EXPECT_EQ(s.method, LinkMethod::thesis);
  EXPECT_EQ(s.flow, (std::array{-1, 0}));
  EXPECT_EQ(s.region, (std::array{1, 2, 30, 40}));
}

TEST(Settings, wrong_ones_say_what_would_be_right) {
  for (const auto& [given, said] : {std::pair{"link.max_speeed=1 um/s", "max_speed"},
                                    {"video.pixel_size=3", "length"},
                                    {"link.flow=z+", "x+"},
                                    {"video.start=-1", "whole number"}}) {
    try {
      (void)load_track("", {given});
      ADD_FAILURE() << given;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(said), std::string::npos) << error.what();
    }
  }
}

TEST(Settings, page_holds_the_table) {
  std::ifstream file(std::string(PF_SOURCE_DIR) + "/docs/track.md");
  std::ostringstream text;
  text << file.rdbuf();
  EXPECT_NE(text.str().find(track_reference()), std::string::npos)
      << "the end of docs/track.md should be:\n"
      << track_reference();
}

}  // namespace
}  // namespace porefines::vision
