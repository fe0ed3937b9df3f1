// SPDX-License-Identifier: MPL-2.0
#include "vision/draw_tracks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "io/png.hpp"
#include "report/picture_text.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

/// In pixels of the frame, y down.
cv::Point2d pixel_of(const TrackRow& row, const Scale& scale) {
  return {row.x / scale.pixel_size - 0.5, scale.height - 0.5 - row.y / scale.pixel_size};
}

cv::Point rounded(const cv::Point2d& p) {
  return {static_cast<int>(std::lround(p.x)), static_cast<int>(std::lround(p.y))};
}

/// Stretched to 0..255 between its extremes, leaving out a thousandth at either end.
cv::Mat stretched(const cv::Mat& picture) {
  cv::Mat values;
  picture.convertTo(values, CV_32F);
  std::vector<float> sorted(values.begin<float>(), values.end<float>());
  const std::size_t edge = sorted.size() / 1000;
  std::nth_element(sorted.begin(), sorted.begin() + static_cast<std::ptrdiff_t>(edge),
                   sorted.end());
  const float low = sorted[edge];
  std::nth_element(sorted.begin(), sorted.end() - 1 - static_cast<std::ptrdiff_t>(edge),
                   sorted.end());
  const float high = sorted[sorted.size() - 1 - edge];
  cv::Mat out;
  const double factor = high > low ? 255.0 / (high - low) : 1;
  values.convertTo(out, CV_8U, factor, -low * factor);
  return out;
}

cv::Mat in_colour(const cv::Mat& grey) {
  cv::Mat out;
  cv::cvtColor(grey, out, cv::COLOR_GRAY2BGR);
  return out;
}

}  // namespace

void Streamlines::add(std::span<const TrackRow> rows) {
  for (const TrackRow& row : rows) {
    const cv::Point p = rounded(pixel_of(row, scale_));
    if (row.state == TrackState::mobile && cv::Rect(cv::Point(), counts_.size()).contains(p)) {
      counts_.at<int>(p) += 1;
    }
  }
}

cv::Mat Streamlines::picture(const cv::Mat& grains) const {
  cv::Mat out(counts_.size(), CV_8UC3, cv::Scalar(255, 255, 255));
  if (!grains.empty()) {
    out.setTo(cv::Scalar(189, 197, 203), grains);
  }
  for (int j = 0; j < out.rows; ++j) {
    for (int i = 0; i < out.cols; ++i) {
      const int n = counts_.at<int>(j, i);
      if (n > 0) {
        const report::Rgb c =
            report::colour(report::Colormap::pressure, std::min(1.0, 0.45 + 0.2 * n));
        out.at<cv::Vec3b>(j, i) = {c[2], c[1], c[0]};
      }
    }
  }
  return out;
}

SpeedMap::SpeedMap(cv::Size frame, const Scale& scale, int cell)
    : scale_(scale),
      cell_(cell),
      nx_((frame.width + cell - 1) / cell),
      ny_((frame.height + cell - 1) / cell) {
  const auto cells = static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_);
  for (auto* values : {&u_, &v_, &speed_, &count_}) {
    values->assign(cells, 0);
  }
}

void SpeedMap::add(std::span<const TrackRow> rows) {
  for (const TrackRow& row : rows) {
    if (row.state != TrackState::mobile || !std::isfinite(row.u)) {
      continue;
    }
    const Real edge = cell_ * scale_.pixel_size;
    const int i = std::clamp(static_cast<int>(row.x / edge), 0, nx_ - 1);
    const int j = std::clamp(static_cast<int>(row.y / edge), 0, ny_ - 1);
    const auto k = static_cast<std::size_t>(j * nx_ + i);
    u_[k] += row.u;
    v_[k] += row.v;
    speed_[k] += std::hypot(row.u, row.v);
    count_[k] += 1;
  }
}

report::Picture SpeedMap::picture(const cv::Mat& grains) const {
  report::SliceValues slice;
  slice.shape.width = nx_;
  slice.shape.height = ny_;
  slice.shape.cell_width = slice.shape.cell_height = cell_ * scale_.pixel_size;
  for (std::size_t k = 0; k < count_.size(); ++k) {
    const int x = (static_cast<int>(k) % nx_) * cell_ + cell_ / 2;
    const int up = (static_cast<int>(k) / nx_) * cell_ + cell_ / 2;
    const int y = scale_.height - 1 - up;
    const bool grain = !grains.empty() && x < grains.cols && y >= 0 &&
                       grains.at<std::uint8_t>(y, x) != 0 && count_[k] == 0;
    slice.values.push_back(static_cast<float>(count_[k] > 0 ? speed_[k] / count_[k] : 0));
    slice.grain.push_back(grain ? 1 : 0);
  }
  report::PictureStyle style;
  style.title = "Mean speed of the particles";
  style.quantity = "speed";
  style.unit = "m/s";
  style.smooth = false;
  return report::draw_slice(slice.view(), style);
}

