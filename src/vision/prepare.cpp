// SPDX-License-Identifier: MPL-2.0
#include "vision/prepare.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"

namespace porefines::vision {
namespace {

constexpr std::size_t least_frames = 12;  // for a median that means something
constexpr int smallest_grain = 150;       // [pixels]

cv::Mat outside(const std::array<int, 4>& region, cv::Size size) {
  cv::Mat mask(size, CV_8U, cv::Scalar(255));
  const cv::Rect wanted(region[0], region[1], region[2], region[3]);
  const cv::Rect inside = wanted & cv::Rect(cv::Point(), size);
  if (inside.area() == 0) {
    throw InputError(fmt::format("video.region lies outside of the frame of {} x {} pixels",
                                 size.width, size.height));
  }
  mask(inside).setTo(0);
  return mask;
}

cv::Mat both(const cv::Mat& a, const cv::Mat& b) {
  return a.empty() ? b : b.empty() ? a : cv::Mat(a | b);
}

DetectWishes in_pixels(const TrackSettings& settings) {
  DetectWishes wishes = settings.detect;
  if (settings.diameter > 0) {
    wishes.diameter = settings.diameter / settings.pixel_size;
  }
  if (settings.separation > 0) {
    wishes.separation = settings.separation / settings.pixel_size;
  }
  return wishes;
}

}  // namespace

std::vector<cv::Mat> sample_frames(const std::string& path, int start, int stop, int most) {
  Video video(path);
  // A video file gives its frames only one after the other.
  const int window = std::filesystem::is_directory(path) ? 2000 : 400;
  int last = start + window - 1;
  last = video.frames() > 0 ? std::min(last, video.frames() - 1) : last;
  last = stop >= 0 ? std::min(last, stop) : last;
  const int count = std::clamp(last - start + 1, 1, most);
  std::vector<cv::Mat> out;
  for (int k = 0; k < count; ++k) {
    video.seek(start +
               static_cast<int>(static_cast<Index>(k) * (last - start) / std::max(count - 1, 1)));
    const auto frames = video.read(1);
    if (frames.empty()) {
      break;
    }
    out.push_back(frames[0]);
  }
  if (out.empty()) {
    throw InputError(fmt::format("{}: there is no frame {}", path, start));
  }
  return out;
}

Prepared prepare(const std::string& path, const TrackSettings& settings) {
  constexpr int most_frames = 40;
  Prepared p;
  p.sample = sample_frames(path, settings.start, settings.stop, most_frames);
  const cv::Size size = p.sample[0].size();
  if (!settings.mask.empty()) {
    p.still.grains = read_mask(settings.mask, size, settings.grains);
  }
  const bool enough = p.sample.size() >= least_frames;
  if (enough || settings.background == BackgroundKind::median) {
    p.median = median_light(p.sample);
  }
  if (enough && settings.mask.empty()) {
    p.still.grains = find_grains(p.sample, p.median, settings.grains, smallest_grain);
  }
  const bool subtract =
      settings.background == BackgroundKind::median ||
      (settings.background == BackgroundKind::automatic && enough && !p.still.grains.empty());
  if (settings.region[2] > 0) {
    p.still.grains = both(p.still.grains, outside(settings.region, size));
  }
  const DetectWishes wishes = in_pixels(settings);
  constexpr std::size_t few = 6;
  std::vector<cv::Mat> some;
  for (std::size_t k = 0; k < std::min(few, p.sample.size()); ++k) {
    some.push_back(p.sample[k * p.sample.size() / std::min(few, p.sample.size())]);
  }
  if (subtract) {
    p.still.light = p.median;
    const DetectSettings first = estimate(some, p.still, wishes);
    p.still.light = without_stuck(p.median, p.still.grains, first, &p.stuck);
  }
  p.detect = estimate(some, p.still, wishes);
  return p;
}

std::string describe(const Prepared& p, Real pixel_size) {
  const DetectSettings& d = p.detect;
  const std::vector<std::string> centres{"contour", "centroid", "gaussian"};
  std::string text = fmt::format(
      "particles: {}, diameter {} pixels ({:.3g} um), separation {:.1f} pixels, threshold {:.2f} "
      "and "
      "least mass {:.1f} grey levels, centre {}{}",
      d.dark ? "dark" : "bright", d.diameter, 1e6 * pixel_size * d.diameter, d.separation,
      d.threshold, d.least_mass, centres[static_cast<std::size_t>(d.centre)],
      d.whole_levels ? ", background in whole grey levels" : "");
  text += p.still.grains.empty() ? "\ngrains: none"
                                 : fmt::format("\ngrains: {:.1f} % of the frame",
                                               100.0 * cv::countNonZero(p.still.grains) /
                                                   static_cast<Real>(p.still.grains.total()));
  text += p.still.light.empty()
              ? ""
              : fmt::format("; median of {} frames taken away, {} particles in it", p.sample.size(),
                            p.stuck);
  return text;
}

}  // namespace porefines::vision
