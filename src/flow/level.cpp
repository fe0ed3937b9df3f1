// SPDX-License-Identifier: MPL-2.0
#include "flow/level.hpp"

#include <algorithm>

namespace porefines::flow {

Level::Level(const par::Communicator& comm, const par::Decomposition& cut,
             std::array<std::vector<Real>, 3> cell_widths, const Boundaries& boundaries,
             int ghost_depth, bool finest)
    : decomposition(cut),
      block(grid::make_block(cut, comm.rank(), boundaries.periodic(), ghost_depth)),
      halo(comm, cut, block, boundaries.periodic()),
      widths(std::move(cell_widths)) {
  for (int a = 0; a < 3; ++a) {
    axis[a] = make_axis(block, a, widths[a], boundaries);
  }
  for (Floats3* fields : {&inverse_diagonal, &mobility, &u, &f}) {
    for (Floats& field : *fields) {
      field.assign(block.size, 0.0F);
    }
  }
  for (Floats* field : {&push, &p, &g}) {
    field->assign(block.size, 0.0F);
  }
  lend_sides(finest);
  for (Floats& field : weight) {
    field.assign(finest ? block.size : 0, 0.0F);
  }
}

void Level::lend_sides(bool lend) {
  if (lend == lends_sides) {
    return;
  }
  lends_sides = lend;
  for (Floats* field : {&r[0], &r[1], &r[2], &rg}) {
    *field = lend ? Floats{} : Floats(block.size, 0.0F);
  }
}

std::size_t Level::bytes() const {
  std::size_t values = push.size() + p.size() + g.size() + rg.size();
  for (const Floats3* fields : {&inverse_diagonal, &weight, &mobility, &carry, &u, &f, &r}) {
    for (const Floats& field : *fields) {
      values += field.size();
    }
  }
  return values * sizeof(float) + (lines.x.size() + lines.row_first.size()) * sizeof(int);
}

void Level::exchange_unknowns(int depth) {
  const std::array<float*, 4> fields{u[0].data(), u[1].data(), u[2].data(), p.data()};
  halo.exchange(fields, depth);
}

void Level::exchange_sides(int depth) {
  const std::array<float*, 4> sides{f[0].data(), f[1].data(), f[2].data(), g.data()};
  halo.exchange(sides, depth);
}

namespace {

void find_active_lines(Level& level) {
  const grid::Block& b = level.block;
  level.lines.row_first.clear();
  level.lines.x.clear();
  const auto any = [](const Floats& field, std::ptrdiff_t at) {
    return std::any_of(field.begin() + at, field.begin() + at + grid::line_width,
                       [](float value) { return value != 0; });
  };
  for (int k = -b.ghost[2]; k <= b.n[2] + b.ghost[2]; ++k) {
    for (int j = -b.ghost[1]; j <= b.n[1] + b.ghost[1]; ++j) {
      level.lines.row_first.push_back(static_cast<int>(level.lines.x.size()));
      for (int line = 0; line < b.lines(); ++line) {
        const int i = -b.ghost[0] + line * grid::line_width;
        const std::ptrdiff_t at = b.at(i, j, k);
        if (any(level.inverse_diagonal[0], at) || any(level.inverse_diagonal[1], at) ||
            any(level.inverse_diagonal[2], at) || any(level.push, at)) {
          level.lines.x.push_back(i);
        }
      }
    }
  }
  level.lines.row_first.push_back(static_cast<int>(level.lines.x.size()));
}

/// push of every cell.
void find_push(Level& level) {
  const grid::Block& b = level.block;
  const std::array<int, 3> reach{b.ghost[0], b.ghost[1], b.ghost[2]};
  for (int k = -reach[2]; k < b.n[2] + reach[2]; ++k) {
    for (int j = -reach[1]; j < b.n[1] + reach[1]; ++j) {
      for (int i = -reach[0]; i < b.n[0] + reach[0]; ++i) {
        level.push[b.at(i, j, k)] = push_of(level, {i, j, k});
      }
    }
  }
}

}  // namespace

float push_of(const Level& level, const Int3& cell) {
  const auto& ax = level.axis;
  const std::ptrdiff_t at = level.block.at(cell[0], cell[1], cell[2]);
  const auto face = [&](int a, std::ptrdiff_t where, int i) {
    const float w = level.weighted() ? level.weight[a][where] : 1.0F;
    return w * w * level.inverse_diagonal[a][where] * ax[a].gradient[i + ax[a].offset];
  };
  float sum = 0;
  for (int a = 0; a < 3; ++a) {
    sum += ax[a].divergence[cell[a] + ax[a].offset] *
           (face(a, at, cell[a]) + face(a, at + level.block.stride(a), cell[a] + 1));
  }
  return sum > 0 ? 1 / sum : 0.0F;
}

void finish_level(Level& level) {
  for (int c = 0; c < 3; ++c) {
    level.flows[c] = std::any_of(level.inverse_diagonal[c].begin(), level.inverse_diagonal[c].end(),
                                 [](float d) { return d != 0; });
  }
  find_push(level);
  find_active_lines(
      level);  // a cell may be open to its high sides only: lines with cells count too
}

}  // namespace porefines::flow
