// SPDX-License-Identifier: MPL-2.0
#include "vision/results.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "report/draw_chart.hpp"

namespace porefines::vision {
namespace {

constexpr int lags = 20;  // [frames] of the mean-square displacement
constexpr int fitted_lags = 10;
constexpr int map_cell = 16;     // [pixels]
constexpr int fine_bins = 4096;  // of the histogram that is kept: 1 pixel a frame is at bin 64
constexpr Real bins_per_step = 64;

report::Curve curve(const std::string& name, const std::vector<Moment>& moments,
                    Banded Moment::*member) {
  report::Curve out;
  out.name = name;
  for (const Moment& m : moments) {
    const Banded& b = m.*member;
    out.x.push_back(m.time);
    out.y.push_back(b.value);
    out.low.push_back(b.low);
    out.high.push_back(b.high);
  }
  return out;
}

/// Mean over the moments, each weighted by its particles.
Real mean_of(const std::vector<Moment>& moments, Banded Moment::*member) {
  Real sum = 0;
  Real weight = 0;
  for (const Moment& m : moments) {
    if (std::isfinite((m.*member).value)) {
      sum += static_cast<Real>(m.particles) * (m.*member).value;
      weight += static_cast<Real>(m.particles);
    }
  }
  return weight > 0 ? sum / weight : TrackRow::unknown;
}

}  // namespace

TrackResults::TrackResults(cv::Size pixels, const Scale& scale)
    : scale_(scale),
      streamlines_(pixels, scale),
      speed_map_(pixels, scale, map_cell),
      squares_(lags),
      speeds_(fine_bins, 0) {}

void TrackResults::add(int frame, std::span<const TrackRow> rows) {
  Moment moment = moment_of(rows, static_cast<std::uint64_t>(frame));
  moment.time = time_of(scale_, frame);
  moments_.push_back(moment);
  streamlines_.add(rows);
  speed_map_.add(rows);
  squares_.add(frame, rows);
  const Real unit = scale_.pixel_size / scale_.frame_time / bins_per_step;
  for (const TrackRow& row : rows) {
    if (row.state == TrackState::mobile && std::isfinite(row.u)) {
      const Real bin = std::min(std::hypot(row.u, row.v) / unit, fine_bins - 1.0);
      speeds_[static_cast<std::size_t>(bin)] += 1;
    }
  }
}

void TrackResults::write_series(const std::string& folder, const io::Provenance& provenance) const {
  std::string text =
      "time_s,particles_inside,particles_retained,mean_speed_m_s,mean_speed_low_m_s,"
      "mean_speed_high_m_s,sigma_x_m,sigma_x_low_m,sigma_x_high_m,sigma_y_m,sigma_y_low_m,"
      "sigma_y_high_m,mean_x_m,mean_y_m\n";
  for (const Moment& m : moments_) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", m.time, m.particles,
                        m.retained, m.speed.value, m.speed.low, m.speed.high, m.sigma_x.value,
                        m.sigma_x.low, m.sigma_x.high, m.sigma_y.value, m.sigma_y.low,
                        m.sigma_y.high, m.mean_x, m.mean_y);
  }
  write_file(folder + "/series.csv", text);
  report::write_picture(
      folder + "/mean_speed.png",
      report::draw_chart({curve("", moments_, &Moment::speed)}, {.title = "Mean speed, 95 % band",
                                                                 .x_name = "time",
                                                                 .x_unit = "s",
                                                                 .y_name = "mean speed",
                                                                 .y_unit = "m/s"}),
      provenance);
  report::write_picture(
      folder + "/sigma.png",
      report::draw_chart({curve("along x", moments_, &Moment::sigma_x),
                          curve("along y", moments_, &Moment::sigma_y)},
                         {.title = "Standard deviation of the positions, 95 % bands",
                          .x_name = "time",
                          .x_unit = "s",
                          .y_name = "sigma",
                          .y_unit = "m"}),
      provenance);
}

