// SPDX-License-Identifier: MPL-2.0
#include "interop/openfoam_text.hpp"

#include <filesystem>

namespace porefines::interop {

void make_executable(const std::string& path) {
  using std::filesystem::perms;
  std::filesystem::permissions(path, perms::owner_exec | perms::group_exec | perms::others_exec,
                               std::filesystem::perm_options::add);
}

}  // namespace porefines::interop
