// SPDX-License-Identifier: MPL-2.0
#include "analysis/deep_bed.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/least_squares.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace porefines::analysis {
namespace {

/// The three kinds of data.
enum Kind { retention, breakthrough, resistance, kinds };

/// A measured number and where it belongs.
struct Point {
  Kind kind;
  Real x;  ///< [m] retention
  Real volumes;
  Real value;
};

std::vector<Point> points_of(const BedData& data) {
  std::vector<Point> points;
  for (std::size_t i = 0; i < data.x.size(); ++i) {
    points.push_back({retention, data.x[i], data.profile_at, data.s[i]});
  }
  for (std::size_t i = 0; i < data.volumes.size(); ++i) {
    if (std::isfinite(data.concentration[i]) && data.volumes[i] > 1) {
      points.push_back({breakthrough, 0, data.volumes[i], data.concentration[i]});
    }
  }
  for (std::size_t i = 0; i < data.volumes.size(); ++i) {
    if (std::isfinite(data.resistance[i])) {
      points.push_back({resistance, 0, data.volumes[i], data.resistance[i]});
    }
  }
  return points;
}

/// Parameters in scales of order one: lambda L, and beta times the retained share of one pore volume.
Filtration from_scaled(const Bed& bed, const std::vector<Real>& p) {
  return {p[0] / bed.length, p[1] / (bed.porosity * bed.feed)};
}

Real predicted(const Bed& bed, const Filtration& f, const Point& point) {
  switch (point.kind) {
    case retention:
      return retained(bed, f.lambda, point.x, point.volumes);
    case breakthrough:
      return suspended(bed, f.lambda, bed.length, point.volumes) / bed.feed;
    default:
      return resistance_ratio(bed, f, point.volumes);
  }
}

using Scales = std::array<Real, kinds>;

LeastSquares fit_points(const Bed& bed, const std::vector<Point>& points, const Scales& scales,
                        const std::vector<Real>& start) {
  return least_squares(
      [&](const std::vector<Real>& p) {
        const Filtration f = from_scaled(bed, p);
        std::vector<Real> out;
        for (const Point& point : points) {
          out.push_back((predicted(bed, f, point) - point.value) / scales[point.kind]);
        }
        return out;
      },
      start);
}

/// Mean of a kind's values: the scale before anything is known of its scatter.
Scales mean_values(const std::vector<Point>& points) {
  Scales sums{};
  Scales counts{};
  for (const Point& point : points) {
    sums[point.kind] += std::abs(point.value);
    ++counts[point.kind];
  }
  for (std::size_t k = 0; k < kinds; ++k) {
    sums[k] = counts[k] > 0 && sums[k] > 0 ? sums[k] / counts[k] : 1;
  }
  return sums;
}

/// Root mean square of the residuals of each kind.
Scales scatter(const Bed& bed, const std::vector<Point>& points, const Filtration& f) {
  Scales sums{};
  Scales counts{};
  for (const Point& point : points) {
    sums[point.kind] += std::pow(predicted(bed, f, point) - point.value, 2);
    ++counts[point.kind];
  }
  for (std::size_t k = 0; k < kinds; ++k) {
    sums[k] = counts[k] > 0 ? std::sqrt(sums[k] / counts[k]) : 0;
  }
  return sums;
}

/// Residuals of one kind, in the order of their points.
struct Stretch {
  std::size_t first = 0;
  std::vector<Real> residuals = {};
  std::size_t block = 1;
};

/// How long blocks of residuals must be to keep their correlation: (2 r / (1 - r^2))^(2/3) n^(1/3) with r the
/// correlation of neighbours. Source: Carlstein, Ann. Stat. 14 (1986) 1171.
std::size_t block_length(const std::vector<Real>& residuals) {
  Real square = 0;
  Real product = 0;
  for (std::size_t i = 0; i < residuals.size(); ++i) {
    square += residuals[i] * residuals[i];
    product += i > 0 ? residuals[i] * residuals[i - 1] : 0;
  }
  const auto n = static_cast<Real>(residuals.size());
  const Real r = square > 0 ? std::clamp(product / square, 0.0, 0.98) : 0;
  const Real length = std::pow(2 * r / (1 - r * r), 2.0 / 3) * std::cbrt(n);
  return static_cast<std::size_t>(std::clamp(length, 1.0, std::max(1.0, n / 3)));
}

/// Points of a kind stand together.
std::vector<Stretch> stretches(const Bed& bed, const std::vector<Point>& points,
                               const Filtration& f) {
  // residuals of a fit are a little smaller than the noise: two parameters went into it
  const auto all = static_cast<Real>(points.size());
  const Real larger = std::sqrt(all / (all - 2));
  std::vector<Stretch> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i == 0 || points[i].kind != points[i - 1].kind) {
      out.push_back({.first = i});
    }
    out.back().residuals.push_back(larger * (points[i].value - predicted(bed, f, points[i])));
  }
  for (Stretch& stretch : out) {
    stretch.block = block_length(stretch.residuals);
  }
  return out;
}

