// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

namespace porefines {

/// Processors of this machine that this process may use.
struct Cores {
  int physical = 1;      ///< distinct cores among them, at most what the control group allows
  int logical = 1;       ///< hyper-threads too
  bool limited = false;  ///< a container or batch system allows less time than there are cores
};

/// Counts distinct (package, core) pairs below `folder` among the processors that the scheduler allows
/// (taskset, batch systems); a machine that does not say has one core per processor.
/// Test: unit/cores (a machine made of files).
[[nodiscard]] Cores find_cores(const std::string& folder = "/sys/devices/system/cpu",
                               const std::string& control_group = "/sys/fs/cgroup/cpu.max");

}  // namespace porefines