std::string SpeedMap::table() const {
  std::string text = "x_m,y_m,u_m_s,v_m_s,speed_m_s,samples\n";
  for (std::size_t k = 0; k < count_.size(); ++k) {
    if (count_[k] > 0) {
      const Real edge = cell_ * scale_.pixel_size;
      const std::div_t at = std::div(static_cast<int>(k), nx_);
      text += fmt::format("{},{},{},{},{},{}\n", (at.rem + 0.5) * edge, (at.quot + 0.5) * edge,
                          u_[k] / count_[k], v_[k] / count_[k], speed_[k] / count_[k], count_[k]);
    }
  }
  return text;
}

cv::Mat draw_arrows(const cv::Mat& frame, std::span<const TrackRow> rows, const Scale& scale,
                    Real arrow_time, int diameter) {
  cv::Mat bytes;
  to_float(frame).convertTo(bytes, CV_8U);
  cv::Mat out = in_colour(bytes);
  const cv::Scalar moving(60, 200, 40);
  const cv::Scalar stuck(40, 60, 230);
  for (const TrackRow& row : rows) {
    const cv::Point2d at = pixel_of(row, scale);
    const cv::Point p = rounded(at);
    const int r = diameter / 2 + 1;
    if (row.state == TrackState::retained) {
      cv::rectangle(out, p - cv::Point(r, r), p + cv::Point(r, r), stuck, 1);
      continue;
    }
    cv::circle(out, p, r, moving, 1, cv::LINE_AA);
    if (std::isfinite(row.u)) {
      const cv::Point2d way(row.u, -row.v);
      const cv::Point tip = rounded(at + way * (arrow_time / scale.pixel_size));
      cv::arrowedLine(out, p, tip, cv::Scalar(30, 160, 250), 1, cv::LINE_AA, 0, 0.3);
    }
  }
  return out;
}

cv::Mat draw_stages(const Stages& stages, const Still& still, std::span<const Spot> spots,
                    int diameter) {
  cv::Mat grey;
  to_float(stages.grey).convertTo(grey, CV_8U);
  cv::Mat masked = in_colour(stretched(stages.flattened));
  if (!still.grains.empty()) {
    masked.setTo(cv::Scalar(150, 90, 40), still.grains);
  }
  cv::Mat found = in_colour(grey);
  for (const Spot& spot : spots) {
    cv::circle(found, rounded({spot.x, spot.y}), diameter / 2 + 1, cv::Scalar(60, 200, 40), 1,
               cv::LINE_AA);
  }
  const std::vector<std::pair<std::string, cv::Mat>> panels{
      {"1 grey", in_colour(grey)},
      {"2 Gaussian blur", in_colour(stretched(stages.blurred))},
      {"3 background and grains taken away", masked},
      {"4 threshold, erosion, dilation", in_colour(stages.binary)},
      {fmt::format("5 centres: {}", spots.size()), found}};
  constexpr int head = 34;
  const int width = grey.cols;
  const int height = grey.rows;
  cv::Mat out(2 * (height + head), 3 * width + 20, CV_8UC3, cv::Scalar(255, 255, 255));
  for (std::size_t k = 0; k < panels.size(); ++k) {
    const int column = static_cast<int>(k % 3);
    const int row = static_cast<int>(k / 3);
    const cv::Point corner(column * (width + 10), row * (height + head) + head);
    panels[k].second.copyTo(out(cv::Rect(corner, panels[k].second.size())));
    report::draw_text(out, panels[k].first, corner.x + 4, corner.y - 10, {.height = 14});
  }
  return out;
}

void write_mat(const std::string& path, const cv::Mat& picture, const io::Provenance& provenance) {
  cv::Mat rgb = picture;
  if (picture.channels() == 3) {
    cv::cvtColor(picture, rgb, cv::COLOR_BGR2RGB);
  }
  rgb = rgb.isContinuous() ? rgb : rgb.clone();
  io::write_png(path, {rgb.cols, rgb.rows, rgb.channels(), {rgb.datastart, rgb.dataend}},
                provenance);
}

}  // namespace porefines::vision
