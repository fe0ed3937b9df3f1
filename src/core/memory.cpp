// SPDX-License-Identifier: MPL-2.0
#include "core/memory.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fstream>
#include <limits>

#include <fmt/format.h>
#include <malloc.h>

#include "core/read_text.hpp"

namespace porefines {
namespace {

std::optional<std::int64_t> to_number(std::string_view text) {
  const auto start = text.find_first_not_of(" \t");
  if (start == text.npos) {
    return std::nullopt;
  }
  std::int64_t number = 0;
  const auto [end, failure] =
      std::from_chars(text.data() + start, text.data() + text.size(), number);
  return failure == std::errc{} ? std::optional(number) : std::nullopt;
}

/// The number of a line "key 123" of memory.stat; 0 when the key is absent.
std::int64_t statistic(const std::string& text, const std::string& key) {
  const auto at = ("\n" + text).find("\n" + key + " ");
  return at == std::string::npos
             ? 0
             : to_number(std::string_view(text).substr(at + key.size() + 1)).value_or(0);
}

/// The control group of this process as a path below the mount point: "/user.slice/...".
std::string own_group(std::string_view hierarchy) {
  std::ifstream file("/proc/self/cgroup");
  for (std::string line; std::getline(file, line);) {
    const auto at = line.find(hierarchy);
    if (at != std::string::npos) {
      return line.substr(at + hierarchy.size());
    }
  }
  return {};
}

/// Limits hold for a group and everything below it: the tightest up to the root counts.
std::optional<std::int64_t> tightest_room(const std::string& mount, std::string group) {
  std::optional<std::int64_t> tightest;
  while (true) {
    if (const auto room = control_group_room(mount + group)) {
      tightest = tightest ? std::min(*tightest, *room) : *room;
    }
    const auto slash = group.rfind('/');
    if (slash == std::string::npos) {
      return tightest;
    }
    group.erase(slash);
  }
}

}  // namespace

std::optional<std::int64_t> read_kilobytes(std::string_view text, std::string_view key) {
  while (!text.empty()) {
    const auto end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.starts_with(key) && line.substr(key.size()).starts_with(':')) {
      const auto number = to_number(line.substr(key.size() + 1));
      return number ? std::optional(*number * 1024) : std::nullopt;
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return std::nullopt;
}

std::optional<std::int64_t> control_group_room(const std::string& folder) {
  constexpr std::int64_t unlimited = std::int64_t{1} << 60;
  struct Version {
    const char* limit;
    const char* use;
    const char* reclaimable;
  };
  constexpr std::array versions{
      Version{"/memory.max", "/memory.current", "inactive_file"},
      Version{"/memory.limit_in_bytes", "/memory.usage_in_bytes", "total_inactive_file"}};
  for (const Version& version : versions) {
    const auto limit = to_number(read_text(folder + version.limit));
    const auto use = to_number(read_text(folder + version.use));
    if (limit && use && *limit < unlimited) {
      const auto cache = statistic(read_text(folder + "/memory.stat"), version.reclaimable);
      return std::max<std::int64_t>(0, *limit - *use + cache);
    }
  }
  return std::nullopt;
}

std::int64_t peak_memory() {
  return read_kilobytes(read_text("/proc/self/status"), "VmHWM").value_or(0);
}

std::int64_t available_memory() {
  std::int64_t least = std::numeric_limits<std::int64_t>::max();
  for (const auto& room : {read_kilobytes(read_text("/proc/meminfo"), "MemAvailable"),
                           tightest_room("/sys/fs/cgroup", own_group("0::")),
                           tightest_room("/sys/fs/cgroup/memory", own_group(":memory:"))}) {
    least = std::min(least, room.value_or(least));
  }
  return least;
}

std::string format_bytes(std::int64_t bytes) {
  constexpr double step = 1024;
  constexpr std::array names{"B", "KiB", "MiB", "GiB", "TiB", "PiB"};
  double value = static_cast<double>(bytes);
  std::size_t name = 0;
  while (value >= step && name + 1 < names.size()) {
    value /= step;
    ++name;
  }
  return fmt::format("{:.{}f} {}", value, value < 100 && name > 0 ? 1 : 0, names[name]);
}

void give_back_memory() {
  ::malloc_trim(0);
}

}  // namespace porefines
