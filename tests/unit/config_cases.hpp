// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

/// Small valid cases to start from.
namespace porefines::test {

inline const std::string box_case = R"([geometry]
kind = "empty"
size = ["1 mm", "1 mm", "1 mm"]

[grid]
cell_size = "50 um"

[flow]
periodic = ["x"]
pressure_gradient = "1 Pa/m"
)";

inline const std::string image_case = R"([geometry]
source = "chip.png"
pixel_size = "2 um"
depth = "20 um"

[grid]
cell_size = "2 um"

[flow]
inlet = { face = "x-", pressure = "12 Pa" }
outlet = { face = "x+", pressure = "0 Pa" }
)";

/// Particles without a fluid.
inline const std::string dry_case = R"(gravity = "9.81 m/s^2"
[run]
end_time = "10 ms"
[geometry]
kind = "empty"
size = ["1 mm", "1 mm", "2 mm"]
[[particles]]
name = "sand"
diameter = "100 um"
count = 20
)";

}  // namespace porefines::test
