// SPDX-License-Identifier: MPL-2.0
#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

/// Tracers in a chip's flow, filmed by the synthetic microscope, tracked, compared with what was put in.
Job loop_job() {
  return {.name = "loop",
          .case_text = R"(title = "Tracers in an etched micromodel"
[geometry]
source = "chip.png"
pixel_size = "2 um"
depth = "20 um"
[grid]
cell_size = "2 um"
[fluid]
density = "998.2 kg/m^3"
viscosity = "1.002 mPa s"
[flow]
inlet = { face = "x-", pressure = "12 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
walls = ["z-", "z+"]
slip = ["y-", "y+"]
[[output]]
kind = "fields"
)",
          .after = {{"synthesize", "out", "--pixel-size", "2 um", "--tracers", "150", "--frames",
                     "60", "--frame-rate", "25 Hz", "-o", "film"},
                    {"copy", "film/truth/tracks.csv", "out/tracks.csv"},
                    {"track", "film/frames", "film/track.toml", "video.annotate=false",
                     "link.min_length=1", "link.velocity_field=out", "-o", "video"},
                    {"compare", "out", "video", "-o", "compared"}},
          .generate = {"generate", "micromodel", "--size", "1.2 mm", "0.9 mm", "--pixel-size",
                       "2 um", "--grain", "60 um", "--porosity", "0.5", "--throat", "12 um",
                       "--seed", "2021", "-o", "chip.png"}};
}

Row less_than_one(const std::string& label, const std::string& key, Real tolerance) {
  return {.label = label,
          .source = FromSummary{key, -1, 1, "compared/agreement.json"},
          .reference = 1,
          .tolerance = tolerance};
}

}  // namespace

void add_microscope(std::vector<Comparison>& list) {
  list.push_back(
      {.name = "microscope",
       .title = "A run against a film of it (thesis, figs. 17 to 19)",
       .quantity = "1 less the relative difference (rms over time)",
       .reference = "the truth that the synthetic microscope filmed: 150 tracers in the flow of a "
                    "chip, 60 frames",
       .jobs = {loop_job()},
       .rows = {less_than_one("mean speed (fig. 18)", "mean_speed_nrms", 0.02),
                less_than_one("σ along x (fig. 19)", "sigma_x_nrms", 0.02),
                less_than_one("σ along y (fig. 19)", "sigma_y_nrms", 0.02)},
       .pictures = {
           {"compared/streamlines.png", "Streamlines of the run and of the film (fig. 17)."},
           {"compared/mean_speed.png", "Mean speed against time (fig. 18)."},
           {"compared/sigma.png", "Spread along x and y against time (fig. 19)."}}});
}

}  // namespace porefines::validate
