// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/tree.hpp"
#include "study/study.hpp"

namespace porefines::study {

/// key or keys with values (one list per point for several keys), or from, to, count, spacing; name and at for
/// plots. @throws InputError
[[nodiscard]] Axis read_axis(const config::Node& node);

}  // namespace porefines::study
