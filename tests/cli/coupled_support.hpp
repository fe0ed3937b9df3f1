// SPDX-License-Identifier: MPL-2.0
// Small cases with fluid and particles.
#pragma once

#include <string>
#include <vector>

#include <fmt/format.h>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"

namespace porefines::test {

/// A slit with a suspension of neutrally buoyant fines coming in.
inline const std::string slit_case = R"([run]
end_time = "6 ms"
[geometry]
kind = "empty"
size = ["48 um", "16 um", "16 um"]
[grid]
cell_size = "1 um"
[fluid]
density = "1050 kg/m^3"
viscosity = "1 mPa s"
[flow]
inlet = { face = "x-", pressure = "20 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
walls = ["z-", "z+"]
slip = ["y-", "y+"]
[[particles]]
name = "fines"
diameter = "5 um"
[[injection]]
species = "fines"
face = "x-"
volume_fraction = 0.05
[checkpoint]
every = "0.3 s"
[[output]]
kind = "tracks"
every = "1 ms"
[[output]]
kind = "summary"
every = "1 ms"
)";

/// Two round pillars leave a throat of 8 um; the fine is larger, or smaller.
inline const std::string throat_case = R"([run]
end_time = "60 ms"
[geometry]
kind = "cylinders"
source = "pillars.txt"
size = ["40 um", "24 um", "12 um"]
list_unit = "1 um"
periodic_images = false
[grid]
cell_size = "1.3333333333333333 um"
[fluid]
viscosity = "1 mPa s"
[flow]
inlet = { face = "x-", pressure = "10 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
walls = ["z-", "z+"]
slip = ["y-", "y+"]
[[particles]]
source = "fine.csv"
[[output]]
kind = "tracks"
every = "2 ms"
[[output]]
kind = "summary"
every = "2 ms"
)";

class Coupled : public ::testing::Test {
 protected:
  ProgramResult run(const std::string& content, const std::vector<std::string>& more = {},
                    int ranks = 1) const {
    write_file(folder_ / "case.toml", content);
    write_file(folder_ / "pillars.txt", "20 0 8\n20 24 8\n");
    std::vector<std::string> words{PF_BINARY, "run", "case.toml"};
    words.insert(words.end(), more.begin(), more.end());
    return run_on(ranks, folder_, words);
  }
  void place(double diameter) const {
    write_file(folder_ / "fine.csv",
               fmt::format("x_m,y_m,z_m,diameter_m\n8e-6,12.3e-6,6.2e-6,{}\n", diameter));
  }
  [[nodiscard]] std::string summary(const std::string& out = "out") const {
    return read_text(folder_ / (out + "/summary.json"));
  }
  Scratch folder_;
};

}  // namespace porefines::test
