// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/case.hpp"
#include "config/tree.hpp"

/// The parts of validate() that concern the flow. All throw an InputError.
namespace porefines::config {

/// Each axis is either periodic or has openings, walls and slip faces; no face is two things.
void check_faces(const Flow& flow, const Node& given);

/// Exactly one thing drives the flow: a gradient along a periodic axis, or an inlet and an outlet
/// of which one has a pressure.
void check_drive(const Flow& flow, const Node& given);

}  // namespace porefines::config
