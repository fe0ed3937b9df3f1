// SPDX-License-Identifier: MPL-2.0
// Every kind of wrong case, with the exact message that the user sees.
#include <algorithm>

#include <gtest/gtest.h>

#include "config/reader.hpp"
#include "core/error.hpp"
#include "unit/config_cases.hpp"

namespace porefines::config {
namespace {

using test::box_case;
using test::image_case;

std::string message_of(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)parse_case(text, "x.toml", overrides);
    return "accepted";
  } catch (const InputError& error) {
    return error.what();
  }
}

/// The case with one line replaced, counted from 1.
std::string with_line(std::string text, int number, const std::string& line) {
  std::size_t start = 0;
  for (int i = 1; i < number; ++i) {
    start = text.find('\n', start) + 1;
  }
  return text.replace(start, text.find('\n', start) - start, line);
}

TEST(ConfigErrors, the_base_cases_are_fine) {
  EXPECT_EQ(message_of(box_case), "accepted");
  EXPECT_EQ(message_of(image_case), "accepted");
}

TEST(ConfigErrors, unknown_keys_get_a_suggestion) {
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_sise = \"50 um\"")),
            "x.toml:6: [grid] cell_sise: unknown key; did you mean cell_size?");
  EXPECT_EQ(message_of("titel = \"a\"\n" + box_case),
            "x.toml:1: titel: unknown key; did you mean title?");
  EXPECT_EQ(message_of(with_line(box_case, 5, "[gird]")),
            "x.toml:5: [gird]: unknown table; did you mean grid?");
  EXPECT_EQ(message_of(with_line(image_case, 10, "inlet = { face = \"x-\", presure = \"1 Pa\" }")),
            "x.toml:10: [flow] inlet.presure: unknown key; did you mean pressure?");
  EXPECT_EQ(message_of(box_case + "[[output]]\nkimd = \"fields\"\n"),
            "x.toml:12: [[output]] kimd: unknown key; did you mean kind?");
  EXPECT_EQ(message_of(with_line(box_case, 4, "\"grid.cell_size\" = 1")),
            "x.toml:4: [geometry] \"grid.cell_size\": unknown key\nknown here: kind, source, size, "
            "list_unit, periodic_images, pixel_size, threshold, pore_is_bright, pore_value, "
            "raw_size, depth, crop, surface, smooth, remove_grains_below, fill_pores_below, "
            "simplify, erode_grains, edit_mask, reconnect_gap, minimum_throat, keep");
}

TEST(ConfigErrors, a_key_in_the_wrong_table_is_sent_home) {
  EXPECT_EQ(message_of(with_line(box_case, 4, "viscosity = \"1 mPa s\"")),
            "x.toml:4: [geometry] viscosity: unknown key\nviscosity belongs in [fluid]");
  EXPECT_EQ(message_of(with_line(box_case, 4, "title = \"a\"")),
            "x.toml:4: [geometry] title: unknown key\n"
            "title belongs at the top of the file, before the first [table]");
}

TEST(ConfigErrors, what_is_not_toml_is_shown_with_its_line) {
  const std::string message = message_of(with_line(box_case, 6, "cell_size = 50 um"));
  EXPECT_TRUE(message.starts_with("x.toml:6: this is not TOML: ")) << message;
  EXPECT_TRUE(message.ends_with("\na value with a unit stands in quotes: cell_size = \"50 um\""))
      << message;
  EXPECT_TRUE(message_of("\n[grid").starts_with("x.toml:2: this is not TOML: "));
  EXPECT_TRUE(message_of("a = \"\xff\"").starts_with("x.toml:1: this is not TOML: "));
}

