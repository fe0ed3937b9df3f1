// SPDX-License-Identifier: MPL-2.0
#include <gtest/gtest.h>

#include "sim/dry_checkpoint.hpp"

namespace porefines::sim {

TEST(SameCase, only_what_changes_the_motion_must_be_the_same) {
  const std::string before =
      "# effective case of \"a.toml\"\ntitle = \"a\"\ndrive = []\noutput = []\n\n[run]\noutput_dir "
      "= \"out\"\n"
      "end_time = \"1 s\"\nrandom_seed = 1\n\n[contact]\nfriction = 0.3\n\n[checkpoint]\nkeep = "
      "2\n";
  const auto with = [&](const std::string& old, const std::string& other) {
    std::string now = before;
    return difference_of_cases(before, now.replace(now.find(old), old.size(), other));
  };
  EXPECT_EQ(with("\"a.toml\"", "\"b.toml\""), "");
  EXPECT_EQ(with("\"1 s\"", "\"2 s\""), "");
  EXPECT_EQ(with("output = []", "output = [{}]"), "");
  EXPECT_EQ(with("drive = []", "drive = [{ from = \"1 s\", factor = 2.0 }]"), "");
  EXPECT_EQ(with("keep = 2", "keep = 3"), "");
  EXPECT_EQ(with("friction = 0.3", "friction = 0.4"),
            "then: contact.friction = 0.3\nnow:  contact.friction = 0.4");
  EXPECT_EQ(with("random_seed = 1\n", ""), "then: run.random_seed = 1\nnow:  nothing");
}

}  // namespace porefines::sim
