// SPDX-License-Identifier: MPL-2.0
// Random close packing of 10,000 equal frictionless spheres: 0.63 to 0.65 (Berryman 1983; O'Hern
// et al. 2003: 0.639 for large systems), mean overlap below 0.1 % of a diameter. Half a minute.
#include "dem/packing.hpp"

#include <gtest/gtest.h>

namespace porefines::dem {
namespace {

TEST(RandomClosePacking, of_ten_thousand_spheres) {
  const PackingSpace space{{0, 0, 0}, {1e-3, 1e-3, 1e-3}, {true, true, true}};
  const Packing packing = pack_dense(space, std::vector<Real>(10'000, 20e-6));
  const Real fraction = sphere_volume(packing.radius) / space.volume();
  RecordProperty("volume_fraction", std::to_string(fraction));
  RecordProperty("mean_overlap", std::to_string(packing.mean_overlap));
  EXPECT_GT(fraction, 0.63);
  EXPECT_LT(fraction, 0.65);
  EXPECT_LT(packing.mean_overlap, 1e-3);
  EXPECT_GT(packing.contacts, 5.8);  // isostatic: 6 for all but the few rattlers
  EXPECT_LT(packing.contacts, 6.3);
}

}  // namespace
}  // namespace porefines::dem