TEST(ConfigErrors, wrong_types_say_what_is_wanted) {
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = true")),
            "x.toml:6: [grid] cell_size wants a length such as \"5.345 um\", found true");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = 5e-5")),
            "x.toml:6: [grid] cell_size wants a length such as \"5.345 um\", found 5e-05\n"
            "a bare number has no unit; if SI is meant, write \"5e-05 m\"");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"5e-5\"")),
            "x.toml:6: [grid] cell_size wants a length such as \"5.345 um\", found \"5e-5\" "
            "(no unit)");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cells = [64, 64]")),
            "x.toml:6: [grid] cells: has 2 numbers, needs 3: [64, 64, 64]");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cells = [64, 64, 6.5]")),
            "x.toml:6: [grid] cells wants a whole number from 1 to 1048576, found 6.5");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cells = 64")),
            "x.toml:6: [grid] cells wants a list such as [64, 64, 64], found 64");
  EXPECT_EQ(message_of("title = 2026-11-22\n" + box_case),
            "x.toml:1: title wants a text in quotes, found a date or time");
  EXPECT_EQ(message_of(box_case + "tensor = \"yes\"\n"),
            "x.toml:11: [flow] tensor wants true or false (without quotes), found \"yes\"");
  EXPECT_EQ(message_of("grid = 5\n"),
            "x.toml:1: grid wants a table with cell_size and others, found 5");
  EXPECT_EQ(message_of(with_line(image_case, 10, "inlet = \"x-\"")),
            "x.toml:10: [flow] inlet wants a table with face and others, found \"x-\"");
  EXPECT_EQ(message_of(with_line(box_case, 3, "size = [\"1 mm\", 3, \"1 mm\"]")),
            "x.toml:3: [geometry] size wants a length such as \"5.345 um\", found 3\n"
            "a bare number has no unit; if SI is meant, write \"3 m\"");
  EXPECT_EQ(message_of(image_case, {"geometry.threshold=ostu"}),
            "command line: geometry.threshold wants \"otsu\" or a grey level such as 128, "
            "found \"ostu\"");
  EXPECT_EQ(message_of(box_case, {"grid.decomposition=best"}),
            "command line: grid.decomposition wants \"auto\" or ranks along x, y, z such as "
            "[2, 1, 1], found \"best\"");
}

TEST(ConfigErrors, the_dimension_is_checked) {
  EXPECT_EQ(message_of(box_case + "[fluid]\nviscosity = \"1.002 mPa\"\n"),
            "x.toml:12: [fluid] viscosity wants a dynamic viscosity such as \"1.002 mPa s\", "
            "found \"1.002 mPa\" (a pressure)");
}

TEST(ConfigErrors, choices_list_what_is_allowed) {
  EXPECT_EQ(message_of(with_line(box_case, 2, "kind = \"sphere\"")),
            "x.toml:2: [geometry] kind wants \"image\", \"spheres\", \"cylinders\" or \"empty\", "
            "found \"sphere\"\ndid you mean \"spheres\"?");
  EXPECT_EQ(message_of(box_case + "slip = [\"up\"]\n"),
            "x.toml:11: [flow] slip wants \"x-\", \"x+\", \"y-\", \"y+\", \"z-\" or \"z+\", "
            "found \"up\"");
}

