// SPDX-License-Identifier: MPL-2.0
#include "core/cores.hpp"

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "core/json_read.hpp"
#include "support/scratch.hpp"

namespace porefines {
namespace {

/// All processors of this machine as hyper-threads of one core.
TEST(Cores, hyper_threads_are_no_cores) {
  const test::Scratch folder;
  for (int cpu = 0; cpu < 1024; ++cpu) {
    const std::string topology = folder / ("cpu" + std::to_string(cpu) + "/topology");
    make_folder(topology);
    write_file(topology + "/core_id", "7\n");
    write_file(topology + "/physical_package_id", "0\n");
  }
  const Cores cores = find_cores(folder.path(), folder / "cpu.max");
  EXPECT_EQ(cores.physical, 1);
  EXPECT_GE(cores.logical, 1);
  EXPECT_FALSE(cores.limited);
}

TEST(Cores, a_container_may_allow_fewer) {
  const test::Scratch folder;  // says nothing of cores: each processor is one
  const Cores all = find_cores(folder.path(), folder / "none");
  EXPECT_EQ(all.physical, all.logical);
  write_file(folder / "cpu.max", "100000 100000\n");
  EXPECT_EQ(find_cores(folder.path(), folder / "cpu.max").physical, 1);
  write_file(folder / "cpu.max", "max 100000\n");
  EXPECT_EQ(find_cores(folder.path(), folder / "cpu.max").physical, all.physical);
}

TEST(FlatJson, reads_back_what_was_written) {
  Json json;
  json.set("text", "a \"b\"\n{c}, d");
  json.set("number", 1.25e-7);
  json.set("none", Real{1} / 0.0);
  json.set("flag", true);
  const auto read = parse_flat_json(json.text());
  ASSERT_TRUE(read);
  EXPECT_EQ(*read->find("text"), "a \"b\"\n{c}, d");
  EXPECT_DOUBLE_EQ(read->number("number"), 1.25e-7);
  EXPECT_NE(read->number("none"), read->number("none"));
  EXPECT_EQ(*read->find("flag"), "true");
  EXPECT_EQ(read->find("other"), nullptr);
  for (const char* broken : {"", "{", "{\"a\": 1", "{\"a\" 1}", "[1]", "{\"a\": \"b}"}) {
    EXPECT_FALSE(parse_flat_json(broken)) << broken;
  }
  EXPECT_TRUE(parse_flat_json("{}"));
}

}  // namespace
}  // namespace porefines
