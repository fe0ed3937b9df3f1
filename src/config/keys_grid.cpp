// SPDX-License-Identifier: MPL-2.0
// Keys of the grid, the fluid and the derived numbers of the geometry.
#include "config/key.hpp"

namespace porefines::config {
namespace {

constexpr Real longest = 1e3;  // [m]
constexpr Range some_length{0, longest, true};
constexpr Range counts{1, 1 << 20};
constexpr Range densities{0, 1e5, true};
constexpr Range viscosities{1e-6, 1e3};  // below every gas, above every oil

void read_decomposition(Case& c, const Node& node) {
  c.grid.decomposition.reset();
  if (const auto* text = std::get_if<std::string>(&node.value); text && *text == "auto") {
    return;
  }
  if (!std::holds_alternative<List>(node.value)) {
    fail_wants(node, "\"auto\" or ranks along x, y, z such as [2, 1, 1]");
  }
  c.grid.decomposition = read_int3(node, counts, "[2, 1, 1]");
}

}  // namespace

std::vector<Key> grid_keys() {
  return {
      quantity_key("grid.cell_size", &Case::grid, &Grid::cell_size, kind::length, some_length,
                   "see cells", "edge of a cubic cell"),
      int3_key("grid.cells", &Case::grid, &Grid::cells, counts, "[64, 64, 64]", "see cell_size",
               "cells along x, y, z; either this or cell_size"),
      {"grid.decomposition", "`\"auto\"` or three whole numbers", "ranks along x, y, z",
       read_decomposition,
       [](const Case& c) {
         return c.grid.decomposition ? write_int3(*c.grid.decomposition) : "\"auto\"";
       }},
      quantity_key("fluid.density", &Case::fluid, &Fluid::density, kind::density, densities, "",
                   "mass density"),
      quantity_key("fluid.viscosity", &Case::fluid, &Fluid::viscosity, kind::viscosity, viscosities,
                   "", "dynamic viscosity; water at 20 degrees is the default"),
      quantity_key("fine.diameter", &Case::analysis, &Analysis::fine_diameter, kind::length,
                   some_length, "not asked",
                   "diameter of the fines for o/d and D/d, throat and pore widths over diameter"),
  };
}

}  // namespace porefines::config
