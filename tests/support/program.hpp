// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

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

/// The environment is a fresh one: the test program has started MPI, and its children must not
/// believe that they belong to the same job.
inline std::string shell_command(const std::string& folder, const std::vector<std::string>& words) {
  std::string command = "cd " + quoted(folder) +
                        " && exec env -i HOME=\"$HOME\" PATH=\"$PATH\" OMPI_ALLOW_RUN_AS_ROOT=1"
                        " OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1";
  for (const std::string& word : words) {
    command += " " + quoted(word);
  }
  return command;
}

inline int exit_code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

/// Runs a program to its end in a folder.
inline ProgramResult run_in(const std::string& folder, const std::vector<std::string>& words) {
  const std::string command = shell_command(folder, words);
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) {
    throw std::runtime_error("cannot run " + command);
  }
  ProgramResult result;
  char buffer[4096];
  while (const std::size_t count = fread(buffer, 1, sizeof buffer, pipe)) {
    result.output.append(buffer, count);
  }
  result.exit_code = exit_code_of(pclose(pipe));
  return result;
}

/// A program in the background, for tests that interfere with it. They wait for what it prints,
/// never for a time, so that they mean the same on a machine ten times slower or faster.
class Background {
 public:
  Background(const std::string& folder, const std::vector<std::string>& words) {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) {
      throw std::runtime_error("no pipe");
    }
    process_ = fork();
    if (process_ == 0) {
      dup2(ends[1], STDOUT_FILENO);
      dup2(ends[1], STDERR_FILENO);
      close(ends[0]);
      close(ends[1]);
      const std::string command = shell_command(folder, words);
      execl("/bin/sh", "sh", "-c", command.c_str(), nullptr);
      _exit(127);
    }
    close(ends[1]);
    output_ = fdopen(ends[0], "r");
  }
  ~Background() { (void)end(); }
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Reads until a line holds this text; false when the program ends without it.
  bool wait_for(const std::string& text) {
    while (read_line()) {
      if (result_.output.find(text) != std::string::npos) {
        return true;
      }
    }
    return false;
  }

  void send(int signal) const { kill(process_, signal); }

  /// Processes that it has started, such as the ranks of mpirun.
  [[nodiscard]] std::vector<pid_t> children() const {
    std::vector<pid_t> found;
    const std::string tasks = "/proc/" + std::to_string(process_) + "/task";
    for (const auto& task : std::filesystem::directory_iterator(tasks)) {
      std::ifstream list(task.path() / "children");
      for (pid_t child = 0; list >> child;) {
        found.push_back(child);
      }
    }
    return found;
  }

  /// From now on it can write no file beyond so many bytes.
  void limit_files(rlim_t bytes) const {
    const rlimit limit{bytes, RLIM_INFINITY};
    prlimit(process_, RLIMIT_FSIZE, &limit, nullptr);
  }

  /// Waits for its end.
  ProgramResult end() {
    if (output_ != nullptr) {
      while (read_line()) {
      }
      fclose(output_);
      output_ = nullptr;
      int status = 0;
      waitpid(process_, &status, 0);
      result_.exit_code = exit_code_of(status);
    }
    return result_;
  }

 private:
  bool read_line() {
    char line[4096];
    if (fgets(line, sizeof line, output_) == nullptr) {
      return false;
    }
    result_.output += line;
    return true;
  }

  pid_t process_ = 0;
  FILE* output_ = nullptr;
  ProgramResult result_;
};

/// Runs porefines with these arguments.
inline ProgramResult porefines_in(const std::string& folder, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), PF_BINARY);
  return run_in(folder, arguments);
}

}  // namespace porefines::test
