// SPDX-License-Identifier: MPL-2.0
#include "io/read_table.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "support/scratch.hpp"

namespace porefines::io {
namespace {

class ReadTable : public ::testing::Test {
 protected:
  /// Two profiles of two rows; then one of too few words, and one without its newline.
  ReadTable() { write_file(file_, "time_s,x_m,event\n0,1,a\n0,2,\n5,1,b\n5,2,c\n5,2\n5,3,cu"); }
  test::Scratch folder_;
  std::string file_ = folder_ / "table.csv";
};

TEST_F(ReadTable, takes_whole_rows_only) {
  const TextTable table = read_table(file_);
  EXPECT_EQ(table.names, (std::vector<std::string>{"time_s", "x_m", "event"}));
  EXPECT_EQ(table.numbers("x_m"), (std::vector<Real>{1, 2, 1, 2}));
  EXPECT_EQ(table.texts("event"), (std::vector<std::string>{"a", "", "b", "c"}));
  EXPECT_TRUE(std::isnan(table.numbers("event")[0]));
  EXPECT_TRUE(std::isnan(table.numbers("missing")[0]));
  EXPECT_EQ(table.column("missing"), -1);
  EXPECT_TRUE(read_table(file_ + ".not").names.empty());
}

TEST_F(ReadTable, keeps_the_last_profile) {
  TextTable table = read_table(file_);
  table.keep_last("time_s");
  EXPECT_EQ(table.texts("event"), (std::vector<std::string>{"b", "c"}));
  table.keep_last("missing");
  EXPECT_EQ(table.rows.size(), 2U);
}

TEST(NumberOf, takes_a_whole_word_only) {
  EXPECT_EQ(number_of("-1.5e-3"), -1.5e-3);
  for (const char* word : {"", "x", "1x", " 1", "nan"}) {
    EXPECT_TRUE(std::isnan(number_of(word))) << word;
  }
}

}  // namespace
}  // namespace porefines::io
