// SPDX-License-Identifier: MPL-2.0
#include "validate/read_cake.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "io/read_table.hpp"

namespace porefines::validate {
namespace {

/// Solid shares along x up to the sieve.
struct Profile {
  std::vector<Real> x, share;
  Real sieve = 0;  ///< [m] where its grains begin
};

Profile profile_at(const io::TextTable& table, Real time) {
  constexpr Real clean = 0.999;
  const std::vector<Real> t = table.numbers("time_s");
  const std::vector<Real> x = table.numbers("x_m");
  const std::vector<Real> retained = table.numbers("retained_fraction");
  const std::vector<Real> suspended = table.numbers("suspended_fraction");
  const std::vector<Real> porosity = table.numbers("porosity_clean");
  Profile out;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (std::abs(t[i] - time) > 1e-9) {
      continue;
    }
    if (porosity[i] < clean) {
      out.sieve = x[i];
      break;
    }
    out.x.push_back(x[i]);
    out.share.push_back(retained[i] + suspended[i]);
  }
  return out;
}

/// [m] NaN where no bin before the sieve is that full.
Real front_of(const Profile& profile) {
  constexpr Real full = 0.35;
  for (std::size_t i = profile.x.size(); i-- > 1;) {
    const Real here = profile.share[i];
    const Real before = profile.share[i - 1];
    if (here >= full && before < full) {
      return profile.x[i] - (here - full) / (here - before) * (profile.x[i] - profile.x[i - 1]);
    }
  }
  return NAN;
}

Real pressure_at(const io::TextTable& series, Real time) {
  const std::vector<Real> t = series.numbers("time_s");
  const std::vector<Real> p = series.numbers("pressure_drop_pa");
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (std::abs(t[i] - time) < 1e-9) {
      return p[i];
    }
  }
  return NAN;
}

}  // namespace

CakeGrowth cake_growth(const std::string& folder, const CakeFeed& feed, Real from, Real until) {
  const io::TextTable retention = io::read_table(folder + "/retention.csv");
  const io::TextTable series = io::read_table(folder + "/series.csv");
  Real sum = 0;
  Real bins = 0;
  std::vector<Real> fronts;
  for (const Real time : {from, until}) {
    const Profile profile = profile_at(retention, time);
    const Real front = front_of(profile);
    fronts.push_back(front);
    for (std::size_t i = 0; i < profile.x.size(); ++i) {
      if (profile.x[i] > front + feed.diameter && profile.x[i] < profile.sieve - feed.diameter) {
        sum += profile.share[i], ++bins;
      }
    }
  }
  CakeGrowth out;
  out.share = bins > 0 ? sum / bins : NAN;
  out.front = (fronts[0] - fronts[1]) / (until - from);
  const Real rise = (pressure_at(series, until) - pressure_at(series, from)) / (until - from);
  out.resistance = rise / (feed.viscosity * feed.velocity * out.front);
  return out;
}

Real kozeny_carman(Real share, Real diameter) {
  const Real pores = 1 - share;
  return 180 * share * share / (pores * pores * pores * diameter * diameter);
}

}  // namespace porefines::validate
