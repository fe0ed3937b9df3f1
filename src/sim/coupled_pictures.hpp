// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <span>

#include "report/draw_run.hpp"
#include "sim/coupled_readings.hpp"

namespace porefines::sim {

/// What stays the same in all pictures of a run, so that they make a movie.
struct RunCanvas {
  bool chip = false;                        ///< seen from above over the middle plane of the flow
  std::array<Real, 2> range{};              ///< [m/s] of the clean flow
  std::array<report::SliceValues, 3> rock;  ///< else: mean solid fraction along x, y, z; rank 0
};

/// Before the first particle. Collective.
/// @param solid  share of each cell that is grain
[[nodiscard]] RunCanvas make_canvas(const Domain& domain, const geom::Sample& sample,
                                    const flow::StokesSolver::CellFields& clean,
                                    std::span<const float> solid, const grid::Block& block,
                                    const par::Communicator& comm);

/// Fines and clogged throats over grains and, in a chip, the flow. On rank 0; collective.
[[nodiscard]] report::Picture paint_run(const CoupledRun& run, const RunCanvas& canvas,
                                        const Readings& readings, const MomentFields& fields,
                                        std::span<const float> solid, report::FineColour colour);

}  // namespace porefines::sim
