// SPDX-License-Identifier: MPL-2.0
#include "core/log.hpp"

#include <fstream>
#include <iterator>
#include <sstream>

#include <gtest/gtest.h>

#include "core/error.hpp"
#include "support/scratch.hpp"

namespace porefines {

TEST(Log, writes_each_line_to_the_console_and_at_once_to_the_file) {
  const test::Scratch folder;
  std::ostringstream console;
  Log log(folder / "log.txt", &console);
  log.info("{} cells", 64);
  log.warn("Re = {:.1f}", 2.0);
  std::ifstream file(folder / "log.txt");
  const std::string written{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(written, "64 cells\nwarning: Re = 2.0\n");
  EXPECT_EQ(console.str(), written);
}

TEST(Log, a_restart_continues_the_file) {
  const test::Scratch folder;
  Log(folder / "log.txt", nullptr).info("one");
  Log(folder / "log.txt", nullptr, true).info("two");
  std::ifstream file(folder / "log.txt");
  EXPECT_EQ((std::string{std::istreambuf_iterator<char>(file), {}}), "one\ntwo\n");
}

TEST(Log, says_when_it_cannot_write) {
  EXPECT_THROW(Log("/no/such/folder/log.txt", nullptr), RunError);
}

}  // namespace porefines
