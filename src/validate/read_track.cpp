// SPDX-License-Identifier: MPL-2.0
#include "validate/read_track.hpp"

#include <algorithm>
#include <cmath>

#include "io/read_table.hpp"

namespace porefines::validate {

Track read_track(const std::string& folder, Index id) {
  Track track;
  io::for_rows(folder + "/tracks.csv", [&](const auto& head, const auto& words) {
    const auto number = [&](const char* name) {
      const int column = head.column(name);
      return column >= 0 ? io::number_of(words[static_cast<std::size_t>(column)]) : NAN;
    };
    if (number("id") == static_cast<Real>(id)) {
      track.time.push_back(number("time_s"));
      track.position.push_back({number("x_m"), number("y_m"), number("z_m")});
      track.velocity.push_back({number("u_m_s"), number("v_m_s"), number("w_m_s")});
    }
  });
  return track;
}

Real peak_fall(const Track& track) {
  Real peak = 0;
  for (const Vec3& v : track.velocity) {
    peak = std::max(peak, -v.z);
  }
  return peak;
}

Real rebound(const Track& track, Real height) {
  Real down = 0;
  Real up = 0;
  for (std::size_t i = 0; i + 1 < track.time.size(); ++i) {
    const Real z = track.position[i].z - height;
    const Real next = track.position[i + 1].z - height;
    if (z * next > 0) {
      continue;
    }
    const Real w = (z * track.velocity[i + 1].z - next * track.velocity[i].z) / (z - next);
    Real& first = w < 0 ? down : up;
    first = first == 0 ? std::abs(w) : first;
  }
  return down > 0 ? up / down : NAN;
}

Phases phases(const Track& front, const Track& rear, Real diameter) {
  Phases found;
  const std::size_t rows = std::min(front.time.size(), rear.time.size());
  for (std::size_t i = 0; i < rows; ++i) {
    const auto apart = [&](std::size_t row) {
      return norm(rear.position[row] - front.position[row]) / diameter;
    };
    const auto note = [&](Real& when, bool now) { when = when == 0 && now ? front.time[i] : when; };
    note(found.drafting, apart(i) < 0.9 * apart(0) && rear.velocity[i].z < front.velocity[i].z);
    note(found.kissing, apart(i) < 1.01);
    note(found.tumbling, rear.position[i].z < front.position[i].z && found.kissing > 0);
  }
  return found;
}

Impact impact_of(const std::vector<Real>& time, const std::vector<Real>& distance,
                 const std::vector<Real>& speed, Real touching, Real mass) {
  Impact found;
  for (std::size_t i = 1; i < time.size(); ++i) {
    const Real overlap = touching - distance[i];
    const Real before = touching - distance[i - 1];
    found.overlap = std::max(found.overlap, overlap);
    found.force =
        std::max(found.force, mass * std::abs(speed[i] - speed[i - 1]) / (time[i] - time[i - 1]));
    const Real deeper = std::max(overlap, before);
    if (deeper > 0) {  // that share of the step in which they touch
      const Real share = std::min(1.0, deeper / std::abs(overlap - before));
      found.duration += (overlap > 0 && before > 0 ? 1 : share) * (time[i] - time[i - 1]);
    }
  }
  return found;
}

}  // namespace porefines::validate
