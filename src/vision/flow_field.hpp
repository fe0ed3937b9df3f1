// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include <opencv2/core.hpp>

#include "core/types.hpp"
#include "io/read_fields.hpp"
#include "vision/guide.hpp"

namespace porefines::vision {

/// The velocity of a run and where its grains are.
struct FlowField {
  io::FieldVolume velocity;
  io::FieldVolume solid;  ///< solid_fraction, 1 in grains

  [[nodiscard]] Vec3 low() const { return velocity.origin; }
  [[nodiscard]] Vec3 high() const;
};

/// @throws InputError  the folder holds no fields
[[nodiscard]] FlowField read_flow(const std::string& run_dir);

/// Trilinear between the centres of the cells, constant beyond them [m/s].
[[nodiscard]] Vec3 velocity_at(const FlowField& field, const Vec3& x);

/// Share of grain around a place, as velocity_at.
[[nodiscard]] Real solid_fraction(const FlowField& field, const Vec3& x);

/// More grain than pore there, or outside of the box.
[[nodiscard]] bool is_solid(const FlowField& field, const Vec3& x);

/// Where a tracer is after a time, Runge-Kutta 4 with steps of at most a fifth of a cell.
[[nodiscard]] Vec3 follow_flow(const FlowField& field, Vec3 x, Real time);

/// Nonzero where the middle plane is grain, row 0 at the top, one pixel of this size each.
[[nodiscard]] cv::Mat grain_picture(const FlowField& field, cv::Size size, Real pixel_size);

/// The steps that the flow of a run gives particles; the video's lower left corner is the run's origin.
/// Where the run has depth, velocities are means over it and particles differ from them by 35 %.
[[nodiscard]] Guide guide_of_run(const std::string& run_dir, cv::Size size, Real pixel_size,
                                 Real frame_rate);

}  // namespace porefines::vision
