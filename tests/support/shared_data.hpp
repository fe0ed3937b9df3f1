// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdlib>
#include <filesystem>
#include <string>

namespace porefines::test {

/// Path of a file in ../shared/data beside the checkout (or in $PF_SHARED/data); empty when it is not
/// there: third-party data are no part of this repository. Skip visibly then.
inline std::string shared_file(const std::string& name) {
  const char* const given = std::getenv("PF_SHARED");
  const std::filesystem::path root =
      given != nullptr ? given : std::filesystem::path(PF_SOURCE_DIR) / "../shared";
  const auto path = root / "data" / name;
  return std::filesystem::exists(path) ? path.string() : "";
}

}  // namespace porefines::test
