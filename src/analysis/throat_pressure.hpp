// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "geom/pore_network.hpp"
#include "grid/block.hpp"
#include "par/communicator.hpp"

namespace porefines::analysis {

/// Places where the pressure before and behind every throat is read.
///
/// A window of one throat width along the normal, from where the throat ends, one width across; in
/// 2D over the whole depth; points in grains are left out. Points lie half a `spacing` apart at
/// most, at most 8 along each side of a window.
struct PressureProbes {
  std::vector<Vec3> points;          ///< [m]
  std::vector<Vec3> way;             ///< [m] from the throat's centre
  std::vector<std::int32_t> window;  ///< per point: 2 throat, plus 1 on the side ahead
  std::size_t throats = 0;
};

/// @param distance  signed distance to the grains [m]
/// @param spacing   [m] cell edge of the flow
[[nodiscard]] PressureProbes place_probes(const geom::PoreNetwork& network,
                                          const std::function<Real(const Vec3&)>& distance,
                                          Real spacing);

/// Values of cells at points: that of the fluid cell around the point when this rank owns it, else NaN.
struct CellReader {
  std::span<const float> values;  ///< own cells, x fastest
  std::span<const float> fluid;   ///< as values, above 1/2: fluid; empty: all are
  const grid::Block* block = nullptr;
  Vec3 spacing;  ///< [m] cell edges
  Vec3 origin;   ///< [m] of the grid

  [[nodiscard]] Real operator()(const Vec3& x) const;
};

/// Mean pressures at a throat [Pa]; NaN where no point lies in the fluid.
struct ThroatPressure {
  Real behind = 0;
  Real ahead = 0;

  [[nodiscard]] Real drop() const { return behind - ahead; }
};

/// Collective; the same on every rank.
/// @param pressure  at a point of this rank's own cells; NaN elsewhere, and may be NaN inside
///                  particles: every point counts on one rank; see CellReader
/// @param gradient  [Pa/m] mean gradient that a periodic field leaves out
/// Cost O(points), at most 128 per throat in 2D. Test: unit/run_readings (a linear field).
[[nodiscard]] std::vector<ThroatPressure> read_throats(
    const PressureProbes& probes, const std::function<Real(const Vec3&)>& pressure,
    const par::Communicator& comm, const Vec3& gradient = {});

/// throats_pressure.csv: one row per throat and sample.
[[nodiscard]] std::vector<std::string> throat_pressure_columns();
[[nodiscard]] std::string throat_pressure_rows(Real time, Real pore_volumes,
                                               const std::vector<ThroatPressure>& pressures);

}  // namespace porefines::analysis
