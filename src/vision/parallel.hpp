// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>

namespace porefines::vision {

/// Calls work(0) .. work(count - 1), each once, on this many threads; which thread does which is open,
/// so each call may write only to places of its own. The first exception is thrown again here.
void for_each_index(int count, int threads, const std::function<void(int)>& work);

/// What the machine has, at least 1.
[[nodiscard]] int hardware_threads();

}  // namespace porefines::vision
