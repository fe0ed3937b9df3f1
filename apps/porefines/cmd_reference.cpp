// SPDX-License-Identifier: MPL-2.0
#include <iostream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <mpi.h>

#include "commands.hpp"
#include "config/writer.hpp"

namespace porefines {

void add_reference(CLI::App& app, int&) {
  auto* command = app.add_subcommand("reference", "Print the page of every key of the case file");
  command->group("");  // for the maintainers: not in the help text
  command->callback([] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      std::cout << config::reference_page();
    }
  });
}

}  // namespace porefines
