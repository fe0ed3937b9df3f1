// SPDX-License-Identifier: MPL-2.0
#include "study/fit_run.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/permeability.hpp"
#include "core/error.hpp"
#include "core/json_read.hpp"
#include "io/read_table.hpp"

namespace porefines::study {
namespace {

/// Mean of what came in, by volume of suspension.
Real feed_of(const std::vector<Real>& volumes, const std::vector<Real>& inlet) {
  Real fines = 0;
  Real flow = 0;
  for (std::size_t i = 1; i < volumes.size(); ++i) {
    if (std::isfinite(inlet[i])) {
      fines += inlet[i] * (volumes[i] - volumes[i - 1]);
      flow += volumes[i] - volumes[i - 1];
    }
  }
  return flow > 0 ? fines / flow : 0;
}

void read_series(const std::string& path, RunBed& run) {
  const io::TextTable table = io::read_table(path);
  io::require_columns(
      table, path,
      {"pore_volumes", "permeability_ratio", "concentration_ratio", "inlet_concentration"});
  run.data.volumes = table.numbers("pore_volumes");
  run.data.concentration = table.numbers("concentration_ratio");
  for (const Real ratio : table.numbers("permeability_ratio")) {
    run.data.resistance.push_back(ratio > 0 ? 1 / ratio : std::nan(""));
  }
  run.bed.feed = feed_of(run.data.volumes, table.numbers("inlet_concentration"));
}

void read_profile(const std::string& path, RunBed& run) {
  io::TextTable table = io::read_table(path);
  io::require_columns(table, path,
                      {"time_s", "pore_volumes", "x_m", "retained_fraction", "porosity_clean"});
  table.keep_last("time_s");
  const std::vector<Real> retained = table.numbers("retained_fraction");
  const std::vector<Real> porosity = table.numbers("porosity_clean");
  run.data.x = table.numbers("x_m");
  for (std::size_t i = 0; i < retained.size(); ++i) {
    run.data.s.push_back(retained[i] * porosity[i]);
  }
  run.data.profile_at = table.numbers("pore_volumes").back();
}

}  // namespace

RunBed read_run_bed(const std::string& folder) {
  const auto summary = read_flat_json(folder + "/summary.json");
  if (!summary || !(summary->number("length_m") > 0)) {
    throw InputError(fmt::format(
        "{}/summary.json: cannot be read, or is not that of a run with a flow\ngive the output "
        "folder of porefines run",
        folder));
  }
  RunBed run;
  run.bed.length = summary->number("length_m");
  run.bed.porosity = summary->number("porosity_connected");
  read_series(folder + "/series.csv", run);
  read_profile(folder + "/retention.csv", run);
  run.pores = run.bed.length / analysis::equivalent_pore_diameter(
                                   summary->number("permeability_clean_m2"), run.bed.porosity);
  return run;
}

}  // namespace porefines::study
