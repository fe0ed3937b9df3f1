// SPDX-License-Identifier: MPL-2.0
#include "study/crew.hpp"

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json_read.hpp"
#include "core/process.hpp"
#include "core/signals.hpp"
#include "study/collect.hpp"

namespace porefines::study {
namespace {

using namespace std::chrono_literals;
constexpr auto nap = 20ms;
constexpr int naps_per_look = 50;  ///< at the members' tables

void say(const Crew& crew, std::size_t member, const std::string& text) {
  fmt::print("{:>4}/{} {} ({}): {}\n", member + 1, crew.members.size(),
             describe(crew.study, crew.members[member]), crew.members[member].name, text);
  std::fflush(stdout);
}

void start_next(Crew& crew) {
  const std::size_t member = crew.waiting.front();
  crew.waiting.pop_front();
  const std::string folder = member_folder(crew.output, crew.members[member]);
  make_folder(folder);
  const bool resumed = is_resumable(folder) && !crew.afresh[member];
  ++crew.tries[member];
  std::vector<std::string> words{"run", crew.study.case_file, "-o", folder};
  words.insert(words.end(), crew.members[member].settings.begin(),
               crew.members[member].settings.end());
  if (resumed) {
    words.emplace_back("--restart");
  }
  const pid_t process = start_process(on_ranks(crew.study.ranks, words), folder + "/console.txt");
  crew.working.push_back({member, process, resumed});
  say(crew, member, resumed ? "goes on from its checkpoint" : "started");
}

/// What a run that failed says of itself.
std::string reason_in(const std::string& folder, int code) {
  const auto summary = read_flat_json(folder + "/summary.json");
  const std::string* reason = summary ? summary->find("reason") : nullptr;
  return reason != nullptr
             ? *reason
             : fmt::format("exit code {}: {}", code, last_lines(folder + "/console.txt", 2));
}

void take_failure(Crew& crew, const Worker& worker, int code) {
  const std::size_t member = worker.member;
  const std::string folder = member_folder(crew.output, crew.members[member]);
  crew.afresh[member] = worker.resumed;  // its checkpoint may be what is wrong
  Failure failure = read_failure(folder);
  failure = {failure.attempts + 1, code, reason_in(folder, code)};
  write_failure(folder, failure);
  if (crew.tries[member] <= crew.study.retries) {
    crew.waiting.push_back(member);
    say(crew, member, "failed, will be tried again: " + failure.reason);
  } else {
    crew.failed.push_back(member);
    say(crew, member, fmt::format("failed {} times: {}", crew.tries[member], failure.reason));
  }
}

/// Those that have ended leave the list.
void look_after(Crew& crew, bool leaving) {
  for (std::size_t i = 0; i < crew.working.size();) {
    const Worker worker = crew.working[i];
    const auto code = exit_of(worker.process);
    if (!code) {
      ++i;
      continue;
    }
    crew.working.erase(crew.working.begin() + static_cast<std::ptrdiff_t>(i));
    const std::string folder = member_folder(crew.output, crew.members[worker.member]);
    if (*code == exit_code::done && is_done(folder)) {
      ++crew.done;
      say(crew, worker.member, "done");
    } else if (leaving) {
      say(crew, worker.member, "interrupted");
    } else {
      take_failure(crew, worker, *code);
    }
  }
}

/// Share of the work that is done, members at work by their time.
Real fraction(const Crew& crew) {
  Real sum = static_cast<Real>(crew.done + crew.failed.size());
  for (const Worker& worker : crew.working) {
    sum += progress_of(member_folder(crew.output, crew.members[worker.member]),
                       crew.end_times[worker.member]);
  }
  return sum / static_cast<Real>(crew.members.size());
}

/// All save their state and end.
void dismiss(Crew& crew) {
  for (const Worker& worker : crew.working) {
    kill(worker.process, SIGTERM);
  }
  while (!crew.working.empty()) {
    look_after(crew, true);
    std::this_thread::sleep_for(nap);
  }
}

}  // namespace

int work(Crew& crew) {
  Progress progress("study");
  progress.start_from(fraction(crew));
  for (int naps = 0; !crew.waiting.empty() || !crew.working.empty(); ++naps) {
    if (const int signal = caught_signal(); signal != 0) {
      dismiss(crew);
      return signal;
    }
    while (!crew.waiting.empty() &&
           crew.working.size() < static_cast<std::size_t>(crew.side_by_side)) {
      start_next(crew);
    }
    look_after(crew, false);
    if (naps % naps_per_look == 0) {
      progress.update(fraction(crew));
    }
    std::this_thread::sleep_for(nap);
  }
  progress.update(1);
  return 0;
}

}  // namespace porefines::study
