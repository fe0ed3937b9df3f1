// SPDX-License-Identifier: MPL-2.0
#include "core/read_text.hpp"

#include <fstream>
#include <iterator>

namespace porefines {

std::string read_text(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace porefines
