// SPDX-License-Identifier: MPL-2.0
// The runs of a study at work.
#pragma once

#include <deque>
#include <vector>

#include <sys/types.h>

#include "core/progress.hpp"
#include "core/types.hpp"
#include "study/folder.hpp"
#include "study/plan.hpp"

namespace porefines::study {

/// One run at work.
struct Worker {
  std::size_t member = 0;
  pid_t process = 0;
  bool resumed = false;
};

/// Members to do, at work, done and failed.
struct Crew {
  const Study& study;
  const std::vector<Member>& members;
  const std::string& output;
  int side_by_side;
  std::deque<std::size_t> waiting;
  std::vector<Worker> working = {};
  std::vector<Real> end_times = {};  ///< [s] simulated, for the progress
  std::vector<int> tries = {};       ///< per member, of this study
  std::vector<bool> afresh = {};     ///< per member: a restart failed, so begin anew
  std::size_t done = 0;
  std::vector<std::size_t> failed = {};
};

/// Works until nothing is left, or a signal came: then all have saved their state. @return the signal, or 0
[[nodiscard]] int work(Crew& crew);

}  // namespace porefines::study
