// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "core/types.hpp"

namespace porefines::analysis {

/// One moment of a run with particles, as plain data of all ranks on one rank; arrays belong to
/// someone else. One entry per particle inside, in rising order of id.
struct RunSample {
  Real time = 0;          ///< [s]
  Real pore_volumes = 0;  ///< injected so far
  Real fluid_speed = 0;   ///< [m/s] mean in the pores: Darcy velocity over porosity
  Index out = 0;          ///< particles that have left through the outlet so far
  std::span<const std::uint64_t> id = {};
  std::span<const Vec3> position = {};     ///< [m] from the low corner of the sample
  std::span<const Vec3> velocity = {};     ///< [m/s]
  std::span<const Real> radius = {};       ///< [m]
  std::span<const Real> wall_gap = {};     ///< [m] from the surface to the nearest fixed solid
  std::span<const Vec3> wall_normal = {};  ///< unit vector from there into the pore; 0: far away
};

/// What is next to a sphere: for RunSample::wall_gap and wall_normal.
struct WallTouch {
  Real gap = 0;
  Vec3 normal;
};

/// From any signed distance (grains, or the smaller of grains and plates), by central differences
/// over a twentieth of the radius.
[[nodiscard]] WallTouch touch_wall(const std::function<Real(const Vec3&)>& signed_distance,
                                   const Vec3& x, Real radius);

/// What a fine is doing: these four are told apart, their shares sum to 1.
enum class Fate : std::uint8_t {
  piping,    ///< moves, or has left through the outlet
  bridging,  ///< part of an arch that clogs a throat
  clogged,   ///< sieved at a throat, or held behind an arch or a sieved one
  resting,   ///< retained, but no throat is clogged by it: attached, settled, in a dead corner
};

[[nodiscard]] const char* name_of(Fate fate);

}  // namespace porefines::analysis
