// SPDX-License-Identifier: MPL-2.0
#include "study/folder.hpp"

#include <cerrno>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <system_error>
#include <thread>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json.hpp"
#include "core/json_read.hpp"
#include "core/signals.hpp"

namespace porefines::study {
namespace {

using namespace std::chrono_literals;
constexpr auto nap = 50ms;

/// The study that wrote its number there still lives.
int living_owner(const std::string& path) {
  int process = 0;
  std::ifstream(path) >> process;
  return process > 0 && process != getpid() && kill(process, 0) == 0 ? process : 0;
}

}  // namespace

std::string member_folder(const std::string& output, const Member& member) {
  return output + "/members/" + member.name;
}

FolderLock::FolderLock(const std::string& output) {
  const std::string path = output + "/study.lock";
  // NOLINTNEXTLINE(android-cloexec-open): the members are to hold it too
  file_ = open(path.c_str(), O_RDWR | O_CREAT, 0666);
  if (file_ < 0) {
    throw RunError(
        fmt::format("cannot write {}: {}", path, std::generic_category().message(errno)));
  }
  bool said = false;
  while (flock(file_, LOCK_EX | LOCK_NB) != 0) {
    if (const int owner = living_owner(path); owner != 0) {
      throw InputError(
          fmt::format("{}: another study is at work there (process {})\nwait for it, stop it, or "
                      "give another -o",
                      output, owner));
    }
    if (!said) {
      fmt::print("waiting for the runs of an earlier study to save their state\n");
      std::fflush(stdout);
      said = true;
    }
    if (caught_signal() != 0) {
      throw Interrupted{caught_signal()};
    }
    std::this_thread::sleep_for(nap);
  }
  std::ofstream(path) << getpid() << '\n';
}

FolderLock::~FolderLock() {
  close(file_);
}

Failure read_failure(const std::string& folder) {
  Failure failure;
  if (const auto json = read_flat_json(folder + "/failure.json")) {
    failure.attempts = static_cast<int>(json->number("attempts"));
    failure.exit_code = static_cast<int>(json->number("exit_code"));
    failure.reason = json->find("reason") != nullptr ? *json->find("reason") : "";
  }
  return failure;
}

void write_failure(const std::string& folder, const Failure& failure) {
  Json json;
  json.set("attempts", failure.attempts);
  json.set("exit_code", failure.exit_code);
  json.set("reason", failure.reason);
  write_file(folder + "/failure.json", json.text());
}

bool is_resumable(const std::string& folder) {
  return std::filesystem::exists(folder + "/checkpoint.h5");
}

}  // namespace porefines::study
