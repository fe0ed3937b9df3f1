// SPDX-License-Identifier: MPL-2.0
#include "flow/sphere_cover.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::flow {

namespace {

constexpr Real shortest_link = 0.05;  ///< cells
constexpr std::int32_t linked = -1;

Real length(const Vec3& v) {
  return norm(v);
}

}  // namespace

SphereCover::SphereCover(Operator& op, Friction& friction, const Boundaries& boundaries)
    : op_(op), level_(op.level()), friction_(friction), boundaries_(boundaries) {
  for (int a = 0; a < 3; ++a) {
    spacing_[a] = level_.widths[a].front();
    owner_[a].assign(level_.block.size, 0);
  }
}

void SphereCover::lift() {
  for (auto q = old_faces_.rbegin(); q != old_faces_.rend(); ++q) {
    level_.inverse_diagonal[q->component][q->at] = q->inverse;
    friction_.excess[q->component][q->at] = q->excess;
    owner_[q->component][q->at] = 0;
  }
  for (const OldCell& q : old_cells_) {
    level_.push[q.at] = q.push;
  }
  old_faces_.clear();
  old_cells_.clear();
  covered_.clear();
}

void SphereCover::place(const SphereSet& set) {
  lift();
  cuts_.assign(set.size(), {});
  count_ = {};
  const int images = static_cast<int>(set.images().size());
  for (int image = 0; image < images; ++image) {
    cover(set, image);
  }
  close_pockets(set);
  for (int image = 0; image < images; ++image) {
    list_faces(set, image);
    link(set, image);
  }
  find_pushes();
  find_fluxes(set);
}

Int3 SphereCover::index_of(std::uint32_t at) const {
  const grid::Block& b = level_.block;
  const std::ptrdiff_t from = at - b.at(-b.ghost[0], -b.ghost[1], -b.ghost[2]);
  const std::ptrdiff_t row = from % b.sz;
  return {static_cast<int>(row % b.sy) - b.ghost[0], static_cast<int>(row / b.sy) - b.ghost[1],
          static_cast<int>(from / b.sz) - b.ghost[2]};
}

bool SphereCover::owns_cell(const Int3& index) const {
  for (int a = 0; a < 3; ++a) {
    if (level_.axis[a].owned_cell[index[a] + level_.axis[a].offset] == 0) {
      return false;
    }
  }
  return true;
}

bool SphereCover::owns_face(int component, const Int3& index) const {
  for (int a = 0; a < 3; ++a) {
    const auto& axis = level_.axis[a];
    const auto& owned = a == component ? axis.owned_face : axis.owned_cell;
    if (owned[index[a] + axis.offset] == 0) {
      return false;
    }
  }
  return true;
}

float SphereCover::volume_of(int component, const Int3& index) const {
  const auto& axis = level_.axis[component];
  const float gradient = axis.gradient[index[component] + axis.offset];
  return gradient > 0 ? static_cast<float>(1 / spacing_[component]) / gradient : 1.0F;
}

/// Of a cell, in the block with its ghosts.
bool SphereCover::is_inside(const Int3& index) const {
  const grid::Block& b = level_.block;
  for (int a = 0; a < 3; ++a) {
    if (index[a] < -b.ghost[a] || index[a] >= b.n[a] + b.ghost[a]) {
      return false;
    }
  }
  return true;
}

Vec3 SphereCover::arm_of(int component, const Int3& index, const Vec3& centre) const {
  Vec3 arm;
  for (int a = 0; a < 3; ++a) {
    const Real place = index[a] + level_.block.start[a] + (a == component ? 0.0 : 0.5);
    arm[a] = place * spacing_[a] - centre[a];
  }
  return arm;
}

/// Faces, in the block with its ghosts, that may lie within `margin` cells of the sphere.
SphereCover::Window SphereCover::window(const BallImage& image, Real radius, int margin) const {
  Window w{};
  const grid::Block& b = level_.block;
  for (int a = 0; a < 3; ++a) {
    const Real x = image.centre[a] / spacing_[a] - b.start[a];
    const Real r = radius / spacing_[a] + margin;
    w.first[a] = std::max(-b.ghost[a], static_cast<int>(std::floor(x - r)) - 1);
    w.last[a] = std::min(b.n[a] + b.ghost[a], static_cast<int>(std::ceil(x + r)) + 1);
  }
  return w;
}

