// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <exception>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <mpi.h>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/suggest.hpp"
#include "par/mpi_defaults.hpp"
#include "ranks.hpp"

namespace porefines {
namespace {

struct Outcome {
  int exit_code = exit_code::done;
  std::string error;
};

/// Help and version go to stdout; wrong options are wrong input.
Outcome report_parse(const CLI::App& app, const CLI::ParseError& error, bool speaks) {
  std::ostringstream out;
  std::ostringstream complaint;
  const bool asked = app.exit(error, out, complaint) == 0;
  if (!asked) {
    return {exit_code::wrong_input, std::string(error.what()) +
                                        "\nporefines --help, or porefines run --help, shows what "
                                        "there is"};
  }
  if (speaks) {
    std::cout << out.str();
  }
  return {};
}

/// CLI11 would only say that a sub-command is required.
std::string unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> known;
  for (const CLI::App* command : app.get_subcommands({})) {
    known.push_back(command->get_name());
  }
  if (word.empty() || word.front() == '-' ||
      std::find(known.begin(), known.end(), word) != known.end()) {
    return {};
  }
  const std::string guess = closest(word, known);
  return "unknown command " + word + (guess.empty() ? "" : "; did you mean " + guess + "?") +
         "\nporefines --help shows what there is";
}

Outcome run_command(int argc, char** argv, bool speaks) {
  CLI::App app("porefines: fines migration at the pore scale, from an image to clogging",
               "porefines");
  app.footer(
      "Examples:\n"
      "  porefines inspect rock.tif --pixel-size \"2 um\"   what is in an image\n"
      "  porefines run case.toml                          simulate a case\n"
      "  mpirun -n 4 porefines run case.toml              in parallel\n"
      "porefines COMMAND --help explains a command.\n"
      "Exit codes: 0 done, 2 wrong input, 3 the simulation stopped itself, 128+n signal n.");
  app.set_version_flag("--version", std::string("porefines ") + PF_VERSION);
  app.require_subcommand(1);
  Outcome outcome;
  for (const auto add : commands) {
    add(app, outcome.exit_code);
  }
  const std::string problem = argc > 1 ? unknown_command(app, argv[1]) : "";
  if (!problem.empty()) {
    return {exit_code::wrong_input, problem};
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_parse(app, error, speaks);
  } catch (const InputError& error) {
    return {exit_code::wrong_input, error.what()};
  } catch (const std::exception& error) {
    return {exit_code::stopped_itself, error.what()};
  }
  return outcome;
}

}  // namespace
}  // namespace porefines

// What is left to escape is a lack of memory while an error is put into words.
// NOLINTNEXTLINE(bugprone-exception-escape)
int main(int argc, char** argv) {
#ifndef PF_VISION
  if (const char* problem = porefines::go_elsewhere(argc, argv)) {
    std::cerr << "porefines: " << problem << '\n';
    return porefines::exit_code::stopped_itself;
  }
#endif
  porefines::par::set_mpi_defaults();
  MPI_Init(&argc, &argv);
  MPI_Comm ending = MPI_COMM_NULL;
  MPI_Comm_dup(MPI_COMM_WORLD, &ending);
  int rank = 0;
  MPI_Comm_rank(ending, &rank);
  const porefines::Outcome outcome = porefines::run_command(argc, argv, rank == 0);
  const int code = porefines::end_together(ending, outcome.exit_code, outcome.error);
  MPI_Comm_free(&ending);
  MPI_Finalize();
  return code;
}
