// SPDX-License-Identifier: MPL-2.0
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "commands.hpp"
#include "ranks.hpp"
#include "study/fit_run.hpp"
#include "study/forchheimer_study.hpp"

namespace porefines {

void add_fit(CLI::App& app, int& /*exit_code*/) {
  auto* command =
      app.add_subcommand("fit", "Filtration and formation damage of a run; k and beta of a sweep");
  command->footer(
      "Examples:\n"
      "  porefines fit out/fines                  the classical deep-bed model of a run\n"
      "  porefines fit out/studies/forchheimer    Darcy and Forchheimer, of a study of flows with "
      "inertia\n"
      "Both: docs/study.md.");
  struct Arguments {
    std::string folder;
    std::string output;
    double confidence = 0.95;
    int resamples = 400;
  };
  auto a = std::make_shared<Arguments>();
  command->add_option("DIR", a->folder, "output folder of porefines run or porefines study")
      ->required();
  command->add_option("-o,--output", a->output, "where the results go; the default is DIR");
  command->add_option("--confidence", a->confidence, "of the intervals (0.95)")
      ->check(CLI::Range(0.5, 0.999));
  command->add_option("--resamples", a->resamples, "of the bootstrap (400)")
      ->check(CLI::Range(50, 100000));
  command->callback([a] {
    require_one_rank("fit", "it takes a second");
    if (study::is_study(a->folder)) {
      study::fit_sweep(a->folder, a->output.empty() ? a->folder : a->output);
      return;
    }
    study::fit_run(a->folder, a->output.empty() ? a->folder : a->output, a->confidence,
                   a->resamples);
  });
}

}  // namespace porefines
