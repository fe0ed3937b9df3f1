// SPDX-License-Identifier: MPL-2.0
// Real rock and sand: what porefines finds in them, recorded here and nowhere else.
#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "core/types.hpp"
#include "support/shared_data.hpp"

namespace porefines::test {

/// One run from x- to x+, cells = voxels. Bars of issue 2: 12 cycles, or 16 where many throats are one
/// cell wide; `cycles` is what was measured (on one core, version of 2026-11-22), so that it can only
/// get better.
struct RealMedium {
  std::string name;
  std::string image;  ///< below shared/data/images
  std::vector<std::string> keys;
  Real porosity;            ///< of the voxels
  Real connected;           ///< of the voxels, after what the keys open; 0: not recorded yet
  Real permeability;        ///< [m^2] smooth surface; 0: not recorded yet
  Real voxel_permeability;  ///< [m^2] on the staircase; 0: not compared
  int cycles;
};

inline void PrintTo(const RealMedium& medium, std::ostream* out) {
  *out << medium.name;
}

/// Runs it and returns summary.json.
inline std::string summary_of(const RealMedium& medium, const std::string& folder,
                              std::vector<std::string> more = {}) {
  const bool rock = medium.image == "berea_200.tif";
  const std::string voxel = rock ? "5.345 um" : "7 um";
  write_file(folder + "/case.toml",
             "[geometry]\nsource = \"" + shared_file("images/" + medium.image) +
                 "\"\npixel_size = \"" + voxel + "\"\n" + (rock ? "" : "depth = \"112 um\"\n") +
                 "[grid]\ncell_size = \"" + voxel + "\"\n[flow]\n" +
                 "inlet = { face = \"x-\", pressure = \"1 Pa\" }\n"
                 "outlet = { face = \"x+\", pressure = \"0 Pa\" }\n");
  std::vector<std::string> words{"run", "case.toml", "output=[]"};
  words.insert(words.end(), medium.keys.begin(), medium.keys.end());
  words.insert(words.end(), more.begin(), more.end());
  const ProgramResult result = porefines_in(folder, words);
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return read_text(folder + "/out/summary.json");
}

/// Porosity and percolation exactly, work at most what it was, flux the same everywhere.
inline void expect_as_recorded(const RealMedium& medium, const std::string& summary) {
  EXPECT_NEAR(number(summary, "porosity"), medium.porosity, 5e-5);
  if (medium.connected > 0) {
    EXPECT_NEAR(number(summary, "porosity_connected"), medium.connected, 5e-5);
  }
  EXPECT_LE(number(summary, "solver_cycles"), medium.cycles + 1) << "rounding may cost one";
  EXPECT_LT(number(summary, "flux_variation"), 1e-6);
  const Real peak = number(summary, "peak_memory_bytes");
  EXPECT_GT(peak, 0.85 * number(summary, "planned_memory_bytes"));
  EXPECT_LT(peak, 1.15 * number(summary, "planned_memory_most_bytes"));
  if (medium.permeability > 0) {
    EXPECT_NEAR(number(summary, "permeability_m2") / medium.permeability, 1, 0.005);
  }
}

}  // namespace porefines::test