TEST(ConfigErrors, absurd_values_are_refused) {
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"0 um\"")),
            "x.toml:6: [grid] cell_size: \"0 um\" is out of range, allowed is above 0 m and up to "
            "1000 m\nfor example \"5.345 um\"");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"-5 um\"")),
            "x.toml:6: [grid] cell_size: \"-5 um\" is out of range, allowed is above 0 m and up to "
            "1000 m\nfor example \"5.345 um\"");
  EXPECT_EQ(message_of(box_case + "[fluid]\nviscosity = \"1.002e-9 Pa s\"\n"),
            "x.toml:12: [fluid] viscosity: \"1.002e-9 Pa s\" is out of range, allowed is from "
            "1e-06 Pa s to 1000 Pa s\nfor example \"1.002 mPa s\"");
  EXPECT_EQ(message_of(box_case + "tolerance = nan\n"),
            "x.toml:11: [flow] tolerance: nan is not a finite number");
  EXPECT_EQ(message_of(box_case + "tolerance = 2\n"),
            "x.toml:11: [flow] tolerance: 2 is out of range, allowed is from 1e-14 to 0.1");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"nan m\"")),
            "x.toml:6: [grid] cell_size wants a length such as \"5.345 um\", found \"nan m\": "
            "the number is not finite or too small");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"50 mm\"")),
            "x.toml:6: [grid] cell_size: 0.05 m is larger than the box, 0.001 m along x\n"
            "is the unit right?");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cell_size = \"5 nm\"")),
            "x.toml:6: [grid] cell_size: 5e-09 m makes 8e+15 cells, more than 2^40\n"
            "is the unit right?");
  EXPECT_EQ(message_of(with_line(box_case, 6, "cells = [100000, 100000, 1000]")),
            "x.toml:6: [grid] cells: asks for more than 2^40 cells");
}

TEST(ConfigErrors, what_later_versions_bring_is_named) {
  const std::string message = message_of(box_case + "[colloid]\nx = 1\n");
  EXPECT_TRUE(message.starts_with("x.toml:11: [colloid]: not available in this version\n"))
      << message;
  EXPECT_EQ(message_of(box_case + "[coupling]\ntravel = 1\n"),
            "x.toml:11: [coupling]: is for particles, and there are none");
  EXPECT_TRUE(message_of(box_case + "[[compare]]\n").starts_with("x.toml:11: [[compare]]: not av"));
  EXPECT_EQ(message_of(box_case + "regime = \"navier-stokes\"\n"),
            "x.toml: [run] end_time: is missing\n"
            "end_time = \"1 s\", or steady = true for the steady flow alone");
  EXPECT_EQ(
      message_of(box_case + "steady = false\n"),
      "x.toml:11: [flow] steady: false has no meaning for a creeping flow, which has no memory\n"
      "delete the key, or take regime = \"navier-stokes\"");
  EXPECT_EQ(message_of(box_case + "courant = 0.5\n"),
            "x.toml:11: [flow] courant: needs a flow with inertia\n"
            "regime = \"navier-stokes\"");
  EXPECT_EQ(message_of(box_case + "[[output]]\nkind = \"tracks\"\n"),
            "x.toml:12: [[output]] kind: has no meaning for a steady flow\n"
            "there are no moving particles to track");
  EXPECT_EQ(message_of(box_case + "[[output]]\nkind = \"fields\"\nevery = \"1 s\"\n"),
            "x.toml:13: [[output]] every: has no meaning for a steady flow, which is written once");
}

TEST(ConfigErrors, overrides_name_the_command_line) {
  EXPECT_EQ(message_of(box_case, {"grid.cell_sise=5 um"}),
            "command line: grid.cell_sise: unknown key; did you mean cell_size?");
  EXPECT_EQ(message_of(box_case, {"grid.cell_size=5"}),
            "command line: grid.cell_size wants a length such as \"5.345 um\", found 5\n"
            "a bare number has no unit; if SI is meant, write \"5 m\"");
  EXPECT_EQ(message_of(box_case, {"grid.cell_size"}),
            "command line: \"grid.cell_size\" is no override\n"
            "write key.path=value, e.g. \"grid.cell_size=5 um\"");
  EXPECT_EQ(message_of(box_case, {"grid..cell_size=1"}),
            "command line: \"grid..cell_size\" is no key\n"
            "write key.path=value, e.g. \"grid.cell_size=5 um\"");
  EXPECT_EQ(message_of(box_case, {"title=caf\xe9"}), "command line: title: is not UTF-8 text");
  EXPECT_EQ(message_of(box_case, {"grid.cell_size.x=1"}),
            "command line: grid.cell_size: is a single value, it holds no key x");
}

}  // namespace
}  // namespace porefines::config
