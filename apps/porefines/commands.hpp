// SPDX-License-Identifier: MPL-2.0
#pragma once

namespace CLI {
class App;
}

namespace porefines {

// One sub-command per file cmd_<name>.cpp. Each adds its options to the program, and a callback that
// runs it and sets exit_code; errors leave the callback as InputError or RunError.
void add_run(CLI::App& app, int& exit_code);
void add_inspect(CLI::App& app, int& exit_code);
void add_generate(CLI::App& app, int& exit_code);
void add_reference(CLI::App& app, int& exit_code);
void add_track(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_synthesize(CLI::App& app, int& exit_code);

/// Every sub-command, in the order of the help text. A new one is a file and a line here.
inline constexpr void (*commands[])(CLI::App&, int&) = {
    add_run, add_inspect, add_generate, add_reference, add_track, add_compare, add_synthesize};

}  // namespace porefines
