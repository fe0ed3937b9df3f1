// SPDX-License-Identifier: MPL-2.0
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "io/read_table.hpp"
#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

Job tracked(const std::string& name, const std::string& frames, const std::string& pixel) {
  return {.name = name,
          .instead = {"track", frames, "video.pixel_size=" + pixel, "video.frame_rate=24 Hz",
                      "--no-video", "-o", "out"}};
}

/// Another tracker's particles in bulk water; its D is 0.417 um^2/s, Stokes and Einstein's 0.49.
Comparison bulk_water(const std::string& data) {
  return {.name = "bulk_water",
          .title = "Brownian motion under a microscope",
          .quantity = "um²/s; particles in a frame",
          .reference =
              "references.md F: 0.35 to 0.49 um²/s are accepted, 0.417 by another tracker; "
              "about 372 particles",
          .jobs = {tracked("video", data + "/videos/bulk_water", "0.350877 um")},
          .rows = {{.label = "diffusivity by the mean square displacement (um²/s)",
                    .source = FromSummary{"diffusion_coefficient_m2_s", 1e12},
                    .reference = 0.42,
                    .tolerance = 0.165},
                   {.label = "particles in a frame",
                    .source = FromSummary{"particles_per_frame_mean"},
                    .reference = 372,
                    .tolerance = 0.05}}};
}

/// Share of the listed centres [pixels, y downwards] that have a tracked particle within half a pixel in the first frame.
Real found_centres(const std::string& list, const std::string& out, Real height) {
  constexpr Real gate = 0.5;
  constexpr Real pixel = 1e-6;  // of the job
  std::vector<Vec3> spots;
  io::for_rows(out + "/tracks.csv", [&](const io::TextTable& head, const auto& words) {
    const auto number = [&](const char* name) {
      return io::number_of(words[static_cast<std::size_t>(head.column(name))]);
    };
    if (number("time_s") == 0) {
      spots.push_back({number("x_m") / pixel - 0.5, height - number("y_m") / pixel - 0.5, 0});
    }
  });
  const io::TextTable listed = io::read_table(list);
  const std::vector<Real> x = listed.numbers("x_px");
  const std::vector<Real> y = listed.numbers("y_px");
  Real found = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    bool hit = false;
    for (const Vec3& spot : spots) {
      hit = hit || norm(spot - Vec3{x[i], y[i], 0}) <= gate;
    }
    found += hit ? 1 : 0;
  }
  return x.empty() ? NAN : found / static_cast<Real>(x.size());
}

Comparison centres(const std::string& data) {
  const std::string frames = data + "/videos/image_sequence";
  return {.name = "centres",
          .title = "Centres that another tracker found",
          .quantity = "share found within half a pixel",
          .reference = "references.md F: at least 0.97 of 344",
          .jobs = {tracked("video", frames, "1 um")},
          .rows = {{.label = "first frame of image_sequence",
                    .source = Computed{[=](Folders folders) {
                      constexpr Real height = 424;  // pixels
                      return found_centres(frames + "/T76S3F00001_centres.csv", folders[0] + "/out",
                                           height);
                    }},
                    .reference = 1,
                    .tolerance = 0.03}}};
}

}  // namespace

void add_videos(std::vector<Comparison>& list, const std::string& data) {
  if (data.empty()) {
    return;
  }
  const std::string folder = std::filesystem::absolute(data).string();
  if (!std::filesystem::is_directory(folder + "/videos")) {
    throw InputError("--data " + data +
                     ": there is no folder videos in it\ngive the folder that holds "
                     "videos/bulk_water and videos/image_sequence");
  }
  list.push_back(centres(folder));
  list.push_back(bulk_water(folder));
}

}  // namespace porefines::validate
