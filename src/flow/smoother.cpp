// SPDX-License-Identifier: MPL-2.0
#include "flow/smoother.hpp"

#include <algorithm>
#include <span>

#include "flow/kernels.hpp"

namespace porefines::flow {

namespace {

constexpr float pressure_step = 1.2F;  ///< over-relaxation of the pressure in a push

/// One stage of a wave: what it does to rows of a plane, how far behind the first stage it runs
/// (in planes and in rows), and which planes and rows it covers.
template <typename Work>
struct Stage {
  int lag;
  RowRange planes;
  RowRange rows;
  Work work;
};

/// Indices covered along an axis: `margin` layers beyond the block where it has neighbours.
RowRange reach(const grid::Block& b, int axis, int margin, bool faces) {
  const int m = b.ghost[axis] > 1 ? margin : 0;
  return {-m, b.n[axis] + m + (faces ? 1 : 0)};
}

/// Rows per tile such that the planes in flight stay in the second-level cache.
int tile_rows(const grid::Block& b, int lags) {
  constexpr double cache = 1.2e6;  // bytes, of the 2 MB that cores have today
  constexpr double bytes_per_cell = 15 * sizeof(float);
  const double rows = cache / (bytes_per_cell * (lags + 2) * static_cast<double>(b.sy));
  return std::max(8, static_cast<int>(rows));
}

template <typename... Works>
void run_wave(const grid::Block& b, const Stage<Works>&... stages) {
  const int lags = std::max({stages.lag...});
  const int first_plane = std::min({stages.planes.first...});
  const int last_plane = std::max({(stages.planes.last + stages.lag)...});
  const int first_row = std::min({stages.rows.first...});
  const int last_row = std::max({(stages.rows.last + stages.lag)...});
  const int rows = tile_rows(b, lags);
  for (int tile = first_row; tile < last_row; tile += rows) {
    for (int plane = first_plane; plane < last_plane; ++plane) {
      const auto advance = [&](const auto& stage) {
        const int k = plane - stage.lag;
        if (k < stage.planes.first || k >= stage.planes.last) {
          return;
        }
        const RowRange range{std::max(tile - stage.lag, stage.rows.first),
                             std::min(tile + rows - stage.lag, stage.rows.last)};
        if (range.first < range.last) {
          stage.work(k, range);
        }
      };
      (advance(stages), ...);
    }
  }
}

}  // namespace

void sweep(Level& level, bool reversed, bool from_zero) {
  if (!from_zero) {
    level.exchange_unknowns(sweep_depth);
  }
  const int first = reversed ? 1 : 0;
  const int second = 1 - first;
  const grid::Block& b = level.block;
  const auto velocity = [&](int lag, int margin, int colour) {
    const auto work = [&level, colour](int k, RowRange rows) {
      relax_velocity(level, k, rows, colour);
    };
    return Stage<decltype(work)>{lag, reach(b, 2, margin, true), reach(b, 1, margin, true), work};
  };
  const auto push = [&](int lag, int margin, int colour) {
    const auto work = [&level, colour](int k, RowRange rows) {
      push_pressure(level, k, rows, colour, pressure_step);
    };
    return Stage<decltype(work)>{lag, reach(b, 2, margin, false), reach(b, 1, margin, false), work};
  };
  // A push moves faces one row and one plane ahead of it, so it stays two behind the relaxation.
  run_wave(b, velocity(0, 3, first), velocity(1, 2, second), push(3, 2, first), push(4, 1, second));
}

void relax_mobility(Level& level, int component, int count, float omega) {
  const grid::Block& b = level.block;
  float* const field = level.u[component].data();
  for (int s = 0; s < count; ++s) {
    level.halo.exchange(std::span<float* const>(&field, 1), 2);
    const auto stage = [&](int lag, int margin, int colour) {
      const auto work = [&level, component, colour, omega](int k, RowRange rows) {
        relax_component(level, component, k, rows, colour, omega);
      };
      return Stage<decltype(work)>{lag, reach(b, 2, margin, true), reach(b, 1, margin, true), work};
    };
    run_wave(b, stage(0, 1, 0), stage(1, 0, 1));
  }
}

void find_residual(Level& level) {
  level.exchange_unknowns(2);
  const RowRange planes = reach(level.block, 2, 1, true);
  const RowRange rows = reach(level.block, 1, 1, true);
  for (int k = planes.first; k < planes.last; ++k) {
    find_residual(level, k, rows);
  }
}

}  // namespace porefines::flow
