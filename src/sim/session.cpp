// SPDX-License-Identifier: MPL-2.0
#include "sim/session.hpp"

#include <filesystem>
#include <iostream>
#include <optional>

#include "config/writer.hpp"
#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "core/signals.hpp"
#include "io/checkpoint.hpp"

namespace porefines::sim {

Log open_folder(const std::string& folder, const config::Case& the_case,
                const par::Communicator& comm, Start start) {
  const bool resumed = start == Start::resumed;
  on_root(comm, [&] {
    make_folder(folder);
    const auto remove = [&](const std::string& stale) {
      std::filesystem::remove(folder + "/" + stale);
    };
    for (const std::string stale :
         {"summary.json", "speed.png", "pressure.png", "particles.png", "particles_speed.png"}) {
      remove(stale);
    }
    if (!resumed) {
      for (const std::string stale :
           {"series.csv", "tracks.csv", "clogging.csv", "retention.csv", "throats_pressure.csv",
            "throats.csv", "pores.csv", "movie.mp4"}) {
        remove(stale);
      }
      io::remove_checkpoints(folder);
    }
    write_file(folder + "/case.toml", config::effective_case(the_case));
  });
  std::optional<Log> log;
  on_root(comm, [&] { log.emplace(folder + "/log.txt", &std::cout, resumed); });
  return log ? std::move(*log) : Log("", nullptr);
}

void say(Log& log, const par::Communicator& comm, const io::Provenance& provenance,
         const std::vector<std::string>& plan) {
  if (comm.is_root()) {
    log.info("{}", io::describe(provenance));
    for (const std::string& line : plan) {
      log.info("{}", line);
    }
  }
}

int signal_anywhere(const par::Communicator& comm) {
  return static_cast<int>(comm.max(Real{1} * caught_signal()));
}

void stop_if_asked(const par::Communicator& comm) {
  if (const int signal = signal_anywhere(comm); signal != 0) {
    throw Interrupted{signal};
  }
}

void write_failure(const std::string& folder, const std::string& reason,
                   const par::Communicator& comm) {
  on_root(comm, [&] {
    Json json;
    json.set("status", "stopped");
    json.set("reason", reason);
    write_file(folder + "/summary.json", json.text());
  });
}

}  // namespace porefines::sim
