// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <array>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <unistd.h>

#include "commands.hpp"

namespace porefines {

void add_track(CLI::App& app, int&) {
  app.add_subcommand("track", about_track);
}
void add_compare(CLI::App& app, int&) {
  app.add_subcommand("compare", about_compare);
}
void add_synthesize(CLI::App& app, int&) {
  app.add_subcommand("synthesize", about_synthesize);
}

const char* go_elsewhere(int argc, char** argv) {
  constexpr std::array<std::string_view, 3> there{"track", "compare", "synthesize"};
  const std::string_view command = argc > 1 ? argv[1] : "";
  if (std::find(there.begin(), there.end(), command) == there.end()) {
    return nullptr;
  }
  std::error_code error;
  const auto here = std::filesystem::read_symlink("/proc/self/exe", error);
  ::execv((here.parent_path() / "porefines-vision").c_str(), argv);
  return "cannot start porefines-vision, which belongs beside porefines; install it again";
}

}  // namespace porefines
