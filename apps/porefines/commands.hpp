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
void add_report(CLI::App& app, int& exit_code);
void add_study(CLI::App& app, int& exit_code);
void add_fit(CLI::App& app, int& exit_code);
void add_scale(CLI::App& app, int& exit_code);
void add_validate(CLI::App& app, int& exit_code);
void add_export(CLI::App& app, int& exit_code);
void add_forces(CLI::App& app, int& exit_code);
void add_reference(CLI::App& app, int& exit_code);
void add_track(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_synthesize(CLI::App& app, int& exit_code);

// Those of the program porefines-vision, in a line each.
inline constexpr const char* about_track = "Follow the particles of a microscope video";
inline constexpr const char* about_compare = "A run against the tracks of a video";
inline constexpr const char* about_synthesize =
    "Film tracks, or tracers in a flow, with a synthetic microscope";

/// Every sub-command, in the order of the help text. A new one is a file and a line here.
inline constexpr void (*commands[])(CLI::App&, int&) = {
#ifndef PF_VISION
    add_run,   add_report,   add_inspect,   add_generate, add_study,     add_fit,
    add_scale, add_validate, add_export,    add_forces,   add_reference,
#endif
    add_track, add_compare,  add_synthesize};

/// In porefines: becomes porefines-vision, with the same arguments, when the first one is a command
/// of that program. Returns nullptr otherwise, and a message where porefines-vision is missing.
const char* go_elsewhere(int argc, char** argv);

}  // namespace porefines
