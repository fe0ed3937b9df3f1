// SPDX-License-Identifier: MPL-2.0
#include "core/json.hpp"

#include <cstdlib>
#include <limits>

#include <gtest/gtest.h>

namespace porefines {

TEST(Json, keeps_the_order_and_replaces_in_place) {
  Json json;
  json.set("status", "running");
  json.set("cells", Index{1} << 40);
  json.set("converged", true);
  json.set("status", "done");
  EXPECT_EQ(json.text(),
            "{\n  \"status\": \"done\",\n  \"cells\": 1099511627776,\n"
            "  \"converged\": true\n}\n");
}

TEST(Json, numbers_read_back_bit_for_bit) {
  for (const Real value : {0.1, 2.5 * darcy, -1e-300, 123456789.123456789}) {
    Json json;
    json.set("k", value);
    const std::string text = json.text();
    EXPECT_EQ(std::strtod(text.c_str() + text.find(':') + 1, nullptr), value) << text;
  }
}

TEST(Json, says_null_for_what_is_not_a_number) {
  Json json;
  json.set("a", std::numeric_limits<Real>::quiet_NaN());
  json.set("b", std::numeric_limits<Real>::infinity());
  EXPECT_EQ(json.text(), "{\n  \"a\": null,\n  \"b\": null\n}\n");
}

TEST(Json, escapes_strings) {
  EXPECT_EQ(json_string("a \"b\" \\ \n\t\x01"), "\"a \\\"b\\\" \\\\ \\n\\t\\u0001\"");
  EXPECT_EQ(json_string("5 \u00b5m"), "\"5 \u00b5m\"");
  EXPECT_EQ(json_string("\xff\xc3"), "\"\\ufffd\\ufffd\"");  // Latin-1 and a cut sequence
}

TEST(Json, knows_utf8) {
  EXPECT_TRUE(is_utf8("5 \u00b5m \u20ac \U0001f600"));
  EXPECT_FALSE(is_utf8("\xe9"));
  EXPECT_FALSE(is_utf8("\xc0\x80"));          // overlong
  EXPECT_FALSE(is_utf8("\xed\xa0\x80"));      // surrogate
  EXPECT_FALSE(is_utf8("\xf4\x90\x80\x80"));  // past the last code point
}

TEST(Json, an_empty_object_is_valid) {
  EXPECT_EQ(Json().text(), "{\n}\n");
}

}  // namespace porefines
