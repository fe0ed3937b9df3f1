// SPDX-License-Identifier: MPL-2.0
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

#include "commands.hpp"
#include "config/reader.hpp"
#include "core/error.hpp"
#include "interop/export_case.hpp"
#include "ranks.hpp"

namespace porefines {

void add_export(CLI::App& app, int& /*exit_code*/) {
  auto* command = app.add_subcommand("export", "A case for OpenFOAM or LIGGGHTS, to cross-check");
  command->footer(
      "Examples:\n"
      "  porefines export case.toml --to openfoam foam && foam/Allrun\n"
      "  porefines export case.toml --to liggghts dem && cd dem && liggghts "
      "-in in.porefines\n"
      "docs/study.md says what is carried over.");
  struct Arguments {
    std::string case_file;
    std::string to;
    std::string folder;
    std::vector<std::string> overrides;
  };
  auto a = std::make_shared<Arguments>();
  command->add_option("CASE.toml", a->case_file, "the case file")->required();
  command->add_option("DIR", a->folder, "the folder to write")->required();
  command->add_option("key.path=value", a->overrides, "values that replace those of the file");
  command->add_option("--to", a->to, "openfoam or liggghts")
      ->required()
      ->check(CLI::IsMember({"openfoam", "liggghts"}));
  command->callback([a] {
    require_one_rank("export", "it takes seconds");
    const config::Case the_case = config::load_case(a->case_file, a->overrides);
    if (a->to == "openfoam") {
      interop::export_openfoam(the_case, a->folder);
      std::cout << "written: " << a->folder << "; Allrun there meshes, solves and prints k\n";
    } else {
      interop::export_liggghts(the_case, a->folder);
      std::cout << "written: " << a->folder << "; liggghts -in in.porefines runs there\n";
    }
  });
}

}  // namespace porefines
