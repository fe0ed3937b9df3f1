// SPDX-License-Identifier: MPL-2.0
#include "flow/sphere_cover.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::flow {

namespace {

constexpr Real shortest_link = 0.05;  ///< cells
constexpr std::int32_t linked = -1;

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
  return level_.block.index_of(at);
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
  const Vec3 place = level_.block.centre(component, index);
  Vec3 arm;
  for (int a = 0; a < 3; ++a) {
    arm[a] = place[a] * spacing_[a] - centre[a];
  }
  return arm;
}

FaceArm SphereCover::face_arm(int component, const Int3& index, const Vec3& arm) const {
  return {static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2])),
          static_cast<std::uint8_t>(component),
          level_.owns(component, index),
          {static_cast<float>(arm.x), static_cast<float>(arm.y), static_cast<float>(arm.z)}};
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
    const Real its = set.balls()[q.ball].radius - norm(arm_of(c, index, q.centre));
    return depth > its || (depth == its && set.balls()[here.ball].id < set.balls()[q.ball].id);
  };
  for (int c = 0; c < 3; ++c) {
    grid::for_window(w.first, w.last, [&](const Int3& index) {
      const auto at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
      const std::int32_t owner = owner_[c][at];
      if (owner == 0 && level_.inverse_diagonal[c][at] == 0) {
        return;  // rock
      }
      const Real depth = radius - norm(arm_of(c, index, here.centre));
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
  // Closed pockets reach a little beyond the sphere.
  const Window w = window(here, set.balls()[here.ball].radius, 4);
  for (int c = 0; c < 3; ++c) {
    grid::for_window(w.first, w.last, [&](const Int3& index) {
      const auto at = static_cast<std::uint32_t>(level_.block.at(index[0], index[1], index[2]));
      if (owner_[c][at] != image + 1) {
        return;
      }
      cuts_[here.ball].faces.push_back(
          {face_arm(c, index, arm_of(c, index, here.centre)), volume_of(c, index)});
    });
  }
}

void SphereCover::link(const SphereSet& set, int image) {
  const BallImage& here = set.images()[image];
  const Real radius = set.balls()[here.ball].radius;
  const Window w = window(here, radius, 2);
  for (int c = 0; c < 3; ++c) {
    grid::for_window(w.first, w.last, [&](const Int3& index) {
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
  const Real s0 = norm(arm) - radius;
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
      const Real s1 = norm(wall) - radius;
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
      link.face = face_arm(component, index, wall);
      link.friction = static_cast<float>(e / theta);
      link.volume = volume_of(component, index);
      link.towards = static_cast<std::int8_t>(side * (t + 1));
      if (link.face.owned) {
        link.packed = static_cast<std::int64_t>(op_.position(component, index));
      }
      cuts_[ball].links.push_back(link);
    }
  }
}

/// Cells of the block and its ghosts at the sides of faces that spheres changed so far, each once.
std::vector<std::uint32_t> SphereCover::changed_cells() const {
  std::vector<std::uint32_t> cells;
  for (const OldFace& q : old_faces_) {
    for (const std::ptrdiff_t back : {std::ptrdiff_t{0}, level_.block.stride(q.component)}) {
      const std::ptrdiff_t at = q.at - back;
      if (at >= 0 && is_inside(index_of(static_cast<std::uint32_t>(at)))) {
        cells.push_back(static_cast<std::uint32_t>(at));
      }
    }
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  return cells;
}

/// push of the cells whose faces changed.
void SphereCover::find_pushes() {
  for (const std::uint32_t at : changed_cells()) {
    if (level_.push[at] == 0) {
      continue;
    }
    old_cells_.push_back({at, level_.push[at]});
    level_.push[at] = push_of(level_, index_of(at));
    if (level_.push[at] == 0) {
      covered_.push_back(at);
    }
  }
}

}  // namespace porefines::flow
