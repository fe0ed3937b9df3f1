// SPDX-License-Identifier: MPL-2.0
#include "validate/launch.hpp"

#include <atomic>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "validate/read_result.hpp"

namespace porefines::validate {
namespace {

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> out;
  for (std::string& word : words) {
    out.push_back(word.data());
  }
  out.push_back(nullptr);
  return out;
}

/// What this program inherited, without what MPI put there.
std::vector<std::string> plain_environment() {
  std::vector<std::string> out;
  for (char** entry = environ; *entry != nullptr; ++entry) {
    if (std::strncmp(*entry, "OMPI_", 5) != 0 && std::strncmp(*entry, "PMIX_", 5) != 0) {
      out.emplace_back(*entry);
    }
  }
  out.emplace_back("OMPI_ALLOW_RUN_AS_ROOT=1");
  out.emplace_back("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1");
  return out;
}

/// "copy" FROM TO, or words for this program.
int do_command(const std::string& folder, const std::vector<std::string>& words) {
  if (words[0] != "copy") {
    return run_self(folder, words);
  }
  std::error_code error;
  std::filesystem::copy_file(folder + "/" + words[1], folder + "/" + words[2],
                             std::filesystem::copy_options::overwrite_existing, error);
  return error ? exit_code::stopped_itself : 0;
}

void run_job(Launch& launch, const std::string& commit) {
  if (is_done(launch.folder, commit)) {
    launch.kept = true;
    return;
  }
  std::filesystem::remove_all(launch.folder);
  make_folder(launch.folder);
  write_file(launch.folder + "/case.toml", launch.job->case_text);
  for (const auto& [name, content] : launch.job->files) {
    write_file(launch.folder + "/" + name, content);
  }
  std::vector<std::vector<std::string>> commands{{"run", "case.toml", "-o", "out"}};
  if (!launch.job->generate.empty()) {
    commands.insert(commands.begin(), launch.job->generate);
  }
  commands.insert(commands.end(), launch.job->after.begin(), launch.job->after.end());
  for (const std::vector<std::string>& words : commands) {
    if (launch.exit_code == 0) {
      launch.exit_code = do_command(launch.folder, words);
    }
  }
  if (launch.exit_code == 0) {
    write_file(launch.folder + "/done.txt", commit);
  }
}

}  // namespace

int run_self(const std::string& folder, const std::vector<std::string>& words) {
  std::vector<std::string> command{std::filesystem::read_symlink("/proc/self/exe").string()};
  command.insert(command.end(), words.begin(), words.end());
  std::vector<std::string> environment = plain_environment();
  posix_spawn_file_actions_t actions{};
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "said.txt",
                                   O_WRONLY | O_CREAT | O_APPEND, 0644);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  pid_t child = 0;
  const int failed = posix_spawn(&child, command[0].c_str(), &actions, nullptr,
                                 pointers(command).data(), pointers(environment).data());
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0) {
    throw RunError("cannot start " + command[0] + " in " + folder + ": " +
                   std::generic_category().message(failed));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

bool is_done(const std::string& folder, const std::string& commit) {
  const bool known = commit.find("dirty") == std::string::npos && commit != "unknown";
  return known && read_whole(folder + "/done.txt") == commit;
}

void run_jobs(std::vector<Launch>& launches, unsigned at_once, const std::string& commit,
              void (*tell)(const Launch&)) {
  std::atomic<std::size_t> next = 0;
  std::mutex telling;
  std::string failure;
  const auto work = [&] {
    for (std::size_t k = next++; k < launches.size(); k = next++) {
      try {
        run_job(launches[k], commit);
      } catch (const std::exception& error) {
        const std::lock_guard lock(telling);
        failure = error.what();
        return;
      }
      const std::lock_guard lock(telling);
      tell(launches[k]);
    }
  };
  {
    std::vector<std::jthread> crew;
    for (unsigned k = 0; k < at_once; ++k) {
      crew.emplace_back(work);
    }
  }
  if (!failure.empty()) {
    throw RunError(failure);
  }
}

}  // namespace porefines::validate
