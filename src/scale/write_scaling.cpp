// SPDX-License-Identifier: MPL-2.0
// Tables and charts of a scaling test.
#include <algorithm>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "io/provenance.hpp"
#include "report/draw_chart.hpp"
#include "scale/measure.hpp"

namespace porefines::scale {
namespace {

using report::Curve;

constexpr std::array<int, 6> far{64, 256, 1024, 2048, 4096, 8192};

std::string table(const std::vector<Series>& strong, const std::vector<Measured>& weak) {
  std::string text =
      "test,sample,ranks,seconds,speed_up,efficiency,compute_s,halo_s,reductions_s,waiting_s,"
      "messages_per_rank,bytes_per_rank,collectives_per_rank\n";
  const auto add = [&](const char* test, const std::string& name, const Measured& run,
                       Real speed_up) {
    text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{}\n", test, name, run.ranks,
                        run.seconds, speed_up, speed_up / run.ranks, run.compute(), run.halo,
                        run.reductions, run.waiting, run.messages, run.bytes, run.collectives);
  };
  for (const Series& series : strong) {
    for (const Measured& run : series.runs) {
      add("strong", series.name, run, series.runs.front().seconds / run.seconds);
    }
  }
  for (const Measured& run : weak) {
    add("weak", "grows with the ranks", run, run.ranks * weak.front().seconds / run.seconds);
  }
  return text;
}

/// Largest number of ranks that the model and the grid allow, up to 8192.
std::vector<int> possible(const ScalingModel& model) {
  std::vector<int> out;
  for (const int ranks : far) {
    try {
      (void)surface_of(model.cells, ranks);
      out.push_back(ranks);
    } catch (const InputError&) {
      break;  // blocks would be smaller than their ghosts
    }
  }
  return out;
}

void add_json(Json& json, const std::string& name, const Series& series, int cores) {
  const ScalingModel model = fit_model(series.cells, series.runs);
  for (const Measured& run : series.runs) {
    json.set(fmt::format("{}_seconds_{}", name, run.ranks), run.seconds);
    json.set(fmt::format("{}_speed_up_{}", name, run.ranks),
             series.runs.front().seconds / run.seconds);
  }
  json.set(name + "_recommended_ranks", recommend(series.runs, cores));
  json.set(name + "_model_fixed_s", model.fixed);
  json.set(name + "_model_work_s", model.work);
  json.set(name + "_model_latency_s", model.latency);
  json.set(name + "_model_bytes_per_s",
           model.seconds_per_byte > 0 ? 1 / model.seconds_per_byte : 0);
  json.set(name + "_model_hop_s", model.hop);
  json.set(name + "_model_waiting_share", model.waiting_share);
  for (const int ranks : possible(model)) {
    json.set(fmt::format("{}_extrapolated_seconds_{}", name, ranks), model.seconds(ranks));
  }
}

void draw(const std::string& output, const std::vector<Series>& strong) {
  std::vector<Curve> times;
  std::vector<Curve> efficiency;
  for (const Series& series : strong) {
    Curve measured{.name = series.name, .look = Curve::Look::points};
    Curve share{.name = series.name};
    for (const Measured& run : series.runs) {
      measured.x.push_back(run.ranks);
      measured.y.push_back(run.seconds);
      share.x.push_back(run.ranks);
      share.y.push_back(series.runs.front().seconds / run.seconds / run.ranks);
    }
    const ScalingModel model = fit_model(series.cells, series.runs);
    Curve expected{.name = "model, extrapolated: " + series.name};
    for (int ranks = 1; ranks <= 8192; ranks *= 2) {
      try {
        const Real seconds = model.seconds(ranks);
        expected.x.push_back(ranks);
        expected.y.push_back(seconds);
      } catch (const InputError&) {
        break;
      }
    }
    times.push_back(measured);
    times.push_back(expected);
    efficiency.push_back(share);
  }
  const auto save = [&](const std::string& file, const std::vector<Curve>& curves,
                        const report::ChartStyle& style) {
    report::write_picture(output + "/" + file, report::draw_chart(curves, style),
                          io::make_provenance(1, 0), style.title);
  };
  save("scale.png", times,
       {.title = "Time against processes",
        .x_name = "processes",
        .y_name = "wall time",
        .y_unit = "s",
        .logarithmic = true});
  save(
      "efficiency.png", efficiency,
      {.title = "Parallel efficiency", .x_name = "processes", .y_name = "speed-up over processes"});
}

void say(const Series& series, int cores) {
  const ScalingModel model = fit_model(series.cells, series.runs);
  fmt::print("\n{} ({} x {} x {} cells)\n", series.name, series.cells[0], series.cells[1],
             series.cells[2]);
  fmt::print("ranks   seconds  speed-up  efficiency  compute     halo  reductions  waiting\n");
  for (const Measured& run : series.runs) {
    const Real speed_up = series.runs.front().seconds / run.seconds;
    fmt::print("{:>5} {:>9.2f} {:>9.2f} {:>10.0f}% {:>8.2f} {:>8.3f} {:>11.3f} {:>8.3f}{}\n",
               run.ranks, run.seconds, speed_up, 100 * speed_up / run.ranks, run.compute(),
               run.halo, run.reductions, run.waiting,
               run.ranks > cores ? "  more ranks than physical cores" : "");
  }
  fmt::print("take       {} {}\n", recommend(series.runs, cores),
             recommend(series.runs, cores) == 1 ? "process" : "processes");
  std::string text;
  for (const int ranks : possible(model)) {
    text += fmt::format("{}{}: {:.3g} s", text.empty() ? "" : ", ", ranks, model.seconds(ranks));
  }
  fmt::print("model      {} (extrapolated from {} runs on one machine, not measured)\n",
             text.empty() ? "the grid is too small for 64 ranks" : text, series.runs.size());
}

}  // namespace

void write_scaling(const std::string& output, const std::vector<Series>& strong,
                   const std::vector<Measured>& weak, int physical_cores) {
  write_file(output + "/scale.csv", table(strong, weak));
  Json json;
  json.set("physical_cores", physical_cores);
  for (const Series& series : strong) {
    add_json(json, series.name, series, physical_cores);
    say(series, physical_cores);
  }
  for (const Measured& run : weak) {
    json.set(fmt::format("weak_seconds_{}", run.ranks), run.seconds);
    fmt::print("weak       {} ranks, {} times the sample: {:.2f} s, efficiency {:.0f} %\n",
               run.ranks, run.ranks, run.seconds, 100 * weak.front().seconds / run.seconds);
  }
  for (const auto& [name, value] : io::entries(io::make_provenance(1, 0))) {
    json.set(name, value);
  }
  write_file(output + "/scale.json", json.text());
  draw(output, strong);
}

}  // namespace porefines::scale
