// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "report/picture.hpp"
#include "vision/detect.hpp"
#include "vision/emit.hpp"
#include "vision/statistics.hpp"

namespace porefines::vision {

/// All places of mobile particles in one picture: the streamlines of the thesis's figure 17.
class Streamlines {
 public:
  /// @param scale  of the positions; one pixel of the picture per pixel of the video
  Streamlines(cv::Size size, const Scale& scale)
      : scale_(scale), counts_(size, CV_32S, cv::Scalar(0)) {}
  void add(std::span<const TrackRow> rows);
  /// Dark where particles were, grains grey.
  [[nodiscard]] cv::Mat picture(const cv::Mat& grains) const;
  [[nodiscard]] const cv::Mat& counts() const { return counts_; }

 private:
  Scale scale_;
  cv::Mat counts_;
};

/// Mean speed on a grid of square cells.
class SpeedMap {
 public:
  SpeedMap(cv::Size frame, const Scale& scale, int cell);
  void add(std::span<const TrackRow> rows);
  /// @param grains  nonzero: a grain; may be empty
  [[nodiscard]] report::Picture picture(const cv::Mat& grains) const;
  /// x_m, y_m, u_m_s, v_m_s, speed_m_s, samples of every cell that has some.
  [[nodiscard]] std::string table() const;

 private:
  Scale scale_;
  int cell_;
  int nx_;
  int ny_;
  std::vector<Real> u_;
  std::vector<Real> v_;
  std::vector<Real> speed_;
  std::vector<Real> count_;
};

/// The frame in colour with a ring around every particle and an arrow along its velocity: the way of
/// `arrow_time`. Retained ones have a square.
[[nodiscard]] cv::Mat draw_arrows(const cv::Mat& frame, std::span<const TrackRow> rows,
                                  const Scale& scale, Real arrow_time, int diameter);

/// The stages of the detection side by side, with their names.
[[nodiscard]] cv::Mat draw_stages(const Stages& stages, const Still& still,
                                  std::span<const Spot> spots, int diameter);

/// Saves a colour (blue, green, red) or grey OpenCV picture with its provenance.
void write_mat(const std::string& path, const cv::Mat& picture, const io::Provenance& provenance);

}  // namespace porefines::vision
