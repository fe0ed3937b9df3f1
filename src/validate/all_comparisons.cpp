// SPDX-License-Identifier: MPL-2.0
#include "validate/comparison.hpp"

namespace porefines::validate {

std::vector<Comparison> all_comparisons(bool quick) {
  std::vector<Comparison> list;
  add_permeability(list);
  add_contact(list);
  add_spheres(list);
  add_mobility(list, quick);
  add_chip(list);
  add_microscope(list);
  add_cylinder(list, quick);
  return list;
}

}  // namespace porefines::validate
