// SPDX-License-Identifier: MPL-2.0
#include "validate/launch.hpp"

#include <atomic>
#include <filesystem>
#include <mutex>
#include <system_error>
#include <thread>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/process.hpp"
#include "core/read_text.hpp"

namespace porefines::validate {
namespace {

/// Runs this program in a folder; what it prints goes to FOLDER/said.txt. @return its exit code
int run_self(const std::string& folder, const std::vector<std::string>& words) {
  return wait_for(start_process(on_ranks(1, words), folder + "/said.txt", folder));
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
  commands[0].insert(commands[0].end(), launch.job->set.begin(), launch.job->set.end());
  if (!launch.job->instead.empty()) {
    commands = {launch.job->instead};
  }
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

bool is_done(const std::string& folder, const std::string& commit) {
  const bool known = commit.find("dirty") == std::string::npos && commit != "unknown";
  return known && read_text(folder + "/done.txt") == commit;
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
