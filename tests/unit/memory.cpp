// SPDX-License-Identifier: MPL-2.0
#include "core/memory.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "support/scratch.hpp"

namespace porefines {
namespace {

constexpr std::int64_t mebibyte = 1 << 20;

TEST(Memory, peak_grows_with_what_is_touched) {
  const std::int64_t before = peak_memory();
  ASSERT_GT(before, 0);
  const std::vector<char> block(before + 64 * mebibyte, 'x');  // above what went before, too
  EXPECT_GE(peak_memory(), before + 64 * mebibyte) << block.back();
}

TEST(Memory, available_is_a_sensible_number) {
  EXPECT_GT(available_memory(), mebibyte);
  EXPECT_LT(available_memory(), std::int64_t{1} << 50);
}

TEST(Memory, reads_the_right_line_of_proc) {
  const char* text = "VmPeak:\t  9 kB\nVmHWM:\t    1234 kB\nVmRSS: 8 kB\n";
  EXPECT_EQ(read_kilobytes(text, "VmHWM"), 1234 * 1024);
  EXPECT_EQ(read_kilobytes(text, "Vm"), std::nullopt);
  EXPECT_EQ(read_kilobytes("VmHWM: many\n", "VmHWM"), std::nullopt);
}

TEST(ControlGroup, leaves_limit_minus_use_plus_cache) {
  const test::Scratch folder;
  write_file(folder / "memory.max", "1000\n");
  write_file(folder / "memory.current", "700\n");
  write_file(folder / "memory.stat", "anon 1\nactive_inactive_file 9\ninactive_file 50\n");
  EXPECT_EQ(control_group_room(folder.path()), 350);
}

TEST(ControlGroup, without_a_limit_says_nothing) {
  const test::Scratch folder;
  write_file(folder / "memory.max", "max\n");
  write_file(folder / "memory.current", "700\n");
  EXPECT_EQ(control_group_room(folder.path()), std::nullopt);
}

TEST(ControlGroup, knows_version_1) {
  const test::Scratch folder;
  write_file(folder / "memory.limit_in_bytes", "1000\n");
  write_file(folder / "memory.usage_in_bytes", "1200\n");
  EXPECT_EQ(control_group_room(folder.path()), 0);
  write_file(folder / "memory.limit_in_bytes", "9223372036854771712\n");
  EXPECT_EQ(control_group_room(folder.path()), std::nullopt);
}

TEST(FormatBytes, picks_a_readable_unit) {
  EXPECT_EQ(format_bytes(17), "17 B");
  EXPECT_EQ(format_bytes(640 * mebibyte), "640 MiB");
  EXPECT_EQ(format_bytes(3 * 1024 * mebibyte / 2), "1.5 GiB");
}

}  // namespace
}  // namespace porefines
