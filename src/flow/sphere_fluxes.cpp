// SPDX-License-Identifier: MPL-2.0
// SphereCover: the fluxes that covered faces drive into cells, and whose they are where none is open.
#include <algorithm>
#include <cmath>

#include "flow/sphere_cover.hpp"

namespace porefines::flow {

namespace {

/// Entries of one cell become one, in memory order: pushes are quadratic in the flux.
void merge_cells(std::vector<SphereCell>& cells) {
  std::stable_sort(cells.begin(), cells.end(),
                   [](const SphereCell& a, const SphereCell& b) { return a.at < b.at; });
  std::size_t kept = 0;
  for (std::size_t q = 0; q < cells.size(); ++q) {
    if (kept > 0 && cells[kept - 1].at == cells[q].at) {
      for (std::size_t x = 0; x < 6; ++x) {
        cells[kept - 1].flux[x] += cells[q].flux[x];
      }
    } else {
      cells[kept++] = cells[q];
    }
  }
  cells.resize(kept);
}

/// Arms are float: the rows of a cell all of whose faces move together cancel to this.
bool is_rounding(const std::array<float, 6>& flux, Real radius) {
  constexpr float rounding = 1e-5F;
  float size = 0;
  for (const float value : flux) {
    size = std::max(size, std::abs(value));
  }
  return size <= rounding * static_cast<float>(radius);
}

}  // namespace

/// Was the cell open before spheres came?
bool SphereCover::was_open(std::uint32_t cell) const {
  return level_.push[cell] != 0 || std::binary_search(covered_.begin(), covered_.end(), cell);
}

SphereCell SphereCover::cell_at(const Int3& index, const std::array<float, 6>& flux) const {
  SphereCell q;
  q.at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
  q.owned = level_.owns(3, index);
  q.flux = flux;
  q.packed =
      q.owned && level_.push[q.at] != 0 ? static_cast<std::int64_t>(op_.position(3, index)) : -1;
  return q;
}

/// Flux out of every cell with a face that the ball covers.
std::vector<SphereCell> SphereCover::fluxes_of(std::size_t ball) const {
  std::vector<SphereCell> cells;
  for (const RigidFace& q : cuts_[ball].faces) {
    const int c = q.face.component;
    const Six row = q.face.row();
    for (const bool low_side : {false, true}) {
      Int3 cell = index_of(q.face.at);
      cell[c] -= low_side ? 1 : 0;
      if (!is_inside(cell)) {
        continue;
      }
      const auto& axis = level_.axis[c];
      const float out = (low_side ? 1 : -1) * axis.divergence[cell[c] + axis.offset] *
                        level_.weight[c][q.face.at];
      SphereCell part;
      part.at = static_cast<std::uint32_t>(level_.block.at(cell[0], cell[1], cell[2]));
      for (std::size_t x = 0; x < 6; ++x) {
        part.flux[x] = out * static_cast<float>(row[x]);
      }
      cells.push_back(part);
    }
  }
  merge_cells(cells);
  for (SphereCell& q : cells) {
    q = cell_at(index_of(q.at), q.flux);
  }
  return cells;
}

void SphereCover::find_fluxes(const SphereSet& set) {
  std::vector<CellShare> shares;
  std::vector<std::uint32_t> orphans;
  for (std::size_t ball = 0; ball < set.size(); ++ball) {
    const Ball& its = set.balls()[ball];
    for (const SphereCell& q : fluxes_of(ball)) {
      if (level_.push[q.at] != 0) {
        cuts_[ball].cells.push_back(q);
      } else if (q.owned && !is_rounding(q.flux, its.radius)) {
        orphans.push_back(q.at);
        share_orphan(q.at, its.id, q.flux, shares);
      }
    }
  }
  std::sort(orphans.begin(), orphans.end());
  count_.orphans = std::unique(orphans.begin(), orphans.end()) - orphans.begin();
  take_shares(set, set.gather_near(shares));
}

/// Breadth first through what spheres cover, to the first layer with open cells.
void SphereCover::share_orphan(std::uint32_t at, std::uint64_t id, const std::array<float, 6>& flux,
                               std::vector<CellShare>& out) {
  constexpr int reach = 4;  // ghost layers: every rank sees that far
  const grid::Block& b = level_.block;
  std::vector<std::uint32_t> layer{at};
  std::vector<std::uint32_t> seen{at};
  std::vector<std::uint32_t> open;
  for (int depth = 0; depth < reach && open.empty() && !layer.empty(); ++depth) {
    std::vector<std::uint32_t> next;
    for (const std::uint32_t from : layer) {
      const Int3 cell = index_of(from);
      for (int a = 0; a < 3; ++a) {
        for (const int side : {-1, 1}) {
          Int3 q = cell;
          q[a] += side;
          const auto there = static_cast<std::uint32_t>(from + side * b.stride(a));
          if (!is_inside(q) || !was_open(there) ||
              std::find(seen.begin(), seen.end(), there) != seen.end()) {
            continue;
          }
          seen.push_back(there);
          (level_.push[there] != 0 ? open : next).push_back(there);
        }
      }
    }
    layer = std::move(next);
  }
  count_.lost += open.empty() ? 1 : 0;
  for (const std::uint32_t there : open) {
    CellShare share;
    share.id = id;
    const Int3 cell = index_of(there);
    for (std::size_t a = 0; a < 3; ++a) {
      const int n = b.global[a];
      share.cell[a] = ((cell[a] + b.start[a]) % n + n) % n;
    }
    for (std::size_t x = 0; x < 6; ++x) {
      share.flux[x] = flux[x] / static_cast<float>(open.size());
    }
    out.push_back(share);
  }
}

/// Adds shares to the cells of this block and its ghosts, at every periodic place that they have.
void SphereCover::take_shares(const SphereSet& set, const std::vector<CellShare>& shares) {
  const grid::Block& b = level_.block;
  for (const CellShare& share : shares) {
    const int ball = set.find(share.id);
    if (ball < 0) {
      continue;
    }
    Int3 wraps{};
    for (int a = 0; a < 3; ++a) {
      wraps[a] = boundaries_.periodic(a) ? 1 + b.ghost[a] / b.global[a] : 0;
    }
    grid::for_window({-wraps[0], -wraps[1], -wraps[2]}, wraps, [&](const Int3& wrap) {
      Int3 cell{};
      for (int a = 0; a < 3; ++a) {
        cell[a] = share.cell[a] + wrap[a] * b.global[a] - b.start[a];
      }
      if (!is_inside(cell)) {
        return;
      }
      const SphereCell q = cell_at(cell, share.flux);
      if (level_.push[q.at] != 0) {
        cuts_[ball].cells.push_back(q);
      }
    });
  }
  for (SphereCut& cut : cuts_) {
    merge_cells(cut.cells);
  }
}

}  // namespace porefines::flow
