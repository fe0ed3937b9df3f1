// SPDX-License-Identifier: MPL-2.0
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "vision/synthesize.hpp"

namespace porefines {
namespace {

/// Quantities as the user wrote them.
struct Arguments {
  vision::SynthesisRequest request;
  std::vector<int> size;
  std::string pixel_size;
  std::string diameter = "0";
  std::string depth_of_field = "0";
  std::string frame_rate = "10 Hz";
  bool any_depth = false;
};

void run_synthesize(Arguments& a) {
  vision::SynthesisRequest& r = a.request;
  r.pixel_size =
      a.pixel_size.empty() ? 0 : parse_quantity(a.pixel_size, kind::length, "--pixel-size");
  r.diameter = parse_quantity(a.diameter, kind::length, "--diameter");
  r.depth_of_field = parse_quantity(a.depth_of_field, kind::length, "--depth-of-field");
  const Real rate = parse_quantity(a.frame_rate, kind::frequency, "--frame-rate");
  if (!(rate > 0)) {
    throw InputError("--frame-rate must be above 0");
  }
  r.tracers.frame_time = 1 / rate;
  r.tracers.middle = !a.any_depth;
  r.tracers.seed = r.microscope.seed;
  r.microscope.width = a.size.size() == 2 ? a.size[0] : 0;
  r.microscope.height = a.size.size() == 2 ? a.size[1] : 0;
  constexpr Real usual = 4;  // [pixels]
  r.diameter = r.diameter > 0 ? r.diameter : usual * r.pixel_size;
  const int frames = vision::synthesize(r);
  std::cout << fmt::format("{} frames in {}, the truth in {}/truth/tracks.csv\n", frames,
                           r.output_dir, r.output_dir);
  std::cout << fmt::format("next: porefines track {}/{} {}/track.toml\n", r.output_dir,
                           r.avi ? "video.avi" : "frames", r.output_dir);
}

}  // namespace

void add_synthesize(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("synthesize", about_synthesize);
  command->footer(
      "Examples:\n"
      "  porefines synthesize out/chip --pixel-size \"2 um\" --tracers 300 --frame-rate \"50 Hz\" "
      "-o video\n"
      "  porefines synthesize tracks.csv --size 640 424 --pixel-size \"1 um\" --snr 4 -o video");
  auto a = std::make_shared<Arguments>();
  vision::SynthesisRequest& r = a->request;
  vision::Microscope& m = r.microscope;
  command
      ->add_option("SOURCE", r.source, "tracks.csv, or the folder of a run with tracks or fields")
      ->required();
  command->add_option("-o,--output", r.output_dir, "output folder (video)");
  command->add_option("--pixel-size", a->pixel_size, "edge of a pixel in the sample");
  command->add_option("--size", a->size, "width and height in pixels (those of the run)")
      ->expected(2);
  command->add_option("--diameter", a->diameter, "of particles whose size is not known (4 pixels)");
  command->add_option("--grains", r.grains, "picture with dark grains (those of the run)");
  command->add_option("--snr", m.snr, "contrast / noise at the centre of a particle, 0: none (10)");
  command->add_option("--point-spread", m.point_spread, "standard deviation in pixels (1.2)");
  command->add_option("--depth-of-field", a->depth_of_field, "depth that is in focus (20 pixels)");
  command->add_option("--background", m.background, "grey level of the water (90)");
  command->add_option("--contrast", m.contrast, "of a particle, grey levels (90)");
  command->add_option("--uneven", m.uneven, "share of the light that one corner lacks (0.15)");
  command->add_option("--grain-level", m.grain, "grey level of grains / water (0.6)");
  command->add_flag("--dark", m.dark, "particles darker than the water");
  command->add_option("--tracers", r.tracers.count,
                      "points in the flow of a run without tracks (200)");
  command->add_option("--frames", r.tracers.frames, "of those (100)");
  command->add_option("--frame-rate", a->frame_rate, "of those (10 Hz)");
  command->add_option("--stuck", r.tracers.stuck, "further ones that never move (0)");
  command->add_flag("--any-depth", a->any_depth,
                    "tracers anywhere in the depth, not on its middle");
  command->add_option("--seed", m.seed, "another seed, another video (1)");
  command->add_flag("--avi", r.avi, "write video.avi (lossy) instead of images");
  command->callback([a, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      run_synthesize(*a);
    }
    exit_code = exit_code::done;
  });
}

}  // namespace porefines
