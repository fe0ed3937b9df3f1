// SPDX-License-Identifier: MPL-2.0
// Real microscope frames; skipped where ../shared/data is absent.
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "support/shared_data.hpp"
#include "vision/assignment.hpp"
#include "vision/estimate.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

std::vector<cv::Point2d> read_centres(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::vector<cv::Point2d> out;
  while (std::getline(file, line)) {
    std::istringstream numbers(line);
    cv::Point2d p;
    char comma = 0;
    numbers >> p.x >> comma >> p.y;
    out.push_back(p);
  }
  return out;
}

/// How many of the listed centres have a spot of their own within the gate.
int hits(const std::vector<cv::Point2d>& listed, const std::vector<Spot>& spots, Real gate) {
  std::vector<Candidate> pairs;
  for (std::size_t i = 0; i < listed.size(); ++i) {
    for (std::size_t k = 0; k < spots.size(); ++k) {
      const Real d = std::hypot(listed[i].x - spots[k].x, listed[i].y - spots[k].y);
      if (d <= gate) {
        pairs.push_back({static_cast<int>(i), static_cast<int>(k), d});
      }
    }
  }
  const auto columns = assign(static_cast<int>(listed.size()), static_cast<int>(spots.size()),
                              pairs, std::vector<Real>(listed.size(), 10));
  return static_cast<int>(
      std::count_if(columns.begin(), columns.end(), [](int c) { return c >= 0; }));
}

/// Another tracker's 344 centres; nothing is given but the frames.
TEST(RealVideo, listed_centres_are_found) {
  const std::string folder = porefines::test::shared_file("videos/image_sequence");
  if (folder.empty()) {
    GTEST_SKIP() << "../shared/data/videos is not here";
  }
  const auto listed = read_centres(folder + "/T76S3F00001_centres.csv");
  ASSERT_EQ(listed.size(), 344U);
  const auto frames = Video(folder).read(5);
  ASSERT_EQ(frames.size(), 5U);
  const auto spots = detect(frames[0], {}, estimate(frames, {}, {}));
  const int found = hits(listed, spots, 0.5);
  EXPECT_GE(found, 0.97 * 344) << found;
  EXPECT_LT(static_cast<Real>(spots.size()) - found, 0.05 * 344) << spots.size();
}

TEST(RealVideo, bulk_water_holds_370_particles) {
  const std::string folder = porefines::test::shared_file("videos/bulk_water");
  if (folder.empty()) {
    GTEST_SKIP() << "../shared/data/videos is not here";
  }
  Video video(folder);
  const auto frames = video.read(150, 2);
  ASSERT_EQ(frames.size(), 150U);
  const DetectSettings s =
      estimate(std::vector<cv::Mat>{frames[0], frames[50], frames[100], frames[149]}, {}, {});
  EXPECT_TRUE(s.dark);
  Real sum = 0;
  for (std::size_t f = 0; f < frames.size(); f += 10) {
    sum += static_cast<Real>(detect(frames[f], {}, s).size());
  }
  EXPECT_GT(sum / 15, 350);
  EXPECT_LT(sum / 15, 400);
}

}  // namespace
}  // namespace porefines::vision
