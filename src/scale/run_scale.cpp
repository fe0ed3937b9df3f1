// SPDX-License-Identifier: MPL-2.0
#include "scale/run_scale.hpp"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/cores.hpp"
#include "core/error.hpp"
#include "scale/measure.hpp"

namespace porefines::scale {
namespace {

std::string name_of(const std::string& case_file) {
  const std::filesystem::path path(case_file);
  const std::string stem = path.stem().string();
  return stem == "case" ? std::filesystem::absolute(path).parent_path().filename().string() : stem;
}

void say_machine(const Cores& cores, const std::vector<int>& ranks) {
  fmt::print("machine    {} physical cores, {} processors{}\n", cores.physical, cores.logical,
             cores.limited ? " (limited by the container)" : "");
  if (*std::max_element(ranks.begin(), ranks.end()) > cores.physical) {
    fmt::print("warning: more ranks than physical cores share them: expect no gain from that\n");
  }
  std::fflush(stdout);
}

}  // namespace

int run_scale(const ScaleOptions& options) {
  const Cores cores = find_cores();
  const std::vector<int> ranks =
      options.ranks.empty() ? ranks_to_try(cores.physical) : options.ranks;
  say_machine(cores, ranks);
  make_folder(options.output_dir);
  const auto take = [&](const std::string& file, int n, Int3& cells, const std::string& folder) {
    const Measured run = measure(file, options.overrides, n, options.repeats,
                                 options.output_dir + "/" + folder, cells);
    fmt::print("{} on {}: {:.2f} s\n", name_of(file), n, run.seconds);
    std::fflush(stdout);
    return run;
  };
  std::vector<Series> strong;
  for (const std::string& file : options.cases) {
    Series series{.name = name_of(file), .runs = {}};
    for (const int n : ranks) {
      series.runs.push_back(take(file, n, series.cells, fmt::format("{}_{}", series.name, n)));
    }
    strong.push_back(std::move(series));
  }
  std::vector<Measured> weak;
  Int3 ignored{};
  for (std::size_t i = 0; i < options.weak.size(); ++i) {
    const int n = static_cast<int>(i) + 1;
    weak.push_back(take(options.weak[i], n, ignored, fmt::format("weak_{}", n)));
  }
  write_scaling(options.output_dir, strong, weak, cores.physical);
  fmt::print("results    {}/scale.csv, scale.json, scale.png, efficiency.png\n",
             options.output_dir);
  return exit_code::done;
}

}  // namespace porefines::scale
