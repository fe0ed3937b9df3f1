// SPDX-License-Identifier: MPL-2.0
#include "validate/validate.hpp"

#include <algorithm>
#include <iostream>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/cores.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/suggest.hpp"
#include "io/provenance.hpp"
#include "page/pack.hpp"
#include "page/pictures.hpp"
#include "page/write_report.hpp"
#include "validate/launch.hpp"
#include "validate/read_result.hpp"

namespace porefines::validate {
namespace {

std::vector<Comparison> chosen(const ValidateOptions& options) {
  std::vector<Comparison> all = all_comparisons(options.quick, options.data);
  std::vector<std::string> names;
  for (const Comparison& comparison : all) {
    names.push_back(comparison.name);
  }
  for (const std::string& wanted : options.only) {
    if (std::find(names.begin(), names.end(), wanted) == names.end()) {
      const std::string guess = closest(wanted, names);
      throw InputError(
          fmt::format("--only {}: there is no such comparison{}\nthere are {}{}{}", wanted,
                      guess.empty() ? "" : "; did you mean " + guess + "?", fmt::join(names, ", "),
                      options.quick ? "; more without --quick" : "",
                      options.data.empty() ? "; with --data also centres, bulk_water" : ""));
    }
  }
  std::erase_if(all, [&](const Comparison& comparison) {
    return !options.only.empty() && std::find(options.only.begin(), options.only.end(),
                                              comparison.name) == options.only.end();
  });
  return all;
}

std::string folder_of(const ValidateOptions& options, const Comparison& comparison,
                      const Job& job) {
  const std::string& of = comparison.folder.empty() ? comparison.name : comparison.folder;
  return options.output_dir + "/" + of + "/" + job.name;
}

void tell(const Launch& launch) {
  std::cout << fmt::format("{}  {}{}\n", launch.kept ? "kept" : "done", launch.folder,
                           launch.exit_code == 0
                               ? ""
                               : fmt::format(": exit code {}, see said.txt", launch.exit_code))
            << std::flush;
}

std::string row_json(const Row& row, const Reading& reading) {
  Json json;
  json.set("label", row.label);
  json.set("x", row.x);
  json.set("value", reading.value);
  json.set("error", reading.error);
  json.set("reference", row.reference);
  json.set("tolerance", row.tolerance);
  json.set("agrees", agrees(row, reading));
  json.set_json("literature", page::json_numbers(row.literature));
  return json.text();
}

/// A comparison with what the runs gave; adds to the count of red rows.
std::string comparison_json(const ValidateOptions& options, const Comparison& comparison,
                            std::size_t& red) {
  std::vector<std::string> folders;
  Real seconds = 0;
  for (const Job& job : comparison.jobs) {
    folders.push_back(folder_of(options, comparison, job));
    const Real took = number_in(folders.back() + "/out/summary.json", "wall_time_s");
    seconds += took > 0 ? took : 0;
  }
  std::vector<std::string> rows;
  for (const Row& row : comparison.rows) {
    const Reading reading = read_row(row, folders);
    red += agrees(row, reading) ? 0 : 1;
    rows.push_back(row_json(row, reading));
    std::cout << fmt::format(
        "{:5}  {}, {}: {:.6g}, reference {:.6g}{}\n", agrees(row, reading) ? "green" : "RED",
        comparison.name, row.label, reading.value, row.reference,
        row.reference == 0
            ? ""
            : fmt::format(", off by {:.2g} %", 100 * (reading.value / row.reference - 1)));
  }
  std::vector<std::string> pictures;
  for (const auto& [file, caption] : comparison.pictures) {
    Json picture;
    picture.set("address", page::picture_address(folders.front() + "/" + file, 1000));
    picture.set("caption", caption);
    pictures.push_back(picture.text());
  }
  Json json;
  json.set("name", comparison.name);
  json.set_json("pictures", page::json_list(pictures));
  json.set("title", comparison.title);
  json.set("quantity", comparison.quantity);
  json.set("along", comparison.along);
  json.set("reference", comparison.reference);
  json.set("logarithmic", comparison.logarithmic);
  json.set("seconds", seconds);
  json.set("runs", comparison.jobs.size());
  json.set_json("literature", page::json_strings(comparison.literature));
  json.set_json("rows", page::json_list(rows));
  return json.text();
}

}  // namespace

int run_validation(const ValidateOptions& options) {
  const std::vector<Comparison> list = chosen(options);
  const io::Provenance made = io::make_provenance(1, 0);
  std::vector<Launch> launches;
  for (const Comparison& comparison : list) {
    for (const Job& job : comparison.jobs) {
      const std::string folder = folder_of(options, comparison, job);
      if (std::none_of(launches.begin(), launches.end(),
                       [&](const Launch& one) { return one.folder == folder; })) {
        launches.push_back({&job, folder});
      }
    }
  }
  const auto cores = static_cast<unsigned>(find_cores().physical);
  run_jobs(launches, options.at_once > 0 ? options.at_once : cores, made.commit, tell);

  make_folder(options.output_dir);
  std::size_t red = 0;
  std::vector<std::string> comparisons;
  for (const Comparison& comparison : list) {
    comparisons.push_back(comparison_json(options, comparison, red));
  }
  Json json;
  json.set("kind", "validation");
  json.set("version", made.version);
  json.set("commit", made.commit);
  json.set("made", made.date);
  json.set("quick", options.quick);
  json.set("red", red);
  json.set_json("comparisons", page::json_list(comparisons));
  write_file(options.output_dir + "/validation.json", json.text());
  write_file(options.output_dir + "/validation.html",
             page::whole_page("porefines: validation", json.text()));
  std::cout << fmt::format("{}\npage       {}/validation.html\n",
                           red == 0 ? "all green" : fmt::format("{} red", red), options.output_dir);
  return red == 0 ? exit_code::done : exit_code::stopped_itself;
}

}  // namespace porefines::validate
