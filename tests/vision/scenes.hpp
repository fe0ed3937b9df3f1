// SPDX-License-Identifier: MPL-2.0
// Particles for the synthetic microscope.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"
#include "vision/guide.hpp"
#include "vision/measures.hpp"
#include "vision/microscope.hpp"

namespace porefines::vision::test {

inline std::vector<Seen> random_particles(const Microscope& m, int count, std::uint64_t id,
                                          Real diameter = 4) {
  Draws draws(11, Stream::place, id);
  std::vector<Seen> out;
  for (int i = 0; i < count; ++i) {
    const Real x = draws.uniform(0, m.width - 1.0);
    const Real y = draws.uniform(0, m.height - 1.0);
    out.push_back({x, y, 0, diameter});
  }
  return out;
}

/// Moving points and their true paths; what leaves the frame comes back as another particle.
struct Walkers {
  std::vector<Spots> frames;  ///< sorted by y
  std::vector<Path> truth;
};

/// @param move(at, walker, draws)  the place one frame later
template <typename Move>
Walkers walk(cv::Size size, int count, int frames, const Move& move) {
  Walkers out;
  Draws draws(4, Stream::motion, 1);
  struct Walker {
    cv::Point2d at;
    cv::Point2d own;  ///< two uniform numbers of its own
    Path path;
  };
  const auto born = [&](cv::Point2d at) {
    return Walker{at, {draws.uniform(), draws.uniform()}, {}};
  };
  const auto anywhere = [&] {
    const Real x = draws.uniform(0, size.width - 1.0);
    return cv::Point2d(x, draws.uniform(0, size.height - 1.0));
  };
  std::vector<Walker> walkers;
  for (int i = 0; i < count; ++i) {
    walkers.push_back(born(anywhere()));
  }
  for (int f = 0; f < frames; ++f) {
    Spots spots;
    for (Walker& w : walkers) {
      spots.push_back({w.at.x, w.at.y, 1, 1});
      w.path.push_back({f, w.at.x, w.at.y});
      w.at = move(w.at, w.own, draws);
      const bool inside =
          w.at.x >= 0 && w.at.y >= 0 && w.at.x <= size.width - 1 && w.at.y <= size.height - 1;
      if (!inside) {
        out.truth.push_back(w.path);
        // What leaves on one side enters on the other, at another height.
        cv::Point2d at(std::fmod(w.at.x + size.width, size.width),
                       std::fmod(w.at.y + size.height, size.height));
        w = born(at);
      }
    }
    std::sort(spots.begin(), spots.end(),
              [](const Spot& a, const Spot& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    out.frames.push_back(spots);
  }
  for (Walker& w : walkers) {
    if (!w.path.empty()) {
      out.truth.push_back(w.path);
    }
  }
  std::erase_if(out.truth, [](const Path& p) { return p.size() < 3; });
  return out;
}

/// Straight lines in random directions, up to `share` of the spacing a frame, a little noise.
inline Walkers persistent_walkers(cv::Size size, int count, int frames, Real share) {
  const Real gap = std::sqrt(static_cast<Real>(size.area()) / count);
  return walk(size, count, frames, [=](cv::Point2d at, cv::Point2d own, Draws& draws) {
    const Real angle = 2 * std::numbers::pi * own.x;
    const Real step = share * gap * own.y;
    const Real nx = draws.normal();
    return at + step * cv::Point2d(std::cos(angle), std::sin(angle)) +
           0.3 * cv::Point2d(nx, draws.normal());
  });
}

inline Walkers brownian_walkers(cv::Size size, int count, int frames, Real share) {
  const Real gap = std::sqrt(static_cast<Real>(size.area()) / count);
  return walk(size, count, frames, [=](cv::Point2d at, cv::Point2d, Draws& draws) {
    const Real nx = draws.normal();
    return at + share * gap * std::sqrt(0.5) * cv::Point2d(nx, draws.normal());
  });
}

/// A sheared stream that winds; the fastest step is 1.5 times the mean, which is `share` of the
/// spacing. Particles have paces from 0.7 to 1.
inline Walkers flow_walkers(cv::Size size, int count, int frames, Real share) {
  const Real gap = std::sqrt(static_cast<Real>(size.area()) / count);
  return walk(size, count, frames, [=](cv::Point2d at, cv::Point2d own, Draws&) {
    constexpr int substeps = 20;
    const Real pace = 0.7 + 0.3 * own.x;
    for (int k = 0; k < substeps; ++k) {
      const Real y = at.y / size.height;
      const Real speed = share * gap * (0.5 + 4 * y * (1 - y));
      const Real slope = 0.6 * std::cos(2 * std::numbers::pi * at.x / 160);
      at += pace / substeps * speed / std::hypot(1, slope) * cv::Point2d(1, slope);
    }
    return at;
  });
}

}  // namespace porefines::vision::test
