// SPDX-License-Identifier: MPL-2.0
#include "study/collect.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

#include "core/json_read.hpp"
#include "io/read_table.hpp"

namespace porefines::study {
namespace {

const std::vector<std::string> reductions{"last", "first", "min", "max", "mean"};

/// "series", "permeability_ratio", "last"; a key of summary.json stands alone.
std::vector<std::string> parts_of(const std::string& reading) {
  std::vector<std::string> parts;
  for (std::size_t start = 0; start <= reading.size();) {
    const std::size_t dot = std::min(reading.find('.', start), reading.size());
    parts.push_back(reading.substr(start, dot - start));
    start = dot + 1;
  }
  return parts;
}

Real reduce(std::vector<Real> values, const std::string& how) {
  std::erase_if(values, [](Real value) { return !std::isfinite(value); });
  if (values.empty()) {
    return std::nan("");
  }
  if (how == "first" || how == "last") {
    return how == "first" ? values.front() : values.back();
  }
  if (how == "mean") {
    return std::accumulate(values.begin(), values.end(), Real{0}) /
           static_cast<Real>(values.size());
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return how == "min" ? *low : *high;
}

/// Row of the first clog; the number of rows when there is none.
std::size_t first_clog(const io::TextTable& clogging) {
  const std::vector<std::string> events = clogging.texts("event");
  return static_cast<std::size_t>(std::find(events.begin(), events.end(), "clogged") -
                                  events.begin());
}

struct Tables {
  FlatJson summary;
  io::TextTable series;
  io::TextTable clogging;
  io::TextTable retention;
};

Real read_one(const Tables& tables, const std::string& reading) {
  const std::vector<std::string> parts = parts_of(reading);
  if (parts.size() == 1) {
    return tables.summary.number(reading);
  }
  if (parts[0] == "clogging") {
    const std::size_t row = first_clog(tables.clogging);
    const std::vector<Real> column = tables.clogging.numbers(parts[1]);
    return row < column.size() ? column[row] : std::nan("");
  }
  return reduce(tables.series.numbers(parts[1]), parts[2]);
}

analysis::Sampled curve_of(const io::TextTable& table, const CurveKind& kind, bool holds) {
  analysis::Sampled curve{{}, {}, holds};
  const std::vector<Real> at = table.numbers(kind.x);
  const std::vector<Real> value = table.numbers(kind.y);
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (std::isfinite(at[i]) && std::isfinite(value[i]) &&
        (curve.x.empty() || at[i] > curve.x.back())) {
      curve.x.push_back(at[i]);
      curve.y.push_back(value[i]);
    }
  }
  return curve;
}

/// The first clog, or how long there was none.
void take_lifetimes(Result& result, const Tables& tables) {
  const std::size_t row = first_clog(tables.clogging);
  const bool clogged = row < tables.clogging.rows.size();
  const auto life = [&](const std::string& column, const std::string& end) {
    return analysis::Lifetime{
        clogged ? tables.clogging.numbers(column)[row] : tables.summary.number(end), clogged};
  };
  result.time = life("time_s", "time_s");
  result.volumes = life("pore_volumes", "pore_volumes_injected");
  result.escapees = life("out", "particles_out");
}

}  // namespace

std::string reading_problem(const std::string& reading) {
  const std::vector<std::string> parts = parts_of(reading);
  const bool reduced = parts.size() == 3 && std::find(reductions.begin(), reductions.end(),
                                                      parts[2]) != reductions.end();
  const bool fits = parts.size() == 1 || (parts.size() == 2 && parts[0] == "clogging") ||
                    (parts[0] == "series" && reduced);
  return fits && !reading.empty() ? "" : fmt::format("\"{}\" is no reading", reading);
}

std::vector<std::string> default_readings() {
  return {"permeability_darcy", "permeability_ratio", "pore_volumes_injected", "particles_injected",
          "particles_out",      "clogged_throats",    "clogging.time_s",       "clogging.out"};
}

bool is_done(const std::string& folder) {
  const auto summary = read_flat_json(folder + "/summary.json");
  const std::string* status = summary ? summary->find("status") : nullptr;
  return status != nullptr && *status == "done";
}

std::optional<Result> collect(const std::string& folder, const std::vector<std::string>& readings) {
  if (!is_done(folder)) {
    return {};
  }
  Tables tables{*read_flat_json(folder + "/summary.json"), io::read_table(folder + "/series.csv"),
                io::read_table(folder + "/clogging.csv"),
                io::read_table(folder + "/retention.csv")};
  tables.retention.keep_last("time_s");
  Result result;
  for (const std::string& reading : readings) {
    result.readings.push_back(read_one(tables, reading));
  }
  result.wall_time = tables.summary.number("wall_time_s");
  result.clogs = !tables.clogging.names.empty();
  const bool limited = tables.summary.find("reason") != nullptr;
  if (result.clogs) {
    take_lifetimes(result, tables);
  }
  for (std::size_t k = 0; k < curve_kinds.size(); ++k) {
    const bool series = std::string_view(curve_kinds[k].table) == "series.csv";
    result.curves[k] = curve_of(series ? tables.series : tables.retention, curve_kinds[k], limited);
  }
  return result;
}

Real progress_of(const std::string& folder, Real end_time) {
  const std::vector<Real> times = io::read_table(folder + "/series.csv").numbers("time_s");
  return times.empty() || !(end_time > 0) ? 0 : std::clamp(times.back() / end_time, 0.0, 1.0);
}

}  // namespace porefines::study
