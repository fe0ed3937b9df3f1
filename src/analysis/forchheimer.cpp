// SPDX-License-Identifier: MPL-2.0
#include "analysis/forchheimer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "analysis/least_squares.hpp"
#include "core/error.hpp"

namespace porefines::analysis {
namespace {

constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
constexpr std::size_t least_points = 3;

/// mu U/(dp/L), relative to which laws are written: the permeability that a point seems to have.
Real apparent(const SweepPoint& q, const SweepFluid& fluid) {
  return fluid.viscosity * q.velocity / q.gradient;
}

void check(const std::vector<SweepPoint>& points) {
  for (const SweepPoint& q : points) {
    if (!(q.velocity > 0) || !(q.gradient > 0)) {
      throw InputError(
          fmt::format("a point of the sweep has velocity {:.4g} m/s at {:.4g} Pa/m\n"
                      "all must flow along their gradient",
                      q.velocity, q.gradient));
    }
  }
}

/// Points up to the first one with so much excess.
std::size_t count_below(Real excess, const std::vector<SweepPoint>& points, const SweepFluid& fluid,
                        Real k) {
  std::size_t count = 0;
  while (count < points.size() && k / apparent(points[count], fluid) - 1 < excess) {
    ++count;
  }
  return count;
}

/// Those that k, c and m are taken from.
std::size_t count_slow(const std::vector<SweepPoint>& points, const SweepFluid& fluid, Real k) {
  const std::size_t count = count_below(slow_excess, points, fluid, k);
  return count > least_points ? count : count_below(darcy_excess, points, fluid, k);
}

/// k, c and m of the slow points.
void fit_slow(InertiaFit& fit, const SweepFluid& fluid, std::size_t count) {
  const Real k = fit.permeability.value;
  const Real fastest = fit.points[count - 1].velocity;
  const bool free = count > least_points;
  const auto law = [&](const std::vector<Real>& p, Real velocity) {
    return p[0] + p[1] * std::pow(velocity / fastest, free ? p[2] : 2);
  };
  std::vector<Real> start{1, std::max(k / apparent(fit.points[count - 1], fluid) - 1, 1e-4)};
  if (free) {
    start.push_back(2);
  }
  const LeastSquares found = least_squares(
      [&](const std::vector<Real>& p) {
        std::vector<Real> out;
        for (std::size_t i = 0; i < count; ++i) {
          const SweepPoint& q = fit.points[i];
          out.push_back(law(p, q.velocity) * apparent(q, fluid) / k - 1);
        }
        return out;
      },
      start);
  const Real inverse = found.parameters[0];
  fit.permeability = {k / inverse, k / inverse * found.deviations[0] / inverse};
  fit.exponent = free ? Measured{found.parameters[2], found.deviations[2]} : Measured{2, none};
  const Real root = fluid.density * std::sqrt(fit.permeability.value) / fluid.viscosity;
  fit.c = found.parameters[1] / inverse * std::pow(fastest * root, -fit.exponent.value);
}

/// k_F and beta of the others.
void fit_fast(InertiaFit& fit, const SweepFluid& fluid, std::size_t first) {
  fit.forchheimer_permeability = fit.beta = {none, none};
  if (fit.points.size() < first + least_points) {
    return;
  }
  const Real k = fit.permeability.value;
  const Real fastest = fit.points.back().velocity;
  const LeastSquares found = least_squares(
      [&](const std::vector<Real>& p) {
        std::vector<Real> out;
        for (std::size_t i = first; i < fit.points.size(); ++i) {
          const SweepPoint& q = fit.points[i];
          out.push_back((p[0] + p[1] * q.velocity / fastest) * apparent(q, fluid) / k - 1);
        }
        return out;
      },
      {1, 1});
  const Real inverse = found.parameters[0];
  const Real unit = fluid.viscosity / (k * fluid.density * fastest);
  fit.forchheimer_permeability = {k / inverse, k / inverse * found.deviations[0] / inverse};
  fit.beta = {found.parameters[1] * unit, found.deviations[1] * unit};
}

/// Between the last point below 5 % and the first one above, along a power law.
Real find_end(const InertiaFit& fit, std::size_t below) {
  if (below == 0 || below == fit.points.size() || fit.excess[below - 1] <= 0) {
    return none;
  }
  const Real low = std::log(fit.excess[below - 1]);
  const Real high = std::log(fit.excess[below]);
  const Real share = (std::log(darcy_excess) - low) / (high - low);
  return fit.points[below - 1].velocity *
         std::pow(fit.points[below].velocity / fit.points[below - 1].velocity, share);
}

}  // namespace

Real slow_gradient(const InertiaFit& fit, const SweepFluid& fluid, Real velocity) {
  const Real k = fit.permeability.value;
  const Real reynolds = fluid.density * velocity * std::sqrt(k) / fluid.viscosity;
  return fluid.viscosity * velocity / k * (1 + fit.c * std::pow(reynolds, fit.exponent.value));
}

Real fast_gradient(const InertiaFit& fit, const SweepFluid& fluid, Real velocity) {
  return fluid.viscosity * velocity / fit.forchheimer_permeability.value +
         fit.beta.value * fluid.density * velocity * velocity;
}

InertiaFit fit_inertia(std::vector<SweepPoint> points, const SweepFluid& fluid) {
  constexpr int rounds = 3;  // which points are slow depends on k
  check(points);
  const auto slower = [](const SweepPoint& a, const SweepPoint& b) {
    return a.velocity < b.velocity;
  };
  std::sort(points.begin(), points.end(), slower);
  InertiaFit fit{};
  fit.points = std::move(points);
  std::size_t slow = 0;
  for (int round = 0; round < rounds; ++round) {
    const Real k = round == 0 && !fit.points.empty() ? apparent(fit.points.front(), fluid)
                                                     : fit.permeability.value;
    slow = count_slow(fit.points, fluid, k);
    if (slow < least_points) {
      throw InputError(
          fmt::format("{} of {} points are less than {:.0f} % above Darcy's law, 3 are needed\n"
                      "let the sweep start at a tenth of its smallest gradient",
                      slow, fit.points.size(), 100 * darcy_excess));
    }
    fit.permeability.value = k;
    fit_slow(fit, fluid, slow);
  }
  const Real root = fluid.density * std::sqrt(fit.permeability.value) / fluid.viscosity;
  for (const SweepPoint& q : fit.points) {
    fit.reynolds.push_back(q.velocity * root);
    fit.excess.push_back(fit.permeability.value / apparent(q, fluid) - 1);
  }
  const std::size_t below = count_below(darcy_excess, fit.points, fluid, fit.permeability.value);
  fit.slow = static_cast<int>(slow);
  fit.fast = static_cast<int>(fit.points.size() - below);
  fit_fast(fit, fluid, below);
  fit.darcy_end = find_end(fit, below);
  fit.darcy_end_reynolds = fit.darcy_end * root;
  return fit;
}

}  // namespace porefines::analysis
