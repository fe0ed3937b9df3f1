// SPDX-License-Identifier: MPL-2.0
#include "core/process.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.hpp"

namespace porefines {
namespace {

/// Whether mpirun or MPI_Init put it there.
bool belongs_to_mpi(std::string_view variable) {
  constexpr std::array<std::string_view, 13> prefixes{
      "OMPI_COMM_",     "OMPI_UNIVERSE", "OMPI_APP",     "OMPI_NUM_APP",  "OMPI_FIRST",
      "OMPI_FILE",      "OMPI_ARGV",     "OMPI_COMMAND", "OMPI_MCA_ess_", "OMPI_MCA_orte_",
      "OMPI_MCA_pmix_", "PMIX_",         "PMI_"};
  return std::any_of(prefixes.begin(), prefixes.end(),
                     [&](std::string_view prefix) { return variable.starts_with(prefix); });
}

/// As it was when this program began: MPI_Init only changes our own copy.
std::vector<std::string> clean_environment() {
  std::ifstream file("/proc/self/environ", std::ios::binary);
  std::vector<std::string> variables;
  for (std::string variable; std::getline(file, variable, '\0');) {
    if (!belongs_to_mpi(variable)) {
      variables.push_back(variable);
    }
  }
  // mpirun would kill ranks one second after SIGTERM, in the middle of a checkpoint
  variables.emplace_back("OMPI_MCA_odls_base_sigkill_timeout=120");
  return variables;
}

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> out;
  std::transform(texts.begin(), texts.end(), std::back_inserter(out),
                 [](std::string& text) { return text.data(); });
  out.push_back(nullptr);
  return out;
}

int code_of(int status) {
  return WIFEXITED(status) ? WEXITSTATUS(status) : exit_code::signal_base + WTERMSIG(status);
}

/// In the child: nothing here may take memory, since other threads of the parent may have held locks.
[[noreturn]] void become(char* const* words, char* const* environment, int console,
                         const char* folder, pid_t parent) {
  constexpr int not_started = 127;
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) {
    _exit(exit_code::signal_base + SIGTERM);
  }
  std::signal(SIGINT, SIG_DFL);
  std::signal(SIGTERM, SIG_DFL);
  const int nothing = open("/dev/null", O_RDONLY);
  dup2(nothing, STDIN_FILENO);
  dup2(console, STDOUT_FILENO);
  dup2(console, STDERR_FILENO);
  if (*folder == '\0' || chdir(folder) == 0) {
    execvpe(words[0], words, environment);
  }
  _exit(not_started);
}

}  // namespace

pid_t start_process(const std::vector<std::string>& words, const std::string& console,
                    const std::string& folder) {
  std::vector<std::string> arguments = words;
  std::vector<std::string> variables = clean_environment();
  const std::vector<char*> argv = pointers(arguments);
  const std::vector<char*> envp = pointers(variables);
  const int out = open(console.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (out < 0) {
    throw RunError(
        fmt::format("cannot write {}: {}", console, std::generic_category().message(errno)));
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    become(argv.data(), envp.data(), out, folder.c_str(), parent);
  }
  const int error = errno;
  close(out);
  if (child < 0) {
    throw RunError(
        fmt::format("cannot start {}: {}", words.front(), std::generic_category().message(error)));
  }
  setpgid(child, child);
  return child;
}

std::optional<int> exit_of(pid_t process) {
  int status = 0;
  return waitpid(process, &status, WNOHANG) == process ? std::optional(code_of(status))
                                                       : std::nullopt;
}

int wait_for(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0 && errno == EINTR) {
  }
  return code_of(status);
}

std::string own_path() {
  std::error_code ignored;
  return std::filesystem::read_symlink("/proc/self/exe", ignored).string();
}

std::vector<std::string> on_ranks(int ranks, std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), own_path());
  if (ranks > 1) {
    arguments.insert(arguments.begin(), {"mpirun", "--oversubscribe", "--bind-to", "none", "-n",
                                         std::to_string(ranks)});
  }
  return arguments;
}

std::string last_lines(const std::string& path, std::size_t count) {
  std::ifstream file(path);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) {
    if (!line.empty()) {
      lines.push_back(line);
    }
  }
  const std::size_t first = lines.size() > count ? lines.size() - count : 0;
  return fmt::format(
      "{}", fmt::join(lines.begin() + static_cast<std::ptrdiff_t>(first), lines.end(), "\n"));
}

}  // namespace porefines
