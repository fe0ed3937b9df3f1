// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/json.hpp"
#include "vision/draw_tracks.hpp"
#include "vision/statistics.hpp"

namespace porefines::vision {

/// What follows from tracks, whoever made them: series.csv, histograms, mean-square displacement, pictures.
/// Rows come time by time; memory does not grow with them, except for one line of the series per time.
class TrackResults {
 public:
  /// @param pixels  of the picture of streamlines
  TrackResults(cv::Size pixels, const Scale& scale);

  void add(int frame, std::span<const TrackRow> rows);

  /// Writes all files into the folder and adds its numbers to the summary.
  void write(const std::string& folder, const cv::Mat& grains, const io::Provenance& provenance,
             Json& summary) const;

  [[nodiscard]] const std::vector<Moment>& moments() const { return moments_; }

 private:
  void write_histogram(const std::string& folder, const io::Provenance& provenance) const;
  void write_series(const std::string& folder, const io::Provenance& provenance) const;
  void write_squares(const std::string& folder, const io::Provenance& provenance,
                     Json& summary) const;

  Scale scale_;
  Streamlines streamlines_;
  SpeedMap speed_map_;
  MeanSquares squares_;
  std::vector<Moment> moments_;
  std::vector<Real> speeds_;  ///< counts of a logarithmic histogram, see results.cpp
};

}  // namespace porefines::vision
