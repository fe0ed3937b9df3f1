// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "commands.hpp"
#include "core/atomic_file.hpp"
#include "core/cores.hpp"
#include "core/error.hpp"
#include "geom/image_write.hpp"
#include "geom/micromodel.hpp"
#include "ranks.hpp"
#include "scale/run_scale.hpp"

namespace porefines {
namespace {

constexpr Real pixel = 5e-6;   // [m]
constexpr int wide = 1340;     // pixels: 6.7 mm
constexpr int high = 1000;     // 5 mm
constexpr int most_weak = 16;  // times the sample of one rank

/// A micromodel and its case; made once.
std::string make_sample(const std::string& folder, const std::string& name, Int3 pixels,
                        Real porosity) {
  std::string file = folder + "/" + name + ".toml";
  if (!std::filesystem::exists(folder + "/" + name + ".png")) {
    geom::MicromodelSpec spec;
    spec.pixels = pixels;
    spec.porosity = porosity;
    spec.grain = 40;
    spec.seed = 2021;
    geom::write_image(folder + "/" + name + ".png", geom::make_micromodel(spec).view());
  }
  write_file(
      file,
      fmt::format("title = \"Micromodel, porosity {}\"\noutput = []\n"
                  "[geometry]\nsource = \"{}.png\"\npixel_size = \"{} um\"\ndepth = \"20 um\"\n"
                  "[grid]\ncell_size = \"{} um\"\n"
                  "[flow]\ninlet = {{ face = \"x-\", pressure = \"12 Pa\" }}\n"
                  "outlet = {{ face = \"x+\", pressure = \"0 Pa\" }}\n"
                  "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n",
                  porosity, name, 1e6 * pixel, 1e6 * pixel));
  return file;
}

/// Thesis fig. 11: 6.7 mm x 5 mm at two porosities; for weak scaling a quarter of the first for every rank.
void make_samples(scale::ScaleOptions& options, bool weak) {
  make_folder(options.output_dir);
  options.cases = {make_sample(options.output_dir, "porosity_0.503", {wide, high, 1}, 0.503),
                   make_sample(options.output_dir, "porosity_0.421", {wide, high, 1}, 0.421)};
  const int most = options.ranks.empty()
                       ? find_cores().physical
                       : *std::max_element(options.ranks.begin(), options.ranks.end());
  for (int n = 1; weak && n <= std::min(most, most_weak); ++n) {
    options.weak.push_back(
        make_sample(options.output_dir, fmt::format("weak_{}", n), {n * wide / 4, high, 1}, 0.503));
  }
}

}  // namespace

void add_scale(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("scale", "Time against processes: how many to take");
  command->footer(
      "Examples:\n"
      "  porefines scale                          two micromodels of 6.7 mm x 5 mm\n"
      "  porefines scale case.toml --ranks 1 2 4\n"
      "docs/study.md explains the table and the model.");
  struct Arguments {
    std::string case_file;
    bool weak = false;
    scale::ScaleOptions options;
  };
  auto a = std::make_shared<Arguments>();
  command->add_option("CASE.toml", a->case_file, "your own case instead of the micromodels");
  command->add_option("key.path=value", a->options.overrides,
                      "values that replace those of the case");
  command
      ->add_option("--ranks", a->options.ranks,
                   "numbers of processes; the default is 1, 2, 4 ... up to the physical cores")
      ->check(CLI::PositiveNumber);
  command->add_option("--repeats", a->options.repeats, "of each, the fastest counts (2)")
      ->check(CLI::PositiveNumber);
  command->add_flag("--weak", a->weak,
                    "with the micromodels: a sample that grows with the ranks too");
  command->add_option("-o,--output", a->options.output_dir, "output folder (out/scale)");
  command->callback([a, &code] {
    require_one_rank("scale", "it starts mpirun itself");
    if (a->case_file.empty()) {
      make_samples(a->options, a->weak);
    } else {
      a->options.cases = {a->case_file};
    }
    code = scale::run_scale(a->options);
  });
}

}  // namespace porefines
