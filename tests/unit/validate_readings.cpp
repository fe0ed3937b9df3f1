// SPDX-License-Identifier: MPL-2.0
#include <cmath>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "support/scratch.hpp"
#include "validate/read_result.hpp"

namespace porefines::validate {
namespace {

const std::string tracks = "time_s,id,x_m,w_m_s\n0,1,5,1\n0,2,1,-0.4\n1,1,6,1\n1,2,3,0.1\n1,2,cut";

/// Three folders of runs; k = 2 + h^2 on cells of 4, 2 and 1.
class ValidateReadings : public ::testing::Test {
 protected:
  ValidateReadings() {
    for (const int h : {4, 2, 1}) {
      folders_.push_back(scratch_ / ("h" + std::to_string(h)));
      make_folder(folders_.back() + "/out");
      write_file(folders_.back() + "/out/summary.json",
                 "{\n  \"k\": " + std::to_string(2 + h * h) + ",\n  \"k_m2\": 7\n}\n");
      write_file(folders_.back() + "/out/tracks.csv", tracks);
    }
  }
  test::Scratch scratch_;
  std::vector<std::string> folders_;
};

TEST_F(ValidateReadings, come_from_the_summary_and_the_tracks) {
  using enum FromTracks::Measure;
  const auto value = [&](const Source& source) {
    return read_row({.job = 1, .source = source}, folders_).value;
  };
  EXPECT_EQ(value(FromSummary{"k", 10}), 60);
  EXPECT_TRUE(std::isnan(value(FromSummary{"missing"})));
  EXPECT_EQ(value(FromTracks{2, "x_m", last}), 3);
  EXPECT_EQ(value(FromTracks{2, "x_m", change}), 2);
  EXPECT_NEAR(value(FromTracks{2, "w_m_s", ratio, -1}), 0.25, 1e-15);
  EXPECT_TRUE(std::isnan(value(FromTracks{7, "x_m", last})));
}

TEST_F(ValidateReadings, extrapolate_second_order_exactly) {
  const Reading reading = read_row({.source = Extrapolated{"k", {4, 2, 1}}}, folders_);
  EXPECT_NEAR(reading.value, 2, 1e-14);
  EXPECT_NEAR(reading.error, 1, 1e-14);
}

TEST_F(ValidateReadings, agree_within_the_tolerance_only) {
  const Row row{.reference = -2, .tolerance = 0.01};
  EXPECT_TRUE(agrees(row, {-2.0199}));
  EXPECT_FALSE(agrees(row, {-2.0201}));
  EXPECT_FALSE(agrees(row, {NAN}));
}

}  // namespace
}  // namespace porefines::validate
