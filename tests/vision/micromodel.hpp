// SPDX-License-Identifier: MPL-2.0
// A chip whose flow porefines has computed.
#pragma once

#include <string>

#include "cli/run_support.hpp"
#include "core/atomic_file.hpp"
#include "vision/flow_field.hpp"

namespace porefines::vision::test {

/// Generates a micromodel of 640 x 424 um in `folder` and runs the flow through it: folder/run.
inline FlowField computed_flow(const porefines::test::Scratch& folder) {
  using porefines::test::porefines_in;
  auto result = porefines_in(folder.path(), {"generate", "micromodel", "--size", "640 um", "424 um",
                                             "--pixel-size", "4 um", "--porosity", "0.6", "--grain",
                                             "110 um", "--throat", "28 um", "-o", "chip.png"});
  write_file(folder / "chip.toml",
             "[geometry]\nsource = \"chip.png\"\npixel_size = \"4 um\"\ndepth = \"40 um\"\n"
             "[grid]\ncell_size = \"4 um\"\n"
             "[flow]\ninlet = { face = \"x-\", pressure = \"20 Pa\" }\n"
             "outlet = { face = \"x+\", pressure = \"0 Pa\" }\n"
             "walls = [\"z-\", \"z+\"]\nslip = [\"y-\", \"y+\"]\n"
             "[[output]]\nkind = \"fields\"\n");
  result = porefines_in(folder.path(), {"run", "chip.toml", "-o", "run"});
  EXPECT_EQ(result.exit_code, 0) << result.output;
  return read_flow(folder / "run");
}

/// Mean speed over the pores of the middle plane [m/s].
inline Real mean_speed(const FlowField& field) {
  Real sum = 0;
  Real count = 0;
  const Vec3 low = field.low();
  const Vec3 size = field.high() - low;
  for (int j = 0; j < 100; ++j) {
    for (int i = 0; i < 150; ++i) {
      const Vec3 x = low + Vec3{size.x * (i + 0.5) / 150, size.y * (j + 0.5) / 100, 0.5 * size.z};
      if (!is_solid(field, x)) {
        sum += norm(velocity_at(field, x));
        count += 1;
      }
    }
  }
  return sum / count;
}

}  // namespace porefines::vision::test
