// SPDX-License-Identifier: MPL-2.0
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/signals.hpp"
#include "ranks.hpp"
#include "study/run_study.hpp"

namespace porefines {

void add_study(CLI::App& app, int& code) {
  auto* command = app.add_subcommand("study", "Sweeps and repeats of a case, with statistics");
  command->footer(
      "Examples:\n"
      "  porefines study studies/clogging/study.toml --dry-run   members, time, memory\n"
      "  porefines study studies/clogging/study.toml -o out/clogging seeds=2\n"
      "Stopped or killed, the same command goes on. docs/study.md explains the file.");
  struct Arguments {
    std::string file;
    study::StudyOptions options;
  };
  auto arguments = std::make_shared<Arguments>();
  command->add_option("STUDY.toml", arguments->file, "the study file")->required();
  command->add_option("key=value", arguments->options.overrides,
                      "values of the study file, e.g. seeds=2");
  command->add_option("-o,--output", arguments->options.output_dir,
                      "output folder; the default is output_dir of the study");
  command->add_flag("--dry-run", arguments->options.dry_run,
                    "list members, time and memory, run nothing");
  command->callback([arguments, &code] {
    require_one_rank("study", "ranks = N in the study file is for each member");
    watch_signals();
    try {
      code = study::run_study(arguments->file, arguments->options);
    } catch (const Interrupted& stop) {
      code = exit_code::signal_base + stop.signal;
    }
  });
}

}  // namespace porefines
