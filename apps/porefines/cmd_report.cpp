// SPDX-License-Identifier: MPL-2.0
#include <iostream>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <mpi.h>

#include "commands.hpp"
#include "core/error.hpp"
#include "page/write_report.hpp"

namespace porefines {

void add_report(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("report", "One page of a run: plots, player, clogging log");
  command->footer(
      "Example:\n"
      "  porefines report out/fines      writes out/fines/report.html, which opens offline");
  auto folder = std::make_shared<std::string>();
  command->add_option("DIR", *folder, "output folder of a run")->required();
  command->callback([folder, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      const std::string path = page::write_report(*folder);
      std::cout << "report     " << path << '\n';
    }
    exit_code = exit_code::done;
  });
}

}  // namespace porefines
