// SPDX-License-Identifier: MPL-2.0
#include "page/island.hpp"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "config/reader.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/read_text.hpp"
#include "io/provenance.hpp"
#include "page/geometry.hpp"
#include "page/maps.hpp"
#include "page/pack.hpp"
#include "page/pictures.hpp"
#include "page/table.hpp"
#include "page/tracks.hpp"
#include "page/walls.hpp"
#include "sim/domain.hpp"

namespace porefines::page {
namespace {

constexpr std::size_t series_rows = 2000;
constexpr std::size_t log_bytes = 20'000;
constexpr int picture_pixels = 1000;

std::string kind_of(const config::Case& the_case) {
  return config::is_dry(the_case)        ? "dry"
         : config::is_inertial(the_case) ? "inertial"
         : config::is_coupled(the_case)  ? "coupled"
                                         : "flow";
}

std::string warnings_in(const std::string& log) {
  std::vector<std::string> found;
  std::istringstream lines(log);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("warning: ", 0) == 0) {
      found.push_back(line.substr(9));
    }
  }
  return json_strings(found);
}

std::string columns_or_null(const std::string& path, std::size_t most) {
  const io::TextTable table = io::read_table(path);
  return table.rows.empty() ? "null" : columns_json(table, most);
}

/// The last profile of retention.csv.
std::string last_profile(const std::string& path) {
  io::TextTable table = io::read_table(path);
  table.keep_last("time_s");
  return table.rows.empty() ? "null" : columns_json(table, table.rows.size());
}

/// Rows of clogging.csv as they are: numbers as numbers, words as text.
std::string events(const std::string& path) {
  const io::TextTable table = io::read_table(path);
  if (table.names.empty()) {
    return "null";
  }
  std::vector<std::string> rows;
  for (const auto& row : table.rows) {
    Json json;
    for (std::size_t c = 0; c < row.size(); ++c) {
      const Real value = io::number_of(row[c]);
      if (std::isnan(value) || table.names[c] == "ids") {
        json.set(table.names[c], row[c]);
      } else {
        json.set(table.names[c], value);
      }
    }
    rows.push_back(json.text());
  }
  return json_list(rows);
}

std::string pictures(const std::string& folder) {
  std::vector<std::string> found;
  for (const std::string name : {"speed", "pressure", "particles"}) {
    const std::string address = picture_address(folder + "/" + name + ".png", picture_pixels);
    if (!address.empty()) {
      Json json;
      json.set("name", name);
      json.set("address", address);
      found.push_back(json.text());
    }
  }
  return json_list(found);
}

/// agreement.json beside the run, or in a folder of porefines compare below it.
std::string agreement(const std::string& folder) {
  for (const std::string place : {"", "/compare", "/compared"}) {
    std::string text = read_text(folder + place + "/agreement.json");
    if (!text.empty()) {
      return text;
    }
  }
  return "null";
}

void add_geometry(Json& json, const config::Case& the_case) {
  const GeometryData geometry = describe_geometry(the_case);
  const auto or_null = [](const std::string& text) { return text.empty() ? "null" : text; };
  json.set_json("geometry", or_null(geometry.metrics));
  json.set_json("histograms", or_null(geometry.histograms));
  json.set_json("scene", or_null(geometry.scene));
  json.set_json("walls", or_null(walls_json(the_case)));
  json.set("geometry_missing", geometry.missing);
}

config::Case case_of(const std::string& folder) {
  const std::string path = folder + "/case.toml";
  for (const std::string& needed : {path, folder + "/summary.json"}) {
    if (!std::filesystem::exists(needed)) {
      throw InputError(
          folder + ": is no folder of a finished run: " + needed +
          " is missing\ngive the folder that `porefines run CASE.toml -o FOLDER` wrote");
    }
  }
  return config::parse_case(read_text(path), path);
}

}  // namespace

std::string run_island(const std::string& folder) {
  const config::Case the_case = case_of(folder);
  const std::string log = read_text(folder + "/log.txt");
  const std::string maps = maps_json(folder);
  const io::Provenance made = io::make_provenance(1, 0);
  Json json;
  json.set("kind", kind_of(the_case));
  json.set("folder", std::filesystem::absolute(folder).lexically_normal().filename().string());
  json.set("version", made.version);
  json.set("made", made.date);
  json.set("flow_axis", sim::flow_axis(the_case.flow));
  json.set("reference", the_case.run.reference);
  json.set("source", std::filesystem::path(the_case.geometry.source).filename().string());
  json.set_json("summary", read_text(folder + "/summary.json"));
  json.set("case", read_text(folder + "/case.toml"));
  json.set("log", log.substr(0, log_bytes));
  json.set_json("warnings", warnings_in(log));
  add_geometry(json, the_case);
  json.set_json("maps", maps);
  json.set_json("pictures", maps == "[]" ? pictures(folder) : "[]");
  json.set_json("series", columns_or_null(folder + "/series.csv", series_rows));
  json.set_json("retention", last_profile(folder + "/retention.csv"));
  json.set_json("clogging", events(folder + "/clogging.csv"));
  json.set_json("throats", columns_or_null(folder + "/throats.csv", 20'000));
  json.set_json("tracks", tracks_json(folder));
  json.set_json("agreement", agreement(folder));
  return json.text();
}

}  // namespace porefines::page
