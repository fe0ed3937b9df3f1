// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/wait.h>

namespace porefines::test {

struct ProgramResult {
  int exit_code = 0;
  std::string output;  ///< stdout and stderr as they came
};

/// A word that the shell passes on unchanged.
inline std::string quoted(const std::string& word) {
  std::string out = "'";
  for (const char c : word) {
    out += c == '\'' ? "'\\''" : std::string(1, c);
  }
  return out + "'";
}

/// Runs a program to its end in a folder. The environment is a fresh one: the test program has
/// started MPI, and its children must not believe that they belong to the same job.
inline ProgramResult run_in(const std::string& folder, const std::vector<std::string>& words) {
  std::string command = "cd " + quoted(folder) +
                        " && exec env -i HOME=\"$HOME\" PATH=\"$PATH\" OMPI_ALLOW_RUN_AS_ROOT=1"
                        " OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1";
  for (const std::string& word : words) {
    command += " " + quoted(word);
  }
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error("cannot run " + command);
  }
  ProgramResult result;
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) {
    result.output.append(buffer, count);
  }
  const int status = pclose(pipe);
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

/// Runs porefines with these arguments.
inline ProgramResult porefines_in(const std::string& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), PF_BINARY);
  return run_in(folder, arguments);
}

}  // namespace porefines::test