void TrackResults::write_histogram(const std::string& folder,
                                   const io::Provenance& provenance) const {
  const Real total = std::accumulate(speeds_.begin(), speeds_.end(), Real{0});
  constexpr int bins = 30;
  Real below = 0;
  std::size_t last = 0;  // the fine bin that 99.5 % lie below
  while (last + 1 < speeds_.size() && below < 0.995 * total) {
    below += speeds_[last++];
  }
  const std::size_t width = std::max<std::size_t>(1, (last + bins - 1) / bins);
  const Real unit = scale_.pixel_size / scale_.frame_time / bins_per_step;
  report::Curve bars;
  bars.look = report::Curve::Look::bars;
  std::string text = "speed_low_m_s,speed_high_m_s,share\n";
  for (std::size_t b = 0; b < bins; ++b) {
    Real count = 0;
    for (std::size_t k = b * width; k < std::min((b + 1) * width, speeds_.size()); ++k) {
      count += speeds_[k];
    }
    const Real low = static_cast<Real>(b * width) * unit;
    const Real high = static_cast<Real>((b + 1) * width) * unit;
    bars.x.push_back(0.5 * (low + high));
    bars.y.push_back(total > 0 ? count / total : 0);
    text += fmt::format("{},{},{}\n", low, high, bars.y.back());
  }
  write_file(folder + "/speed_histogram.csv", text);
  report::write_picture(folder + "/speed_histogram.png",
                        report::draw_chart({bars}, {.title = "Speeds of all particles at all times",
                                                    .x_name = "speed",
                                                    .x_unit = "m/s",
                                                    .y_name = "share"}),
                        provenance);
}

void TrackResults::write_squares(const std::string& folder, const io::Provenance& provenance,
                                 Json& summary) const {
  const auto squares = squares_.result();
  const Diffusion fit = fit_diffusion(squares, scale_.frame_time, fitted_lags);
  std::string text = "lag_s,mean_square_displacement_m2,samples\n";
  report::Curve points{.name = "measured", .look = report::Curve::Look::points};
  report::Curve line{.name = fmt::format("4 D t + 4 e^2, D = {:.3g} m^2/s", fit.coefficient)};
  for (std::size_t k = 1; k < squares.size(); ++k) {
    if (squares[k].count > 0) {
      const Real t = static_cast<Real>(k) * scale_.frame_time;
      text += fmt::format("{},{},{}\n", t, squares[k].mean_square, squares[k].count);
      points.x.push_back(t);
      points.y.push_back(squares[k].mean_square);
      line.x.push_back(t);
      line.y.push_back(4 * fit.coefficient * t + 4 * fit.error * fit.error);
    }
  }
  write_file(folder + "/msd.csv", text);
  report::write_picture(
      folder + "/msd.png",
      report::draw_chart({points, line},
                         {.title = "Mean-square displacement without the common drift",
                          .x_name = "lag",
                          .x_unit = "s",
                          .y_name = "mean square",
                          .y_unit = "m^2",
                          .logarithmic = true}),
      provenance);
  summary.set("diffusion_coefficient_m2_s", fit.coefficient);
  summary.set("localisation_error_m", fit.error);
}

void TrackResults::write(const std::string& folder, const cv::Mat& grains,
                         const io::Provenance& provenance, Json& summary) const {
  Real inside = 0;
  for (const Moment& m : moments_) {
    inside += static_cast<Real>(m.particles + m.retained);
  }
  summary.set("particles_per_frame_mean",
              moments_.empty() ? 0 : inside / static_cast<Real>(moments_.size()));
  summary.set("mean_speed_m_s", mean_of(moments_, &Moment::speed));
  summary.set("sigma_x_mean_m", mean_of(moments_, &Moment::sigma_x));
  summary.set("sigma_y_mean_m", mean_of(moments_, &Moment::sigma_y));
  write_series(folder, provenance);
  write_histogram(folder, provenance);
  write_squares(folder, provenance, summary);
  write_file(folder + "/speed_map.csv", speed_map_.table());
  report::write_picture(folder + "/speed_map.png", speed_map_.picture(grains), provenance);
  write_mat(folder + "/streamlines.png", streamlines_.picture(grains), provenance);
}

}  // namespace porefines::vision
