// SPDX-License-Identifier: MPL-2.0
#pragma once

#include "config/case.hpp"
#include "config/tree.hpp"

/// The parts of validate(). All throw an InputError.
namespace porefines::config {

/// Each axis is either periodic or has openings, walls and slip faces; no face is two things.
void check_faces(const Flow& flow, const Node& given);

/// Exactly one thing drives the flow: a gradient along a periodic axis, or an inlet and an outlet
/// of which one has a pressure.
void check_drive(const Flow& flow, const Node& given);

/// [[drive]] is for creeping flows with particles, its times rise, and something always drives.
void check_drive_changes(const Case& subject, const Node& given);

/// Species, injections, walls and the faces of the box, each by itself.
void check_particles(const Case& subject, const Node& given);

/// That the files named in them exist.
void check_particle_files(const Case& subject, const Node& given);

/// Particles without a flow: what is needed and what has no meaning.
void check_dry(const Case& subject, const Node& given);

/// Particles in a flow: what is needed and what has no meaning.
void check_coupled(const Case& subject, const Node& given);

/// A flow with inertia: what is needed and what has no meaning; or keys of one in another regime.
void check_inertial(const Case& subject, const Node& given);

/// A steady flow: what only particles would need.
void check_steady(const Case& subject, const Node& given);

}  // namespace porefines::config
