// SPDX-License-Identifier: MPL-2.0
// Every way to drive the flow and every kind of surface, from the case to summary.json.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "core/types.hpp"
#include "geom/image_write.hpp"

namespace porefines {
namespace {

using test::number;

class Drive : public ::testing::Test {
 protected:
  std::string summary_of(const std::string& the_case, std::vector<std::string> words = {}) {
    write_file(folder_ / "case.toml", the_case);
    words.insert(words.begin(), {"run", "case.toml", "output=[]"});
    const auto result = test::porefines_in(folder_.path(), words);
    EXPECT_EQ(result.exit_code, 0) << result.output;
    return test::read_text(folder_ / "out/summary.json");
  }

  /// Periodic box of one thin layer with cylinders from rows "x y r" in mm.
  std::string cylinders(const std::string& list, const std::string& cells) {
    write_file(folder_ / "list.txt", list);
    return "[geometry]\nkind = \"cylinders\"\nsource = \"list.txt\"\nlist_unit = \"1 mm\"\n"
           "size = [\"1 mm\", \"1 mm\", \"0.1 mm\"]\n[grid]\ncells = " +
           cells + "\n[flow]\nperiodic = [\"x\", \"y\", \"z\"]\npressure_gradient = \"1 Pa/m\"\n";
  }

  test::Scratch folder_;
};

/// What enters is u A; far from the entrance two plates take 12 mu u L / h^2.
TEST_F(Drive, a_uniform_velocity_at_the_inlet) {
  const std::string chip =
      "[geometry]\nkind = \"empty\"\nsize = [\"64 um\", \"16 um\", \"16 um\"]\n"
      "[grid]\ncells = [64, 16, 16]\n[flow]\n"
      "inlet = { face = \"x-\", velocity = \"1 mm/s\" }\n"
      "outlet = { face = \"x+\", pressure = \"3 Pa\" }\n"
      "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n";
  const std::string summary = summary_of(chip);
  EXPECT_NEAR(number(summary, "flow_rate_m3_s") / (1e-3 * 16e-6 * 16e-6), 1, 1e-5);
  EXPECT_LT(number(summary, "flux_variation"), 1e-6);
  const Real plates = 12 * 1.002e-3 * 1e-3 * 64e-6 / (16e-6 * 16e-6);
  const Real drop = number(summary, "pressure_drop_pa");
  EXPECT_GT(drop, plates) << "the profile takes pressure to develop";
  EXPECT_LT(drop, 1.25 * plates);
}

/// A slot of 10 pixels between straight walls, on the staircase itself: half a pixel to each wall, so
/// k = (h^2/12 + 1/6 pixel^2) times the share of open pixels.
TEST_F(Drive, a_staircase_of_voxels) {
  geom::Voxels slot = geom::make_voxels({24, 16, 1}, 0);
  for (int j = 3; j < 13; ++j) {
    for (int i = 0; i < 24; ++i) {
      slot.at(i, j, 0) = 1;
    }
  }
  geom::write_image(folder_ / "slot.png", slot.view());
  const std::string summary = summary_of(
      "[geometry]\nsource = \"slot.png\"\npixel_size = \"2 um\"\ndepth = \"8 um\"\n"
      "surface = \"voxel\"\n[grid]\ncell_size = \"2 um\"\n[flow]\n"
      "periodic = [\"x\"]\npressure_gradient = \"1 kPa/m\"\nslip = [\"z-\", \"z+\"]\n",
      {"flow.tolerance=1e-9"});
  const Real pixel = 2e-6;
  const Real exact = (100.0 / 12 + 1.0 / 6) * pixel * pixel * 10 / 16;
  EXPECT_NEAR(number(summary, "permeability_m2") / exact, 1, 1e-6);
  EXPECT_EQ(number(summary, "porosity"), 0.625);
  EXPECT_EQ(number(summary, "porosity_connected"), 0.625);
}

/// Sangani & Acrivos (1982): F/(mu U) = 51.527 per unit length at a solid fraction of 0.2.
TEST_F(Drive, a_cylinder_array_and_its_drag) {
  const std::string summary =
      summary_of(cylinders("0.5 0.5 0.25231325\n", "[48, 48, 2]"), {"flow.tensor=true"});
  EXPECT_NEAR(number(summary, "drag_per_length_over_viscosity_velocity") / 51.527, 1, 0.005);
  EXPECT_NEAR(number(summary, "porosity"), 0.8, 0.001);
  const Real k = number(summary, "k_xx");
  EXPECT_EQ(number(summary, "permeability_m2"), k);
  EXPECT_NEAR(number(summary, "k_yy") / k, 1, 1e-4);
  EXPECT_GT(number(summary, "k_zz"), 1.5 * k) << "along the cylinders the way is easier";
  for (const std::string zero : {"k_xy", "k_yx", "k_xz", "k_zx", "k_yz", "k_zy"}) {
    EXPECT_NEAR(number(summary, zero) / k, 0, 1e-4) << zero;
  }
  EXPECT_GE(number(summary, "flux_cycles"), 0);
}

/// Eight discs in a ring, each overlapping the next, hold back a pocket of known area.
TEST_F(Drive, a_pocket_within_a_ring_is_pore_but_not_connected) {
  constexpr Real ring = 0.3;
  constexpr Real r = 0.13;
  std::string list;
  for (int i = 0; i < 8; ++i) {
    const Real angle = i * std::numbers::pi / 4;
    list += std::to_string(0.5 + ring * std::cos(angle)) + " " +
            std::to_string(0.5 + ring * std::sin(angle)) + " " + std::to_string(r) + "\n";
  }
  const Real side = 2 * ring * std::sin(std::numbers::pi / 8);
  const Real lens =
      2 * r * r * std::acos(side / (2 * r)) - side / 2 * std::sqrt(4 * r * r - side * side);
  const Real octagon = 2 * std::numbers::sqrt2 * ring * ring;
  const Real pocket = octagon - 8 * (3 * std::numbers::pi / 8 * r * r) + 4 * lens;
  const std::string summary = summary_of(cylinders(list, "[64, 64, 1]"));
  EXPECT_NEAR(number(summary, "porosity") - number(summary, "porosity_connected"), pocket, 0.003);
}

}  // namespace
}  // namespace porefines
