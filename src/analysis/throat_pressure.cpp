// SPDX-License-Identifier: MPL-2.0
#include "analysis/throat_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

namespace porefines::analysis {
namespace {

constexpr int most_points = 8;  ///< along a side of a window

/// Offsets of points that fill [-half, half] evenly.
std::vector<Real> spread(Real half, Real spacing) {
  const Real wanted = std::ceil(4 * half / spacing);
  const int count = static_cast<int>(std::clamp<Real>(wanted, 1, most_points));
  std::vector<Real> out;
  for (int i = 0; i < count; ++i) {
    out.push_back(half * ((2 * i + 1.0) / count - 1));
  }
  return out;
}

/// Into the box through periodic faces; unchanged elsewhere.
Vec3 inside(const geom::PoreNetwork& network, Vec3 x) {
  for (int a = 0; a < 3; ++a) {
    const bool wraps = network.periodic[static_cast<std::size_t>(a)] && !(network.flat && a == 2);
    x[a] -= wraps ? network.size[a] * std::floor(x[a] / network.size[a]) : 0;
  }
  return x;
}

/// Is x in the pore and in reach of the window's middle, not in the pore behind a thin wall?
bool sees(const std::function<Real(const Vec3&)>& distance, const Vec3& from, const Vec3& to) {
  constexpr int steps = 8;
  for (int i = 1; i <= steps; ++i) {
    if (distance(from + (static_cast<Real>(i) / steps) * (to - from)) <= 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

PressureProbes place_probes(const geom::PoreNetwork& network,
                            const std::function<Real(const Vec3&)>& distance, Real spacing) {
  PressureProbes probes;
  probes.throats = network.throats.size();
  const auto place = [&](std::size_t t, int side, const Vec3& way) {
    const Vec3& centre = network.throats[t].centre;
    if (sees(distance, centre, centre + way)) {
      probes.points.push_back(inside(network, centre + way));
      probes.way.push_back(way);
      probes.window.push_back(static_cast<std::int32_t>(2 * t) + side);
    }
  };
  for (std::size_t t = 0; t < network.throats.size(); ++t) {
    const geom::Throat& throat = network.throats[t];
    const Vec3 beside = cross(throat.normal, throat.across);
    const Real half = 0.5 * throat.width;
    const auto offsets = spread(half, spacing);
    const auto depths = spread(network.flat ? 0.5 * network.size.z : half, spacing);
    for (const int side : {0, 1}) {
      const Real end = side == 1 ? throat.ahead + half : -throat.behind - half;
      for (const Real along : offsets) {
        for (const Real across : offsets) {
          for (const Real deep : depths) {
            place(t, side, (end + along) * throat.normal + across * throat.across + deep * beside);
          }
        }
      }
    }
  }
  return probes;
}

Real CellReader::operator()(const Vec3& x) const {
  Index at = 0;
  for (int axis = 2; axis >= 0; --axis) {
    const Real cell = std::floor((x[axis] - origin[axis]) / spacing[axis]) - block->start[axis];
    if (!(cell >= 0 && cell < block->n[axis])) {
      return std::nan("");
    }
    at = at * block->n[axis] + static_cast<Index>(cell);
  }
  const auto place = static_cast<std::size_t>(at);
  return fluid.empty() || fluid[place] > 0.5F ? static_cast<Real>(values[place]) : std::nan("");
}

std::vector<ThroatPressure> read_throats(const PressureProbes& probes,
                                         const std::function<Real(const Vec3&)>& pressure,
                                         const par::Communicator& comm, const Vec3& gradient) {
  std::vector<Real> sums(4 * probes.throats, 0);  // per window: sum and count
  for (std::size_t p = 0; p < probes.points.size(); ++p) {
    const Real value = pressure(probes.points[p]);
    if (!std::isnan(value)) {
      const auto at = 2 * static_cast<std::size_t>(probes.window[p]);
      sums[at] += value + dot(gradient, probes.way[p]);
      sums[at + 1] += 1;
    }
  }
  comm.sum(sums);
  std::vector<ThroatPressure> out(probes.throats);
  for (std::size_t t = 0; t < out.size(); ++t) {
    const Real* const s = &sums[4 * t];
    out[t] = {s[1] > 0 ? s[0] / s[1] : std::nan(""), s[3] > 0 ? s[2] / s[3] : std::nan("")};
  }
  return out;
}

std::vector<std::string> throat_pressure_columns() {
  return {"time_s",          "pore_volumes", "throat", "pressure_behind_pa", "pressure_ahead_pa",
          "pressure_drop_pa"};
}

std::string throat_pressure_rows(Real time, Real pore_volumes,
                                 const std::vector<ThroatPressure>& pressures) {
  std::string text;
  for (std::size_t t = 0; t < pressures.size(); ++t) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{:.9g},{:.9g},{:.9g}\n", time, pore_volumes,
                   t, pressures[t].behind, pressures[t].ahead, pressures[t].drop());
  }
  return text;
}

}  // namespace porefines::analysis