/// Residuals of each kind are drawn again in blocks and put onto the model.
std::vector<Point> resampled(const Bed& bed, const std::vector<Point>& points, const Filtration& f,
                             const std::vector<Stretch>& noise, Draws& draws) {
  std::vector<Point> out = points;
  for (const Stretch& stretch : noise) {
    const std::size_t n = stretch.residuals.size();
    std::size_t from = 0;
    for (std::size_t i = 0; i < n; ++i) {
      from = i % stretch.block == 0
                 ? static_cast<std::size_t>(draws.uniform() * static_cast<Real>(n))
                 : (from + 1) % n;
      Point& point = out[stretch.first + i];
      point.value = predicted(bed, f, point) + stretch.residuals[from];
    }
  }
  return out;
}

Estimate interval(Real value, std::vector<Real> drawn, Real confidence) {
  std::sort(drawn.begin(), drawn.end());
  const Real tail = 0.5 - confidence / 2;
  return {value, quantile(drawn, tail), quantile(drawn, 1 - tail)};
}

/// lambda L from the share that is retained behind the front: mean retained = phi c0 T (1 - exp(-lambda L)) about.
std::vector<Real> first_guess(const Bed& bed, const BedData& data) {
  const Real mean = std::accumulate(data.s.begin(), data.s.end(), Real{0}) /
                    static_cast<Real>(std::max<std::size_t>(1, data.s.size()));
  const Real share = mean / (bed.porosity * bed.feed * std::max(data.profile_at, 1e-9));
  return {-std::log(1 - std::clamp(share, 0.01, 0.99)), 0.1};
}

void check(const Bed& bed, const BedData& data) {
  const Real all = std::accumulate(data.s.begin(), data.s.end(), Real{0});
  if (data.x.size() < 3 || !(all > 0)) {
    throw InputError(
        "no fines are retained, or the profile has fewer than three bins: there is nothing to fit\n"
        "let the run go on, or set clogging.profile_bins");
  }
  if (!(bed.feed > 0) || !(bed.length > 0) || !(bed.porosity > 0)) {
    throw InputError("the concentration of the feed is not known: nothing was injected");
  }
}

}  // namespace

Real suspended(const Bed& bed, Real lambda, Real x, Real pore_volumes) {
  return pore_volumes > x / bed.length ? bed.feed * std::exp(-lambda * x) : 0;
}

Real retained(const Bed& bed, Real lambda, Real x, Real pore_volumes) {
  const Real since = std::max(0.0, pore_volumes - x / bed.length);
  return lambda * bed.length * bed.porosity * bed.feed * since * std::exp(-lambda * x);
}

Real resistance_ratio(const Bed& bed, const Filtration& f, Real pore_volumes) {
  const Real a = f.lambda * bed.length;
  const Real front = std::min(pore_volumes, 1.0);
  // int_0^m a (T - y) exp(-a y) dy
  const Real passed = std::exp(-a * front);
  const Real integral = std::abs(a) < 1e-8
                            ? a * (pore_volumes * front - front * front / 2)
                            : pore_volumes * (1 - passed) - (1 - passed * (1 + a * front)) / a;
  return 1 + f.beta * bed.porosity * bed.feed * integral;
}

BedFit fit_bed(const Bed& bed, const BedData& data, Real confidence, int resamples,
               std::uint64_t seed) {
  check(bed, data);
  const std::vector<Point> points = points_of(data);
  const Scales means = mean_values(points);
  Scales scales = means;
  LeastSquares best = fit_points(bed, points, scales, first_guess(bed, data));
  constexpr int rounds = 2;
  for (int round = 0; round < rounds; ++round) {
    const Scales now = scatter(bed, points, from_scaled(bed, best.parameters));
    for (std::size_t k = 0; k < kinds; ++k) {
      scales[k] = std::max(now[k], 1e-6 * means[k]);
    }
    best = fit_points(bed, points, scales, best.parameters);
  }
  const Filtration f = from_scaled(bed, best.parameters);
  const std::vector<Stretch> noise = stretches(bed, points, f);
  std::vector<Real> lambdas;
  std::vector<Real> betas;
  Draws draws(seed, Stream::bootstrap, 1);
  for (int i = 0; i < resamples; ++i) {
    const Filtration other = from_scaled(
        bed, fit_points(bed, resampled(bed, points, f, noise, draws), scales, best.parameters)
                 .parameters);
    lambdas.push_back(other.lambda);
    betas.push_back(other.beta);
  }
  const Filtration spread = from_scaled(bed, best.deviations);
  const Scales misfit = scatter(bed, points, f);
  return {interval(f.lambda, lambdas, confidence),
          interval(f.beta, betas, confidence),
          spread.lambda,
          spread.beta,
          misfit[retention] / means[retention],
          misfit[breakthrough] / means[breakthrough],
          misfit[resistance] / means[resistance]};
}

}  // namespace porefines::analysis
