// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/case.hpp"
#include "geom/build.hpp"

namespace porefines {

/// What the geometry module needs of a case: [geometry], and from [flow] what lies around the box
/// and along which axis pores must percolate.
[[nodiscard]] geom::Spec geometry_spec(const config::Case& the_case);

/// The face that the fluid flows to: the outlet, else along the largest pressure gradient.
[[nodiscard]] BoxFace flow_direction(const config::Flow& flow);

}  // namespace porefines
