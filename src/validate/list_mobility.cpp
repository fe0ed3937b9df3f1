// SPDX-License-Identifier: MPL-2.0
#include <fmt/format.h>

#include "validate/comparison.hpp"

namespace porefines::validate {
namespace {

/// A solve that no case file can say, see measure.hpp; its result stands where a run's does.
Job solved(const std::string& what, int size, Real at, Real exact = 1) {
  return {.name = fmt::format("{}_{}", what, at),
          .instead = {"validate", "--measure", what, "--size", std::to_string(size), "--at",
                      fmt::format("{}", at), "--exact", fmt::format("{}", exact), "-o", "out"}};
}

struct Known {
  Real at;
  Real factor;
};

/// One number each, by FACTOR of a measurement.
void add_rows(Comparison& c, const std::string& what, const std::string& label, int size,
              std::initializer_list<Known> rows, Real tolerance) {
  for (const Known& known : rows) {
    c.rows.push_back({.label = fmt::format("{} = {}", label, known.at),
                      .x = known.at,
                      .job = c.jobs.size(),
                      .source = FromSummary{"factor"},
                      .reference = known.factor,
                      .tolerance = tolerance});
    c.jobs.push_back(solved(what, size, known.at, known.factor));
  }
}

Comparison towards_wall(int size) {
  Comparison c{
      .name = "towards_wall",
      .title = "A sphere pushed towards a wall",
      .quantity = "drag factor F/(6πμaU)",
      .along = "height of the centre over radius",
      .reference = fmt::format("references.md B1, Brenner 1961; {} cells a diameter", size),
      .logarithmic = true};
  add_rows(c, "wall", "h/a", size,
           {{3.7621957, 1.4128741}, {2.3524096, 1.8374748}, {1.5430806, 3.0360645}}, 0.01);
  add_rows(c, "wall", "h/a", size, {{1.127626, 9.2517628}, {1.0453, 23.679391}}, 0.02);
  return c;
}

Comparison along_wall() {
  Comparison c{.name = "along_wall",
               .title = "A sphere dragged along a wall, held and free in a shear flow",
               .quantity = "over what they would be far from the wall",
               .reference =
                   "references.md B2, Goldman, Cox & Brenner 1967, h/a = 1.5431; 6 cells a "
                   "diameter, the gap is 1.6 cells",
               .jobs = {solved("along_wall", 6, 1.5431)}};
  struct Line {
    const char* label;
    const char* key;
    Real exact;
    Real tolerance;
  };
  for (const Line& line : {Line{"drag along the wall", "drag", 1.5673, 0.01},
                           Line{"force of the shear flow, held", "force", 1.4393, 0.01},
                           Line{"torque of the shear flow, held", "torque", 0.9738, 0.03},
                           Line{"speed in the shear flow, free", "speed", 0.9220, 0.01},
                           Line{"spin in the shear flow, free", "spin", 0.9238, 0.02}}) {
    c.rows.push_back({.label = line.label,
                      .source = FromSummary{line.key},
                      .reference = line.exact,
                      .tolerance = line.tolerance});
  }
  return c;
}

Comparison tube(bool quick) {
  Comparison c{.name = "tube",
               .title = "A free sphere on the axis of a tube",
               .quantity = "speed over the peak of the clean flow",
               .along = "radius of the sphere over that of the tube",
               .reference = "references.md B4, exact to 0.1 %; 8 cells a diameter"};
  add_rows(c, "tube", "a/R", 8, {{0.3, 0.94049}, {0.5, 0.83996}}, 0.02);
  if (!quick) {
    add_rows(c, "tube", "a/R", 8, {{0.1, 0.99334}}, 0.02);
  }
  return c;
}

Comparison pair() {
  Comparison c{.name = "pair",
               .title = "Two spheres that approach each other",
               .quantity = "drag factor F/(6πμaU)",
               .along = "distance of the centres over radius",
               .reference =
                   "references.md B5, Stimson & Jeffery 1926; 6 cells a diameter, mean of "
                   "five directions against the grid (single ones scatter: 1, 1 and 13 %)",
               .logarithmic = true};
  add_rows(c, "approach", "r/a", 6, {{4, 1.59668}, {2.5, 2.77242}}, 0.01);
  add_rows(c, "approach", "r/a", 6, {{2.05, 12.71129}}, 0.02);
  return c;
}

Comparison together() {
  Comparison c{.name = "together",
               .title = "Two spheres that go after each other",
               .quantity = "drag factor F/(6πμaU)",
               .along = "distance of the centres over radius",
               .reference =
                   "references.md B5, Stimson & Jeffery 1926; 6 cells a diameter, mean of five "
                   "directions; periodic images given back (Hasimoto 1959)"};
  add_rows(c, "together", "r/a", 6, {{4, 0.742258}, {2.5, 0.672916}, {2.05, 0.648034}}, 0.01);
  return c;
}

Comparison viscosity(bool quick) {
  Comparison c{.name = "viscosity",
               .title = "What one sphere adds to the viscosity",
               .quantity = "(η/μ − 1)/φ",
               .along = "cells a diameter",
               .reference =
                   "references.md B6, Einstein 1906; stress on the lid of a shear flow, "
                   "4 diameters away"};
  add_rows(c, "intrinsic", "cells a diameter", 6, {{6, 2.5}}, 0.01);
  add_rows(c, "intrinsic", "cells a diameter", 8, {{8, 2.5}}, 0.01);
  if (!quick) {
    add_rows(c, "intrinsic", "cells a diameter", 12, {{12, 2.5}}, 0.01);
  }
  return c;
}

Comparison turning() {
  constexpr Real in_box = 1 / 1.013;  // of unbounded: what walls 4 radii away leave
  Comparison c{.name = "turning",
               .title = "A sphere turned by a torque, and by a shear flow",
               .quantity = "spin over T/(8πμa³), and over half of the shear rate",
               .reference =
                   "references.md B6, in boxes; the torque's with walls 4 radii away, whose "
                   "1.3 % are the limit of fine grids"};
  add_rows(c, "turn", "torque, cells a diameter", 8, {{8, in_box}}, 0.01);
  add_rows(c, "shear", "shear flow, cells a diameter", 6, {{6, 1}}, 0.01);
  return c;
}

}  // namespace

void add_mobility(std::vector<Comparison>& list, bool quick) {
  list.push_back(towards_wall(quick ? 6 : 8));
  list.push_back(along_wall());
  list.push_back(tube(quick));
  list.push_back(pair());
  list.push_back(together());
  list.push_back(viscosity(quick));
  list.push_back(turning());
}

}  // namespace porefines::validate
