// SPDX-License-Identifier: MPL-2.0
#include <iostream>
#include <memory>
#include <numbers>
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
#include "vision/compare.hpp"

namespace porefines {
namespace {

struct Arguments {
  vision::CompareRequest request;
  std::vector<std::string> shift;
  Real angle = 0;
  Real scale = 1;
};

void run_compare(Arguments& a, bool angle_or_scale) {
  if (!a.shift.empty() || angle_or_scale) {
    vision::Alignment given;
    if (a.shift.size() == 2) {
      given.shift_x = parse_quantity(a.shift[0], kind::length, "--shift");
      given.shift_y = parse_quantity(a.shift[1], kind::length, "--shift");
    }
    given.angle = a.angle * std::numbers::pi / 180;
    given.scale = a.scale;
    a.request.alignment = given;
  }
  const vision::RunAgreement r = vision::compare(a.request);
  std::cout << fmt::format(
      "agreement {:.4f}\nmean speed: correlation {:.3f}, off by {:.2f} % (rms), {:.2f} % at most\n"
      "sigma x: off by {:.2f} %, {:.2f} % at most; sigma y: {:.2f} %, {:.2f} % at most\n"
      "speed histograms overlap {:.3f}, streamlines {:.3f}; retained places matched {:.3f}\n"
      "alignment: shift {:.4g} um, {:.4g} um, angle {:.3f} degrees, scale {:.4f}\n{}\n",
      r.agreement, r.speed_correlation, 100 * r.speed_nrms, 100 * r.speed_largest,
      100 * r.sigma_x_nrms, 100 * r.sigma_x_largest, 100 * r.sigma_y_nrms, 100 * r.sigma_y_largest,
      r.histogram_overlap, r.streamline_overlap, r.retained_matched, 1e6 * r.alignment.shift_x,
      1e6 * r.alignment.shift_y, r.alignment.angle * 180 / std::numbers::pi, r.alignment.scale,
      "pictures and agreement.json are in " + a.request.output_dir);
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("compare", about_compare);
  command->footer(
      "Example:\n"
      "  porefines compare out/chip out/chip_video -o out/chip_compared");
  auto a = std::make_shared<Arguments>();
  command->add_option("RUN", a->request.run_dir, "output folder of a run with tracks.csv")
      ->required();
  command->add_option("TRACKS", a->request.tracks_dir, "output folder of porefines track")
      ->required();
  command->add_option("-o,--output", a->request.output_dir, "output folder (compare)");
  command->add_option("--shift", a->shift, "where the video's lower left corner lies in the run")
      ->expected(2);
  auto* angle = command->add_option("--angle", a->angle, "of the video in the run, degrees");
  auto* scale = command->add_option("--scale", a->scale, "of the video's lengths");
  command->callback([a, angle, scale, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      run_compare(*a, angle->count() + scale->count() > 0);
    }
    exit_code = exit_code::done;
  });
}

}  // namespace porefines
