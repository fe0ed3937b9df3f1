// SPDX-License-Identifier: MPL-2.0
#include "vision/compare.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/json_read.hpp"
#include "report/draw_chart.hpp"
#include "vision/draw_tracks.hpp"
#include "vision/flow_field.hpp"
#include "vision/statistics.hpp"
#include "vision/video.hpp"

namespace porefines::vision {
namespace {

/// Field of view of the video [pixels, m].
struct View {
  int width = 0;
  int height = 0;
  Real pixel_size = 0;
  Real margin = 0;  ///< [pixels] along the border, where a particle is not seen whole
};

/// What one side has, inside of the view and in its coordinates.
struct Side {
  std::vector<Moment> moments;
  std::vector<Real> speeds;
  cv::Mat places;  ///< counts [float]
  std::vector<cv::Point2d> retained;
};

View read_view(const std::string& folder) {
  const std::string path = folder + "/summary.json";
  const auto summary = read_flat_json(path);
  if (!summary) {
    throw InputError(path + ": no such summary; give the output folder of porefines track");
  }
  const auto number = [&](const std::string& key) {
    const Real value = summary->number(key);
    if (!std::isfinite(value)) {
      throw InputError(fmt::format("{}: has no {}; is it of porefines track?", path, key));
    }
    return value;
  };
  const Real diameter = summary->number("particle_diameter_pixels");
  return {static_cast<int>(number("width_pixels")), static_cast<int>(number("height_pixels")),
          number("pixel_size_m"), std::isfinite(diameter) ? 0.5 * diameter : 0};
}

/// The same particle rests in one place however many rows say so.
void note_retained(std::vector<cv::Point2d>& places, const cv::Point2d& at, Real near) {
  const bool known = std::any_of(places.begin(), places.end(), [&](const cv::Point2d& p) {
    return std::hypot(p.x - at.x, p.y - at.y) < near;
  });
  if (!known) {
    places.push_back(at);
  }
}

bool is_in_view(const View& view, const cv::Point2d& at) {
  const Real x = at.x / view.pixel_size;
  const Real y = at.y / view.pixel_size;
  return x >= view.margin && y >= view.margin && x < view.width - view.margin &&
         y < view.height - view.margin;
}

/// @param to_view  from the table's places to those of the video
Side read_side(const std::string& table, const View& view, const Alignment& to_view) {
  Side side;
  side.places = cv::Mat(view.height, view.width, CV_32F, cv::Scalar(0));
  TrackReader reader(table);
  std::vector<TrackRow> rows;
  const Real c = to_view.scale * std::cos(to_view.angle);
  const Real s = to_view.scale * std::sin(to_view.angle);
  for (std::uint64_t n = 0; reader.next(rows); ++n) {
    std::vector<TrackRow> inside;
    for (TrackRow row : rows) {
      const cv::Point2d at = to_view.apply({row.x, row.y});
      const auto i = static_cast<int>(std::floor(at.x / view.pixel_size));
      const int j = view.height - 1 - static_cast<int>(std::floor(at.y / view.pixel_size));
      if (row.state == TrackState::out || !is_in_view(view, at)) {
        continue;
      }
      row.x = at.x;
      row.y = at.y;
      const Real u = row.u;
      row.u = c * u - s * row.v;
      row.v = s * u + c * row.v;
      inside.push_back(row);
      if (row.state == TrackState::retained) {
        note_retained(side.retained, at, 3 * view.pixel_size);
        continue;
      }
      side.places.at<float>(j, i) += 1;
      if (std::isfinite(row.u)) {
        side.speeds.push_back(std::hypot(row.u, row.v));
      }
    }
    Moment moment = moment_of(inside, n);
    moment.time = rows.front().time;
    side.moments.push_back(moment);
  }
  if (side.speeds.empty()) {
    throw InputError(table +
                     ": no moving particle in the field of view of the video\n"
                     "is the alignment right? --shift, --angle and --scale give it");
  }
  return side;
}

/// What both have at the times of the run: pairs of values.
std::vector<std::pair<Real, Real>> at_common_times(const Side& run, const Side& video,
                                                   Banded Moment::*member) {
  std::vector<std::pair<Real, Real>> out;
  std::size_t k = 0;
  for (const Moment& m : run.moments) {
    while (k + 1 < video.moments.size() && video.moments[k + 1].time < m.time) {
      ++k;
    }
    if (k + 1 >= video.moments.size()) {
      break;
    }
    const Moment& a = video.moments[k];
    const Moment& b = video.moments[k + 1];
    const Real t = std::clamp((m.time - a.time) / (b.time - a.time), 0.0, 1.0);
    const Real value = (1 - t) * (a.*member).value + t * (b.*member).value;
    const bool overlaps = m.time >= a.time - 1e-9 * b.time;
    if (overlaps && std::isfinite(value) && std::isfinite((m.*member).value)) {
      out.emplace_back((m.*member).value, value);
    }
  }
  return out;
}

struct Trend {
  Real correlation = 0;
  Real nrms = 1;
  Real largest = 1;
};

Trend trend_of(const std::vector<std::pair<Real, Real>>& pairs) {
  const auto n = static_cast<Real>(pairs.size());
  Real a = 0;
  Real b = 0;
  Real aa = 0;
  Real bb = 0;
  Real ab = 0;
  Real squares = 0;
  Real most = 0;
  for (const auto& [x, y] : pairs) {
    a += x / n;
    b += y / n;
  }
  for (const auto& [x, y] : pairs) {
    aa += (x - a) * (x - a);
    bb += (y - b) * (y - b);
    ab += (x - a) * (y - b);
    squares += (x - y) * (x - y) / n;
    most = std::max(most, std::abs(x - y));
  }
  if (pairs.empty() || !(a > 0)) {
    return {};
  }
  return {aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0, std::sqrt(squares) / a, most / a};
}

/// Shares of both in thirty bins up to what 99.5 % of the run's are below.
struct Histograms {
  report::Curve run{.name = "run"};
  report::Curve video{.name = "video"};
  Real overlap = 0;
};

Histograms histograms_of(const Side& run, const Side& video) {
  constexpr std::size_t bins = 30;
  std::vector<Real> sorted = run.speeds;
  const auto last = static_cast<std::ptrdiff_t>(0.995 * static_cast<Real>(sorted.size() - 1));
  std::nth_element(sorted.begin(), sorted.begin() + last, sorted.end());
  const Real top = std::max(1.02 * sorted[static_cast<std::size_t>(last)], 1e-30);
  Histograms out;
  for (auto* curve : {&out.run, &out.video}) {
    const auto& speeds = curve == &out.run ? run.speeds : video.speeds;
    curve->y.assign(bins, 0);
    for (const Real v : speeds) {
      const auto bin = static_cast<std::size_t>(std::min(v / top * bins, bins - 1.0));
      curve->y[bin] += 1 / static_cast<Real>(speeds.size());
    }
    for (std::size_t b = 0; b < bins; ++b) {
      curve->x.push_back((static_cast<Real>(b) + 0.5) * top / bins);
    }
  }
  for (std::size_t b = 0; b < bins; ++b) {
    out.overlap += std::min(out.run.y[b], out.video.y[b]);
  }
  return out;
}

/// Cosine between the maps of positions, blurred by three pixels: where one passes, so does the other.
Real overlap_of(const cv::Mat& a, const cv::Mat& b) {
  constexpr Real blur = 3;
  cv::Mat p;
  cv::Mat q;
  cv::GaussianBlur(a, p, {}, blur);
  cv::GaussianBlur(b, q, {}, blur);
  const Real length = cv::norm(p) * cv::norm(q);
  return length > 0 ? p.dot(q) / length : 0;
}

Real matched_share(const std::vector<cv::Point2d>& wanted, const std::vector<cv::Point2d>& there,
                   Real gate) {
  if (wanted.empty()) {
    return 1;
  }
  const auto hits = std::count_if(wanted.begin(), wanted.end(), [&](const cv::Point2d& a) {
    return std::any_of(there.begin(), there.end(), [&](const cv::Point2d& b) {
      return std::hypot(a.x - b.x, a.y - b.y) < gate;
    });
  });
  return static_cast<Real>(hits) / static_cast<Real>(wanted.size());
}

Alignment inverse(const Alignment& a) {
  Alignment out;
  out.angle = -a.angle;
  out.scale = 1 / a.scale;
  const Alignment turned{0, 0, out.angle, out.scale, 0};
  const cv::Point2d shift = turned.apply({a.shift_x, a.shift_y});
  out.shift_x = -shift.x;
  out.shift_y = -shift.y;
  return out;
}

/// Masks of both where they are known; otherwise both start at the same corner.
Alignment find_alignment(const CompareRequest& r, const View& view) {
  if (r.alignment) {
    return *r.alignment;
  }
  const cv::Mat video = read_grey(r.tracks_dir + "/grains.png");
  cv::Mat run;
  Vec3 low;
  if (std::filesystem::exists(r.run_dir + "/fields.xdmf")) {
    const FlowField field = read_flow(r.run_dir);
    low = field.low();
    const Vec3 size = field.high() - field.low();
    run = grain_picture(field,
                        {static_cast<int>(std::lround(size.x / view.pixel_size)),
                         static_cast<int>(std::lround(size.y / view.pixel_size))},
                        view.pixel_size);
  } else if (const cv::Mat picture = read_grey(r.run_dir + "/grains.png"); !picture.empty()) {
    run = picture < 128;
  }
  Alignment out;
  if (!video.empty() && !run.empty()) {
    out = align(video < 128, run, view.pixel_size);
  }
  out.shift_x += low.x;  // pictures start at the low corner of the run's box
  out.shift_y += low.y;
  return out;
}

report::Curve curve_of(const std::string& name, const Side& side, Banded Moment::*member,
                       report::Curve::Look look) {
  report::Curve out{.name = name};
  for (const Moment& m : side.moments) {
    out.x.push_back(m.time);
    out.y.push_back((m.*member).value);
    out.low.push_back((m.*member).low);
    out.high.push_back((m.*member).high);
  }
  out.look = look;
  return out;
}

/// Run blue, video orange, both dark; white where nobody was.
cv::Mat overlay(const Side& run, const Side& video) {
  cv::Mat out(run.places.size(), CV_8UC3, cv::Scalar(255, 255, 255));
  cv::Mat a;
  cv::Mat b;
  cv::dilate(run.places, a, cv::Mat::ones(3, 3, CV_8U));
  cv::dilate(video.places, b, cv::Mat::ones(3, 3, CV_8U));
  out.setTo(cv::Scalar(200, 140, 60), a > 0);
  out.setTo(cv::Scalar(60, 150, 240), b > 0);
  out.setTo(cv::Scalar(60, 60, 60), (a > 0) & (b > 0));
  return out;
}

void draw(const std::string& folder, const Side& run, const Side& video, const Histograms& h) {
  using Look = report::Curve::Look;
  const io::Provenance p = io::make_provenance(1, 0);
  const auto chart = [&](const std::string& file, const std::vector<report::Curve>& curves,
                         const report::ChartStyle& style) {
    report::write_picture(folder + "/" + file, report::draw_chart(curves, style), p);
  };
  chart("mean_speed.png",
        {curve_of("run", run, &Moment::speed, Look::line),
         curve_of("video", video, &Moment::speed, Look::line)},
        {.title = "Mean speed, 95 % bands",
         .x_name = "time",
         .x_unit = "s",
         .y_name = "mean speed",
         .y_unit = "m/s"});
  chart("sigma.png",
        {curve_of("run, along x", run, &Moment::sigma_x, Look::line),
         curve_of("video, along x", video, &Moment::sigma_x, Look::line),
         curve_of("run, along y", run, &Moment::sigma_y, Look::line),
         curve_of("video, along y", video, &Moment::sigma_y, Look::line)},
        {.title = "Standard deviation of the positions",
         .x_name = "time",
         .x_unit = "s",
         .y_name = "sigma",
         .y_unit = "m"});
  chart("speed_histogram.png", {h.run, h.video},
        {.title = "Speeds of all particles at all times",
         .x_name = "speed",
         .x_unit = "m/s",
         .y_name = "share"});
  write_mat(folder + "/streamlines.png", overlay(run, video), p);
}

void write_numbers(const std::string& folder, const RunAgreement& a) {
  Json json;
  json.set("agreement", a.agreement);
  json.set("mean_speed_correlation", a.speed_correlation);
  json.set("mean_speed_nrms", a.speed_nrms);
  json.set("mean_speed_largest_difference", a.speed_largest);
  json.set("sigma_x_nrms", a.sigma_x_nrms);
  json.set("sigma_x_largest_difference", a.sigma_x_largest);
  json.set("sigma_y_nrms", a.sigma_y_nrms);
  json.set("sigma_y_largest_difference", a.sigma_y_largest);
  json.set("speed_histogram_overlap", a.histogram_overlap);
  json.set("streamline_overlap", a.streamline_overlap);
  json.set("retained_matched", a.retained_matched);
  json.set("alignment_shift_x_m", a.alignment.shift_x);
  json.set("alignment_shift_y_m", a.alignment.shift_y);
  json.set("alignment_angle_rad", a.alignment.angle);
  json.set("alignment_scale", a.alignment.scale);
  json.set("alignment_overlap", a.alignment.overlap);
  for (const auto& [name, value] : io::entries(io::make_provenance(1, 0))) {
    json.set(name, value);
  }
  write_file(folder + "/agreement.json", json.text());
}

}  // namespace

RunAgreement compare(const CompareRequest& r) {
  const View view = read_view(r.tracks_dir);
  RunAgreement a;
  a.alignment = find_alignment(r, view);
  const Side video = read_side(r.tracks_dir + "/tracks.csv", view, {});
  const Side run = read_side(r.run_dir + "/tracks.csv", view, inverse(a.alignment));
  const Trend speed = trend_of(at_common_times(run, video, &Moment::speed));
  const Trend x = trend_of(at_common_times(run, video, &Moment::sigma_x));
  const Trend y = trend_of(at_common_times(run, video, &Moment::sigma_y));
  a.speed_correlation = speed.correlation;
  a.speed_nrms = speed.nrms;
  a.speed_largest = speed.largest;
  a.sigma_x_nrms = x.nrms;
  a.sigma_x_largest = x.largest;
  a.sigma_y_nrms = y.nrms;
  a.sigma_y_largest = y.largest;
  const Histograms h = histograms_of(run, video);
  a.histogram_overlap = h.overlap;
  a.streamline_overlap = overlap_of(run.places, video.places);
  constexpr Real gate = 5;  // [pixels]
  a.retained_matched = matched_share(run.retained, video.retained, gate * view.pixel_size);
  const auto closeness = [](Real nrms) { return std::max(0.0, 1 - nrms); };
  a.agreement = (closeness(a.speed_nrms) + closeness(a.sigma_x_nrms) + closeness(a.sigma_y_nrms) +
                 a.histogram_overlap + a.streamline_overlap) /
                5;
  make_folder(r.output_dir);
  draw(r.output_dir, run, video, h);
  write_numbers(r.output_dir, a);
  return a;
}

}  // namespace porefines::vision