namespace {

template <typename Window, typename Visit>
void for_window(const Window& w, const Visit& visit) {
  for (int k = w.first[2]; k <= w.last[2]; ++k) {
    for (int j = w.first[1]; j <= w.last[1]; ++j) {
      for (int i = w.first[0]; i <= w.last[0]; ++i) {
        visit(Int3{i, j, k});
      }
    }
  }
}

}  // namespace

void SphereCover::take_face(int component, std::uint32_t at, int image) {
  float& inverse = level_.inverse_diagonal[component][at];
  float& excess = friction_.excess[component][at];
  old_faces_.push_back({at, static_cast<std::uint8_t>(component), inverse, excess});
  inverse = 0;
  excess = Friction::inactive;
  owner_[component][at] = image + 1;
}

void SphereCover::cover(const SphereSet& set, int image) {
  const BallImage& here = set.images()[image];
  const Real radius = set.balls()[here.ball].radius;
  const Window w = window(here, radius, 0);
  const auto deeper = [&](int c, const Int3& index, Real depth, int other) {
    const BallImage& q = set.images()[other];
    const Real its = set.balls()[q.ball].radius - length(arm_of(c, index, q.centre));
    return depth > its || (depth == its && set.balls()[here.ball].id < set.balls()[q.ball].id);
  };
  for (int c = 0; c < 3; ++c) {
    for_window(w, [&](const Int3& index) {
      const auto at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
      const std::int32_t owner = owner_[c][at];
      if (owner == 0 && level_.inverse_diagonal[c][at] == 0) {
        return;  // rock
      }
      const Real depth = radius - length(arm_of(c, index, here.centre));
      if (depth < 0) {
        return;
      }
      if (owner == 0) {
        take_face(c, at, image);
      } else if (deeper(c, index, depth, owner - 1)) {
        owner_[c][at] = image + 1;
      }
    });
  }
}

void SphereCover::list_faces(const SphereSet& set, int image) {
  const BallImage& here = set.images()[image];
  for (int c = 0; c < 3; ++c) {
    // Closed pockets reach a little beyond the sphere.
    for_window(window(here, set.balls()[here.ball].radius, 4), [&](const Int3& index) {
      const auto at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
      if (owner_[c][at] != image + 1) {
        return;
      }
      const Vec3 arm = arm_of(c, index, here.centre);
      const FaceArm face{
          at,
          static_cast<std::uint8_t>(c),
          owns_face(c, index),
          {static_cast<float>(arm.x), static_cast<float>(arm.y), static_cast<float>(arm.z)}};
      cuts_[here.ball].faces.push_back({face, volume_of(c, index)});
    });
  }
}

void SphereCover::link(const SphereSet& set, int image) {
  const BallImage& here = set.images()[image];
  const Real radius = set.balls()[here.ball].radius;
  for (int c = 0; c < 3; ++c) {
    for_window(window(here, radius, 2), [&](const Int3& index) {
      const auto at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
      if (level_.inverse_diagonal[c][at] != 0) {
        link_face(c, index, arm_of(c, index, here.centre), image, here.ball, radius);
      }
    });
  }
}

void SphereCover::link_face(int component, const Int3& index, const Vec3& arm, int image, int ball,
                            Real radius) {
  const grid::Block& b = level_.block;
  const auto at = static_cast<std::uint32_t>(b.at(index[0], index[1], index[2]));
  const Real s0 = length(arm) - radius;
  for (int t = 0; t < 3; ++t) {
    const auto& axis = level_.axis[t];
    const auto& low = t == component ? axis.face_low : axis.cell_low;
    const auto& high = t == component ? axis.face_high : axis.cell_high;
    for (const int side : {-1, 1}) {
      const int there = index[t] + side;
      if (there < -b.ghost[t] || there > b.n[t] + b.ghost[t] ||
          owner_[component][at + side * b.stride(t)] != image + 1) {
        continue;
      }
      const Real e = (side < 0 ? low : high)[index[t] + axis.offset];
      Vec3 wall = arm;
      wall[t] += side * spacing_[t];
      const Real s1 = length(wall) - radius;
      const Real theta = s1 <= 0 ? std::clamp(s0 / (s0 - s1), shortest_link, 1.0) : 1;
      wall[t] = arm[t] + side * spacing_[t] * theta;
      float& inverse = level_.inverse_diagonal[component][at];
      float& excess = friction_.excess[component][at];
      if (owner_[component][at] == 0) {
        old_faces_.push_back({at, static_cast<std::uint8_t>(component), inverse, excess});
        owner_[component][at] = linked;
      }
      const auto more = static_cast<float>(e / theta - e);
      excess += more;
      inverse = 1 / (1 / inverse + more);
      SphereLink link;
      link.face = {
          at,
          static_cast<std::uint8_t>(component),
          owns_face(component, index),
          {static_cast<float>(wall.x), static_cast<float>(wall.y), static_cast<float>(wall.z)}};
      link.friction = static_cast<float>(e / theta);
      link.volume = volume_of(component, index);
      if (link.face.owned) {
        link.packed = static_cast<std::int64_t>(op_.position(component, index));
      }
      cuts_[ball].links.push_back(link);
    }
  }
}

