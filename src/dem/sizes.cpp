// SPDX-License-Identifier: MPL-2.0
#include "dem/sizes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace porefines::dem {
namespace {

Real cube(Real x) {
  return x * x * x;
}

/// Draws within the cuts; where the law is one of volume, smaller ones are more numerous.
template <typename Draw>
Real draw_cut(const Sizes& sizes, Draws& draws, const Draw& draw) {
  for (;;) {
    const Real d = draw();
    if (d < sizes.smallest || d > sizes.largest) {
      continue;
    }
    if (!sizes.by_volume || draws.uniform() * cube(d) < cube(sizes.smallest)) {
      return d;
    }
  }
}

/// Mean of d^power where f(d) is proportional to the number of particles: Simpson's rule in ln d.
template <typename Density>
Real integrate(const Sizes& sizes, int power, const Density& density) {
  constexpr int panels = 2000;
  const Real from = std::log(sizes.smallest);
  const Real width = (std::log(sizes.largest) - from) / panels;
  Real sum = 0;
  Real weights = 0;
  for (int i = 0; i <= panels; ++i) {
    const Real d = std::exp(from + i * width);
    const Real simpson = i == 0 || i == panels ? 1 : i % 2 == 1 ? 4 : 2;
    const Real number = sizes.by_volume ? density(d) / cube(d / sizes.mean) : density(d);
    sum += simpson * number * d * std::pow(d, power);
    weights += simpson * number * d;
  }
  return sum / weights;
}

struct Draw {
  const Sizes& sizes;
  Draws& draws;

  Real operator()(const Mono&) const { return sizes.mean; }
  Real operator()(const NormalLaw& law) const {
    return draw_cut(sizes, draws, [&] { return sizes.mean + law.deviation * draws.normal(); });
  }
  Real operator()(const LognormalLaw& law) const {
    const auto [m, s] = lognormal_parameters(sizes.mean, law.deviation);
    const Real middle = sizes.by_volume ? m - 3 * s * s : m;  // then nothing is left to reject
    for (;;) {
      const Real d = std::exp(middle + s * draws.normal());
      if (d >= sizes.smallest && d <= sizes.largest) {
        return d;
      }
    }
  }
  Real operator()(const TableLaw& law) const {
    const auto number = [&](std::size_t i) {
      return sizes.by_volume ? law.share[i] / cube(law.diameter[i]) : law.share[i];
    };
    Real total = 0;
    for (std::size_t i = 0; i < law.share.size(); ++i) {
      total += number(i);
    }
    Real left = draws.uniform() * total;
    std::size_t i = 0;
    while (i + 1 < law.share.size() && left >= number(i)) {
      left -= number(i++);
    }
    return law.diameter[i];
  }
};

struct MeanPower {
  const Sizes& sizes;
  int power;

  Real operator()(const Mono&) const { return std::pow(sizes.mean, power); }
  Real operator()(const NormalLaw& law) const {
    return integrate(sizes, power, [&](Real d) {
      return std::exp(-0.5 * std::pow((d - sizes.mean) / law.deviation, 2));
    });
  }
  Real operator()(const LognormalLaw& law) const {
    const auto [m, s] = lognormal_parameters(sizes.mean, law.deviation);
    return integrate(sizes, power, [m = m, s = s](Real d) {
      return std::exp(-0.5 * std::pow((std::log(d) - m) / s, 2)) / d;
    });
  }
  Real operator()(const TableLaw& law) const {
    Real sum = 0;
    Real weights = 0;
    for (std::size_t i = 0; i < law.share.size(); ++i) {
      const Real number = sizes.by_volume ? law.share[i] / cube(law.diameter[i]) : law.share[i];
      sum += number * std::pow(law.diameter[i], power);
      weights += number;
    }
    return sum / weights;
  }
};

}  // namespace

Real draw_diameter(const Sizes& sizes, Draws& draws) {
  return std::visit(Draw{sizes, draws}, sizes.law);
}

Real mean_power(const Sizes& sizes, int power) {
  return std::visit(MeanPower{sizes, power}, sizes.law);
}

Real mean_volume(const Sizes& sizes) {
  return std::numbers::pi / 6 * mean_power(sizes, 3);
}

Real smallest_diameter(const Sizes& sizes) {
  if (const auto* table = std::get_if<TableLaw>(&sizes.law)) {
    return *std::min_element(table->diameter.begin(), table->diameter.end());
  }
  return std::holds_alternative<Mono>(sizes.law) ? sizes.mean : sizes.smallest;
}

Real largest_diameter(const Sizes& sizes) {
  if (const auto* table = std::get_if<TableLaw>(&sizes.law)) {
    return *std::max_element(table->diameter.begin(), table->diameter.end());
  }
  return std::holds_alternative<Mono>(sizes.law) ? sizes.mean : sizes.largest;
}

}  // namespace porefines::dem
