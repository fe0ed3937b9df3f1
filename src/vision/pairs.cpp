// SPDX-License-Identifier: MPL-2.0
#include "vision/pairs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "vision/levenberg_marquardt.hpp"

namespace porefines::vision {
namespace {

constexpr std::size_t unknowns = 7;  // x1, y1, a1, x2, y2, a2, b
using Vector = SmallVector<unknowns>;
using Equations = NormalEquations<unknowns>;

/// A pixel with the light that neighbours leave.
struct Sample {
  Real x;
  Real y;
  Real light;
};

Real width_of(const Spot& s) {
  return std::sqrt(s.mass / (2 * std::numbers::pi * s.peak));
}

template <typename Value>
Real median_of(const std::vector<Spot>& spots, const Value& value) {
  std::vector<Real> all;
  for (const Spot& s : spots) {
    all.push_back(value(s));
  }
  const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
  std::nth_element(all.begin(), middle, all.end());
  return *middle;
}

std::vector<Sample> samples_around(const cv::Mat& light, const std::vector<Spot>& spots,
                                   std::size_t k, int radius) {
  std::vector<Sample> out;
  const auto x = static_cast<int>(std::lround(spots[k].x));
  const auto y = static_cast<int>(std::lround(spots[k].y));
  for (int j = std::max(y - radius, 0); j <= std::min(y + radius, light.rows - 1); ++j) {
    for (int i = std::max(x - radius, 0); i <= std::min(x + radius, light.cols - 1); ++i) {
      if ((i - x) * (i - x) + (j - y) * (j - y) <= radius * (radius + 1)) {
        out.push_back({static_cast<Real>(i), static_cast<Real>(j), light.at<float>(j, i)});
      }
    }
  }
  for (std::size_t m = 0; m < spots.size(); ++m) {
    const Spot& s = spots[m];
    const Real dx = s.x - spots[k].x;
    const Real dy = s.y - spots[k].y;
    if (m != k && dx * dx + dy * dy < 9 * radius * radius) {
      const Real w = width_of(s);
      for (Sample& p : out) {
        const Real r2 = (p.x - s.x) * (p.x - s.x) + (p.y - s.y) * (p.y - s.y);
        p.light -= s.peak * std::exp(-0.5 * r2 / (w * w));
      }
    }
  }
  return out;
}

/// Normal equations at v.
void set(const std::vector<Sample>& samples, const Vector& v, Real width, Equations& e) {
  e = {};
  const Real w2 = width * width;
  for (const Sample& p : samples) {
    Vector slope{};
    Real rest = p.light - v[6];
    slope[6] = 1;
    for (std::size_t g = 0; g < 6; g += 3) {
      const Real dx = p.x - v[g];
      const Real dy = p.y - v[g + 1];
      const Real shape = std::exp(-0.5 * (dx * dx + dy * dy) / w2);
      slope[g] = v[g + 2] * shape * dx / w2;
      slope[g + 1] = v[g + 2] * shape * dy / w2;
      slope[g + 2] = shape;
      rest -= v[g + 2] * shape;
    }
    e.squares += rest * rest;
    for (std::size_t r = 0; r < unknowns; ++r) {
      e.b[r] += slope[r] * rest;
      for (std::size_t c = 0; c < unknowns; ++c) {
        e.a[r][c] += slope[r] * slope[c];
      }
    }
  }
}

/// Two equal Gaussians on the long axis of the light above its darkest pixel.
Vector start_of(const std::vector<Sample>& samples, const Spot& spot, Real width) {
  const Real base =
      std::min_element(samples.begin(), samples.end(), [](const auto& p, const auto& q) {
        return p.light < q.light;
      })->light;
  Real sum = 0;
  Real xx = 0;
  Real xy = 0;
  Real yy = 0;
  for (const Sample& p : samples) {
    const Real w = p.light - base;
    sum += w;
    xx += w * (p.x - spot.x) * (p.x - spot.x);
    xy += w * (p.x - spot.x) * (p.y - spot.y);
    yy += w * (p.y - spot.y) * (p.y - spot.y);
  }
  const Real angle = 0.5 * std::atan2(2 * xy, xx - yy);
  const Real longer = std::hypot(xx - yy, 2 * xy) / std::max(sum, 1e-9);
  const Real half = std::clamp(std::sqrt(longer), 0.6 * width, 1.5 * width);
  const Real dx = half * std::cos(angle);
  const Real dy = half * std::sin(angle);
  const Real height = 0.7 * spot.peak;
  return {spot.x - dx, spot.y - dy, height, spot.x + dx, spot.y + dy, height, base};
}

/// Levenberg-Marquardt from v on; @return the sum of squares reached.
Real fit(const std::vector<Sample>& samples, Vector& v, Real width) {
  constexpr int most_steps = 25;
  Equations here;
  Equations there;
  descend(
      v, here, there, most_steps,
      [&](const Vector& at, Equations& e) { set(samples, at, width, e); },
      [](const Vector& at, Vector change) {
        for (std::size_t k = 0; k < unknowns; ++k) {
          change[k] += at[k];
        }
        return change;
      },
      [](const Vector&, Real before, Real after) { return before - after < 1e-4 * before; });
  return here.squares;
}

/// What one Gaussian of its own width leaves, with the best base and height.
Real squares_of_one(const std::vector<Sample>& samples, const Spot& spot) {
  const Real w2 = width_of(spot) * width_of(spot);
  Real n = 0;
  Real e = 0;
  Real ee = 0;
  Real l = 0;
  Real le = 0;
  Real ll = 0;
  for (const Sample& p : samples) {
    const Real r2 = (p.x - spot.x) * (p.x - spot.x) + (p.y - spot.y) * (p.y - spot.y);
    const Real shape = std::exp(-0.5 * r2 / w2);
    n += 1;
    e += shape;
    ee += shape * shape;
    l += p.light;
    le += p.light * shape;
    ll += p.light * p.light;
  }
  const Real variance = ee - e * e / n;
  const Real covariance = le - l * e / n;
  return ll - l * l / n - covariance * covariance / std::max(variance, 1e-9);
}

}  // namespace

void split_pairs(const cv::Mat& light, std::vector<Spot>& spots, int diameter) {
  constexpr std::size_t enough = 8;  // for a median
  if (spots.size() < enough) {
    return;
  }
  const Real mass = median_of(spots, [](const Spot& s) { return s.mass; });
  const Real height = median_of(spots, [](const Spot& s) { return s.peak; });
  const Real width = median_of(spots, width_of);
  constexpr Real heavy = 1.6;
  constexpr Real real_height = 0.4;
  constexpr Real better = 0.5;
  std::vector<Spot> seconds;
  for (std::size_t k = 0; k < spots.size(); ++k) {
    if (spots[k].mass < heavy * mass) {
      continue;
    }
    const auto samples = samples_around(light, spots, k, diameter / 2 + 2);
    Vector v = start_of(samples, spots[k], width);
    const bool pays = fit(samples, v, width) < better * squares_of_one(samples, spots[k]);
    const Real far = std::max(std::hypot(v[0] - spots[k].x, v[1] - spots[k].y),
                              std::hypot(v[3] - spots[k].x, v[4] - spots[k].y));
    if (pays && std::min(v[2], v[5]) > real_height * height && far < diameter &&
        std::hypot(v[0] - v[3], v[1] - v[4]) > width) {
      const Real light_of_unit = 2 * std::numbers::pi * width * width;
      spots[k] = {v[0], v[1], light_of_unit * v[2], v[2]};
      seconds.push_back({v[3], v[4], light_of_unit * v[5], v[5]});
    }
  }
  spots.insert(spots.end(), seconds.begin(), seconds.end());
  std::sort(spots.begin(), spots.end(),
            [](const Spot& a, const Spot& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
}

}  // namespace porefines::vision