/// push of the cells whose faces changed.
void SphereCover::find_pushes() {
  std::vector<std::uint32_t> cells;
  for (const OldFace& q : old_faces_) {
    cells.push_back(q.at);
    cells.push_back(static_cast<std::uint32_t>(q.at - level_.block.stride(q.component)));
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (const std::uint32_t at : cells) {
    if (at >= level_.block.size || !is_inside(index_of(at)) || level_.push[at] == 0) {
      continue;
    }
    old_cells_.push_back({at, level_.push[at]});
    level_.push[at] = push_of(level_, index_of(at));
    if (level_.push[at] == 0) {
      covered_.push_back(at);
    }
  }
}

/// Was the cell open before spheres came?
bool SphereCover::was_open(std::uint32_t cell) const {
  return level_.push[cell] != 0 || std::binary_search(covered_.begin(), covered_.end(), cell);
}

void SphereCover::find_fluxes(const SphereSet& set) {
  std::vector<CellShare> shares;
  std::vector<std::uint32_t> orphans;
  for (std::size_t ball = 0; ball < set.size(); ++ball) {
    std::vector<SphereCell> parts;
    for (const RigidFace& q : cuts_[ball].faces) {
      const int c = q.face.component;
      const Int3 high = index_of(q.face.at);
      const Six row = q.face.row();
      for (const bool low_side : {false, true}) {
        Int3 cell = high;
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
        parts.push_back(part);
      }
    }
    const auto by_place = [](const SphereCell& a, const SphereCell& b) { return a.at < b.at; };
    std::stable_sort(parts.begin(), parts.end(), by_place);
    for (std::size_t q = 0; q < parts.size();) {
      SphereCell sum = parts[q];
      for (++q; q < parts.size() && parts[q].at == sum.at; ++q) {
        for (std::size_t x = 0; x < 6; ++x) {
          sum.flux[x] += parts[q].flux[x];
        }
      }
      const Int3 cell = index_of(sum.at);
      sum.owned = owns_cell(cell);
      if (level_.push[sum.at] != 0) {
        sum.packed = sum.owned ? static_cast<std::int64_t>(op_.position(3, cell)) : -1;
        cuts_[ball].cells.push_back(sum);
        continue;
      }
      float size = 0;
      for (const float value : sum.flux) {
        size = std::max(size, std::abs(value));
      }
      constexpr float rounding = 1e-5F;  // arms are float: rows of a cell all within cancel to this
      if (sum.owned && size > rounding * static_cast<float>(set.balls()[ball].radius)) {
        orphans.push_back(sum.at);
        share_orphan(sum.at, set.balls()[ball].id, sum.flux, shares);
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
    for_window(Window{{-wraps[0], -wraps[1], -wraps[2]}, wraps}, [&](const Int3& wrap) {
      Int3 cell{};
      for (int a = 0; a < 3; ++a) {
        cell[a] = share.cell[a] + wrap[a] * b.global[a] - b.start[a];
      }
      if (!is_inside(cell)) {
        return;
      }
      SphereCell q;
      q.at = static_cast<std::uint32_t>(b.at(cell[0], cell[1], cell[2]));
      q.owned = owns_cell(cell);
      q.flux = share.flux;
      q.packed = q.owned ? static_cast<std::int64_t>(op_.position(3, cell)) : -1;
      if (level_.push[q.at] != 0) {
        cuts_[ball].cells.push_back(q);
      }
    });
  }
  for (SphereCut& cut : cuts_) {  // one entry per cell: pushes are quadratic in the flux
    std::stable_sort(cut.cells.begin(), cut.cells.end(),
                     [](const SphereCell& a, const SphereCell& c) { return a.at < c.at; });
    std::size_t kept = 0;
    for (std::size_t q = 0; q < cut.cells.size(); ++q) {
      if (kept > 0 && cut.cells[kept - 1].at == cut.cells[q].at) {
        for (std::size_t x = 0; x < 6; ++x) {
          cut.cells[kept - 1].flux[x] += cut.cells[q].flux[x];
        }
      } else {
        cut.cells[kept++] = cut.cells[q];
      }
    }
    cut.cells.resize(kept);
  }
}

/// Flood from open cells near spheres, through open faces; gives up beyond four cells a side.
void SphereCover::close_pockets(const SphereSet& set) {
  constexpr int widest = 4;
  const grid::Block& b = level_.block;
  std::vector<std::uint32_t> starts;  // open cells with a covered face
  for (const OldFace& q : old_faces_) {
    for (const std::ptrdiff_t back : {std::ptrdiff_t{0}, b.stride(q.component)}) {
      const std::ptrdiff_t at = q.at - back;
      if (at >= 0) {
        starts.push_back(static_cast<std::uint32_t>(at));
      }
    }
  }
  std::sort(starts.begin(), starts.end());
  starts.erase(std::unique(starts.begin(), starts.end()), starts.end());
  constexpr std::uint8_t wide = 1;  // part of something wider than a pocket
  constexpr std::uint8_t small = 2;
  mark_.assign(b.size, 0);
  const auto face_open = [&](int a, std::ptrdiff_t at) {
    return level_.inverse_diagonal[a][at] != 0;
  };
  for (const std::uint32_t start : starts) {
    if (!is_inside(index_of(start)) || mark_[start] != 0) {
      continue;
    }
    std::vector<std::uint32_t> pocket{start};
    std::vector<std::pair<int, std::uint32_t>> faces;
    Int3 low = index_of(start);
    Int3 high = low;
    bool closed = true;
    for (std::size_t next = 0; next < pocket.size() && closed; ++next) {
      const Int3 cell = index_of(pocket[next]);
      for (int a = 0; a < 3 && closed; ++a) {
        for (const int side : {0, 1}) {
          const std::ptrdiff_t face = pocket[next] + side * b.stride(a);
          if (!face_open(a, face)) {
            continue;
          }
          faces.emplace_back(a, static_cast<std::uint32_t>(face));
          Int3 q = cell;
          q[a] += side == 0 ? -1 : 1;
          const int total = q[a] + b.start[a];
          if (!is_inside(q) || (!boundaries_.periodic(a) && (total < 0 || total >= b.global[a]))) {
            closed = false;  // leaves the box or what this rank sees
            break;
          }
          low[a] = std::min(low[a], q[a]);
          high[a] = std::max(high[a], q[a]);
          closed = high[a] - low[a] < widest;
          const auto there = static_cast<std::uint32_t>(b.at(q[0], q[1], q[2]));
          closed = closed && mark_[there] != wide;
          if (std::find(pocket.begin(), pocket.end(), there) == pocket.end()) {
            pocket.push_back(there);
          }
        }
      }
    }
    for (const std::uint32_t at : pocket) {
      mark_[at] = closed ? small : wide;
    }
    if (!closed || faces.empty()) {
      continue;
    }
    ++count_.pockets;
    for (const auto& [a, at] : faces) {
      if (!face_open(a, at)) {
        continue;  // seen from both sides
      }
      int nearest = 0;
      Real best = INFINITY;
      for (std::size_t image = 0; image < set.images().size(); ++image) {
        const BallImage& q = set.images()[image];
        const Real gap = length(arm_of(a, index_of(at), q.centre)) - set.balls()[q.ball].radius;
        if (gap < best) {
          best = gap;
          nearest = static_cast<int>(image);
        }
      }
      take_face(a, at, nearest);
    }
  }
}

}  // namespace porefines::flow
