// SPDX-License-Identifier: MPL-2.0
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "commands.hpp"
#include "core/error.hpp"
#include "ranks.hpp"
#include "validate/measure.hpp"
#include "validate/validate.hpp"

namespace porefines {

void add_validate(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("validate", "Compare with exact and published numbers");
  command->footer(
      "Examples:\n"
      "  porefines validate --quick               every comparison that takes under a minute a "
      "run\n"
      "  porefines validate --only cylinder chip  these alone\n"
      "Started again, it keeps what the same commit has done. Exit code 3: something is red.");
  auto options = std::make_shared<validate::ValidateOptions>();
  command->add_flag("--quick", options->quick, "leave out what takes longer, on coarser grids");
  command->add_option("--only", options->only, "names of comparisons");
  command->add_option("--data", options->data,
                      "folder with videos/bulk_water and videos/image_sequence: tracked as well");
  command->add_option("-o,--output", options->output_dir, "output folder (validate)");
  command->add_option("-j,--jobs", options->at_once, "runs side by side; default: physical cores");
  auto asked = std::make_shared<validate::Measurement>();  // a job of its own, for itself alone
  command->add_option("--measure", asked->what)->group("");
  command->add_option("--size", asked->size)->group("");
  command->add_option("--at", asked->at)->group("");
  command->add_option("--exact", asked->exact)->group("");
  command->callback([options, asked, &exit_code] {
    require_one_rank("validate", "-j N is how many runs go side by side");
    if (!asked->what.empty()) {
      validate::measure(*asked, options->output_dir);
      return;
    }
    exit_code = validate::run_validation(*options);
  });
}

}  // namespace porefines
