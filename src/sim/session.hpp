// SPDX-License-Identifier: MPL-2.0
// What every kind of run does around its simulation.
#pragma once

#include <chrono>
#include <exception>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "core/log.hpp"
#include "io/agree.hpp"
#include "io/provenance.hpp"
#include "par/communicator.hpp"

namespace porefines::sim {

class Stopwatch {
 public:
  [[nodiscard]] Real seconds() const {
    return std::chrono::duration<Real>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Does something on rank 0; its failure is everybody's. Collective.
template <typename Work>
void on_root(const par::Communicator& comm, const Work& work) {
  std::string failure;
  if (comm.is_root()) {
    try {
      work();
    } catch (const std::exception& error) {
      failure = error.what();
    }
  }
  io::throw_everywhere(comm.handle(), failure);
}

enum class Start { fresh, resumed };

/// The output folder on rank 0, without the results of an earlier run: a run that stops must not
/// leave numbers that look like its own. A resumed one keeps tables, checkpoints and the log.
/// Collective. @return log.txt; silent on the other ranks
[[nodiscard]] Log open_folder(const std::string& folder, const config::Case& the_case,
                              const par::Communicator& comm, Start start = Start::fresh);

/// Version, commit and the plan, at the head of the log.
void say(Log& log, const par::Communicator& comm, const io::Provenance& provenance,
         const std::vector<std::string>& plan);

/// The signal that any rank saw, or 0. Collective.
[[nodiscard]] int signal_anywhere(const par::Communicator& comm);

/// Between two stages: leaves when any rank saw a signal. Collective.
/// @throws Interrupted
void stop_if_asked(const par::Communicator& comm);

/// summary.json of a run that stopped before it had results. Collective.
void write_failure(const std::string& folder, const std::string& reason,
                   const par::Communicator& comm);

}  // namespace porefines::sim
