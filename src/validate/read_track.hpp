// SPDX-License-Identifier: MPL-2.0
// What tracks.csv of a run comes to, beyond a column's last value.
#pragma once

#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::validate {

/// Rows of one particle, SI.
struct Track {
  std::vector<Real> time;
  std::vector<Vec3> position;
  std::vector<Vec3> velocity;
};

/// Empty where there is no such particle. @param folder  of the run's output
[[nodiscard]] Track read_track(const std::string& folder, Index id);

/// [m/s] largest |w| on the way down
[[nodiscard]] Real peak_fall(const Track& track);

/// Speed on the way up over the one on the way down, where the centre passes `height` [m] (interpolated); 0 if it never comes
/// back there, NaN if it never came down. Cameras see a tenth of a diameter (Joseph et al. 2001).
[[nodiscard]] Real rebound(const Track& track, Real height);

/// [s] first times at which the rear sphere, faster, has come nearer by a tenth of its first distance, touches (1.01
/// diameters), and has overtaken; 0: never. Gravity along -z.
struct Phases {
  Real drafting = 0, kissing = 0, tumbling = 0;
};
[[nodiscard]] Phases phases(const Track& front, const Track& rear, Real diameter);

/// One impact of a sphere on a plane z = 0 or on its mirror image, from rows every step: largest approach beyond touching
/// [m], largest force [N] by the central difference of the velocity, time in touch [s] (interpolated).
struct Impact {
  Real overlap = 0, force = 0, duration = 0;
};
/// @param touching  [m] distance below which it touches
/// @param mass      [kg]
[[nodiscard]] Impact impact_of(const std::vector<Real>& time, const std::vector<Real>& distance,
                               const std::vector<Real>& speed, Real touching, Real mass);

}  // namespace porefines::validate
