// SPDX-License-Identifier: MPL-2.0
#include "core/aligned.hpp"

#include <cstdint>
#include <set>

#include <gtest/gtest.h>

namespace porefines {
namespace {

std::uintptr_t address(const AlignedVector<float>& v) {
  return reinterpret_cast<std::uintptr_t>(v.data());
}

}  // namespace

TEST(AlignedVector, begins_on_a_cache_line_whatever_its_size) {
  for (const std::size_t count : {1UL, 100UL, 5'000UL, 300'000UL, 600'000UL, 3'000'001UL}) {
    AlignedVector<float> v(count, 1.0F);
    EXPECT_EQ(address(v) % 64, 0U) << count;
    v.resize(2 * count, 2.0F);
    EXPECT_EQ(v[count - 1], 1.0F) << count;
    EXPECT_EQ(v.back(), 2.0F) << count;
  }
}

/// A dozen fields of a level must not want the same sets of a cache: sweeps ran at half their speed.
TEST(AlignedVector, neighbours_begin_at_different_places_of_a_page) {
  for (const std::size_t count : {100'000UL, 2'000'000UL}) {
    std::vector<AlignedVector<float>> fields;
    std::set<std::uintptr_t> places;
    for (int k = 0; k < 16; ++k) {
      fields.emplace_back(count);
      places.insert(address(fields.back()) % 4096);
    }
    EXPECT_EQ(places.size(), 16U) << count;
  }
}

}  // namespace porefines
