// SPDX-License-Identifier: MPL-2.0
#include "core/cores.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <utility>

#include <sched.h>

namespace porefines {
namespace {

int read_number(const std::string& path, int otherwise) {
  int number = otherwise;
  std::ifstream(path) >> number;
  return number;
}

/// Whole processors' worth of time that the control group allows; 0: no limit. "max 100000", or "150000 100000".
int allowed_time(const std::string& path) {
  double quota = 0;
  double period = 1;
  std::ifstream file(path);
  return file >> quota >> period && period > 0
             ? std::max(1, static_cast<int>(std::lround(quota / period)))
             : 0;
}

}  // namespace

Cores find_cores(const std::string& folder, const std::string& control_group) {
  cpu_set_t allowed;
  CPU_ZERO(&allowed);
  sched_getaffinity(0, sizeof allowed, &allowed);
  std::set<std::pair<int, int>> cores;
  Cores found{.physical = 0, .logical = 0};
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu) {
    if (CPU_ISSET(cpu, &allowed)) {
      const std::string topology = folder + "/cpu" + std::to_string(cpu) + "/topology/";
      ++found.logical;
      cores.emplace(read_number(topology + "physical_package_id", 0),
                    read_number(topology + "core_id", -1 - cpu));
    }
  }
  found.logical = std::max(1, found.logical);
  found.physical = std::max(1, static_cast<int>(cores.size()));
  const int most = allowed_time(control_group);
  found.limited = most > 0 && most < found.physical;
  found.physical = found.limited ? most : found.physical;
  return found;
}

}  // namespace porefines
