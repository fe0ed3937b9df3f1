// SPDX-License-Identifier: MPL-2.0
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "commands.hpp"
#include "config/reader.hpp"
#include "core/signals.hpp"
#include "sim/run.hpp"

namespace porefines {
namespace {

struct Arguments {
  std::string case_file;
  std::vector<std::string> overrides;
  sim::RunOptions options;
};

}  // namespace

void add_run(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("run", "Simulate a case");
  command->footer(
      "Examples:\n"
      "  porefines run cases/berea/case.toml\n"
      "  porefines run case.toml \"grid.cell_size=2 um\" flow.inlet.face=y- -o out/fine\n"
      "  porefines run case.toml --dry-run        derived numbers, memory, expected time\n"
      "  mpirun -n 4 porefines run case.toml      in parallel\n"
      "docs/case-reference.md explains every key.");
  auto arguments = std::make_shared<Arguments>();
  command->add_option("CASE.toml", arguments->case_file, "the case file")->required();
  command->add_option("key.path=value", arguments->overrides,
                      "values that replace those of the file; quote them for the shell");
  command->add_option("-o,--output", arguments->options.output_dir,
                      "output folder; the default is run.output_dir of the case");
  command->add_flag("--dry-run", arguments->options.dry_run,
                    "print derived numbers and draw the geometry, solve nothing");
  command->add_flag("--restart", arguments->options.restart,
                    "continue from the checkpoint in the output folder");
  command->callback([arguments, &exit_code] {
    watch_signals();
    const config::Case the_case = config::load_case(arguments->case_file, arguments->overrides);
    if (arguments->options.output_dir.empty()) {
      arguments->options.output_dir = the_case.run.output_dir;
    }
    exit_code = sim::run(the_case, arguments->options);
  });
}

}  // namespace porefines
