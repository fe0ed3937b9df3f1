// SPDX-License-Identifier: MPL-2.0
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <mpi.h>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/signals.hpp"
#include "vision/parallel.hpp"
#include "vision/track.hpp"

namespace porefines {
namespace {

struct Arguments {
  vision::TrackRequest request;
  std::vector<std::string> more;  ///< TRACK.toml and overrides, in any order
  bool no_video = false;
};

/// The word without '=' is the track file.
vision::TrackSettings settings_of(const std::vector<std::string>& more) {
  std::string file;
  std::vector<std::string> overrides;
  for (const std::string& word : more) {
    if (word.find('=') != std::string::npos && !std::filesystem::exists(word)) {
      overrides.push_back(word);
    } else if (file.empty()) {
      file = word;
    } else {
      throw InputError("one track file at a time: " + file + " and " + word);
    }
  }
  return vision::load_track(file, overrides);
}

}  // namespace

void add_track(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("track", about_track);
  command->footer(
      "Examples:\n"
      "  porefines track chip.avi track.toml -o out/chip\n"
      "  porefines track frames/ \"video.pixel_size=0.351 um\" \"video.frame_rate=24 Hz\"\n"
      "docs/track.md explains every key and file.");
  auto a = std::make_shared<Arguments>();
  command
      ->add_option("VIDEO", a->request.video, "a video file, or a folder with an image per frame")
      ->required();
  command->add_option("TRACK.toml", a->more,
                      "the track file, and key.path=value for single values");
  command->add_option("-o,--output", a->request.output_dir, "output folder (tracks)");
  command->add_flag("--debug", a->request.debug, "write the stages of the first frame, stages.png");
  command->add_flag("--resume", a->request.resume, "go on where an interrupted call stopped");
  command->add_flag("--no-video", a->no_video, "write no annotated.avi");
  a->request.threads = vision::hardware_threads();
  command->add_option("--threads", a->request.threads, "threads (all there are)")
      ->check(CLI::PositiveNumber);
  command->callback([a, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank != 0) {
      return;  // one process reads a video; its threads share the work
    }
    watch_signals();
    a->request.settings = settings_of(a->more);
    a->request.settings.video = a->request.settings.video && !a->no_video;
    exit_code = vision::track(a->request);
  });
}

}  // namespace porefines
