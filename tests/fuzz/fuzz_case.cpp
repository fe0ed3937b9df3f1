// SPDX-License-Identifier: MPL-2.0
// Any text is either a case or an InputError; and what is a case survives being written and read.
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "config/reader.hpp"
#include "config/writer.hpp"
#include "core/error.hpp"

namespace {

using namespace porefines;

void require_round_trip(const config::Case& original) {
  const std::string written = config::effective_case(original);
  try {
    config::Case again = config::parse_case(written, "again.toml");
    again.path = original.path;
    if (again == original) {
      return;
    }
    std::fprintf(stderr, "reads back differently:\n%s", written.c_str());
  } catch (const InputError& error) {
    std::fprintf(stderr, "does not read back: %s\n%s", error.what(), written.c_str());
  }
  std::abort();
}

}  // namespace

/// The input is a case; lines after the first '\0' are overrides, each up to the next '\0'.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string input(reinterpret_cast<const char*>(data), size);
  const auto first = input.find('\0');
  const std::string text = input.substr(0, first);
  std::vector<std::string> overrides;
  for (auto start = first; start != std::string::npos;) {
    const auto end = input.find('\0', start + 1);
    overrides.push_back(input.substr(start + 1, end == std::string::npos ? end : end - start - 1));
    start = end;
  }
  try {
    require_round_trip(config::parse_case(text, "fuzz.toml", overrides));
  } catch (const InputError&) {
    // the expected answer to nonsense
  }
  return 0;
}
