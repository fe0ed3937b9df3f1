// SPDX-License-Identifier: MPL-2.0
// Programs that porefines starts: members of a study, ranks of a scaling test.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace porefines {

/// Starts a program in a process group of its own; its output is appended to the file `console`.
///
/// Its environment is ours without what mpirun or MPI_Init put there, so that it may start MPI itself.
/// Should we die, even by SIGKILL, it is sent SIGTERM: porefines then saves a checkpoint and ends.
/// Descriptors without O_CLOEXEC stay open in it. It works in `folder`; empty: in ours.
/// @throws RunError  no process can be made. A program that cannot be started ends with code 127.
[[nodiscard]] pid_t start_process(const std::vector<std::string>& words, const std::string& console,
                                  const std::string& folder = "");

/// Its exit code (128 + n after signal n), or nothing as long as it runs.
[[nodiscard]] std::optional<int> exit_of(pid_t process);
/// The same, waiting for it.
[[nodiscard]] int wait_for(pid_t process);

/// This program: /proc/self/exe.
[[nodiscard]] std::string own_path();

/// porefines with these arguments on so many ranks; through mpirun when more than one. Ranks are not bound
/// to cores, since several such programs may share the machine.
[[nodiscard]] std::vector<std::string> on_ranks(int ranks, std::vector<std::string> arguments);

/// The last lines of a console file, for messages.
[[nodiscard]] std::string last_lines(const std::string& path, std::size_t count);

}  // namespace porefines
