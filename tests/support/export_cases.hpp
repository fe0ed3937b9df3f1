// SPDX-License-Identifier: MPL-2.0
// Cases that are carried over to the thesis's engines.
#pragma once

#include <filesystem>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {

/// A pillar between plates, 12 cells across.
inline constexpr auto pillar_case =
    "[geometry]\nkind = \"cylinders\"\nsource = \"pillar.txt\"\nsize = [\"48 "
    "um\", \"32 um\", \"12 um\"]\n"
    "list_unit = \"1 um\"\nperiodic_images = false\n"
    "[grid]\ncell_size = \"1 um\"\n"
    "[flow]\ninlet = { face = \"x-\", pressure = \"10 Pa\" }\noutlet = { face "
    "= \"x+\", pressure = \"0 Pa\" }\n"
    "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n";

/// Four spheres fall on the floor of a box and lie there.
inline constexpr auto drop_case =
    "gravity = \"9.81 m/s^2\"\n"
    "[run]\nend_time = \"60 ms\"\n"
    "[geometry]\nkind = \"empty\"\nsize = [\"2 mm\", \"2 mm\", \"2 mm\"]\n"
    "[[particles]]\nsource = \"balls.csv\"\ndensity = \"2650 kg/m^3\"\nyoung = "
    "\"10 MPa\"\npoisson = 0.25\n"
    "[contact]\nrestitution = 0.3\nmax_overlap = 0.05\n"
    "[[output]]\nkind = \"tracks\"\nevery = \"60 ms\"\n";

class Export : public ::testing::Test {
 protected:
  Export() {
    write_file(folder_ / "pillar.toml", pillar_case);
    write_file(folder_ / "pillar.txt", "24 16 8\n");
    write_file(folder_ / "drop.toml", drop_case);
    write_file(folder_ / "balls.csv",
               "x_m,y_m,z_m,diameter_m\n5e-4,5e-4,6e-4,2e-4\n1.5e-3,5e-4,7e-4,3e-4\n"
               "5e-4,1.5e-3,4e-4,4e-4\n1.5e-3,1.5e-3,5e-4,2.5e-4\n");
  }
  [[nodiscard]] ProgramResult porefines(const std::vector<std::string>& words) const {
    return porefines_in(folder_.path(), words);
  }
  static bool installed(const char* program) {
    return std::filesystem::exists(std::string("/usr/bin/") + program);
  }
  Scratch folder_;
};

}  // namespace porefines::test
