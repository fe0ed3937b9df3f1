// SPDX-License-Identifier: MPL-2.0
#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

/// A window of a chip 20 um deep; the size of its grains is chosen so that it has 2.5 darcy.
Job chip_job(Real cell) {
  return {.name = fmt::format("cell_{}_um", 1e6 * cell),
          .case_text = fmt::format(R"(title = "A chip to the specification, cells of {0} um"
[geometry]
source = "chip.png"
pixel_size = "1 um"
depth = "20 um"
[grid]
cell_size = "{0} um"
[fluid]
density = "998.2 kg/m^3"
viscosity = "1.002 mPa s"
[flow]
inlet = {{ face = "x-", pressure = "12 Pa" }}
outlet = {{ face = "x+", pressure = "0 Pa" }}
walls = ["z-", "z+"]
slip = ["y-", "y+"]
[[output]]
kind = "pictures"
)",
                                   1e6 * cell),
          .generate = {"generate", "micromodel", "--size", "0.6 mm", "0.45 mm", "--pixel-size",
                       "1 um", "--grain", "20.6 um", "--porosity", "0.6", "--throat", "8 um",
                       "--seed", "2021", "-o", "chip.png"}};
}

}  // namespace

void add_chip(std::vector<Comparison>& list) {
  Comparison c{.name = "chip",
               .title = "A chip against its specification (thesis, table 2)",
               .quantity = "darcy, 1",
               .reference =
                   "specification of the chip: 2.5 darcy (2.65 in the thesis's model), porosity "
                   "0.58 (0.62 in the model). The "
                   "chip is generated, its grains chosen for 2.5 darcy: what is checked is that "
                   "the grid does not "
                   "decide the answer"};
  const std::vector<Real> cells{2.5e-6, 2e-6, 1.25e-6};
  for (std::size_t k = 0; k < cells.size(); ++k) {
    c.jobs.push_back(chip_job(cells[k]));
    c.rows.push_back({.label = fmt::format("permeability, cells of {} µm", 1e6 * cells[k]),
                      .job = k,
                      .source = FromSummary{"permeability_darcy"},
                      .reference = 2.5,
                      .tolerance = 0.05});
  }
  c.rows.push_back({.label = "permeability, extrapolated to cells of size 0",
                    .source = Extrapolated{"permeability_darcy", cells},
                    .reference = 2.5,
                    .tolerance = 0.05});
  c.rows.push_back({.label = "porosity",
                    .source = FromSummary{"porosity"},
                    .reference = 0.6,
                    .tolerance = 0.034});  // 0.58 to 0.62
  list.push_back(std::move(c));
}

}  // namespace porefines::validate
