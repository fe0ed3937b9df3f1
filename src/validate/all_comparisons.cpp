// SPDX-License-Identifier: MPL-2.0
#include "validate/comparison.hpp"

namespace porefines::validate {

std::vector<Comparison> all_comparisons(bool quick, const std::string& data) {
  std::vector<Comparison> list;
  add_permeability(list);
  add_contact(list);
  add_impacts(list);
  add_forces(list);
  add_spheres(list);
  add_mobility(list, quick);
  add_chip(list);
  add_microscope(list);
  add_videos(list, data);
  add_inertia(list, quick);
  add_clogging(list, quick);
  add_cylinder(list, quick);
  return list;
}

}  // namespace porefines::validate
