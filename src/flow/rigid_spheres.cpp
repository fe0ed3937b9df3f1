// SPDX-License-Identifier: MPL-2.0
#include "flow/rigid_spheres.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::flow {

RigidSpheres::RigidSpheres(const par::Communicator& comm, Operator& op, Friction& friction,
                           const Vec3& spacing, const Boundaries& boundaries)
    : comm_(comm),
      op_(op),
      level_(op.level()),
      cover_(op, friction, boundaries),
      set_(comm, level_.decomposition, spacing, boundaries, level_.block) {}

void RigidSpheres::place(std::span<const Ball> owned, std::span<const WallGap> walls,
                         Real roughness, Real inertia) {
  cover_.lift();
  set_.distribute(owned);
  cover_.place(set_);
  motion_.clear();
  for (const Ball& ball : set_.balls()) {
    motion_.push_back(ball.motion);
  }
  gaps_ = find_lubrication(set_, level_.block, walls, roughness);
  for (Lubrication& gap : gaps_) {
    gap.squeeze *= gap.touching && inertia * impact(gap) > 1 ? 0 : 1;
  }
  find_blocks();
  force_.assign(set_.size(), {});
  row_.assign(set_.size(), {});
}

Real RigidSpheres::closing_speed(const Lubrication& gap) const {
  const auto along = [&](int ball) {
    const Six& v = motion_[ball];
    return v[0] * gap.normal.x + v[1] * gap.normal.y + v[2] * gap.normal.z;
  };
  return std::abs(along(gap.first) - (gap.second < 0 ? 0 : along(gap.second)));
}

Real RigidSpheres::impact(const Lubrication& gap) const {
  const Real a = gap.radius_first;
  const Real b = gap.radius_second;
  const Real one = set_.balls()[gap.first].mass;
  const Real two = gap.second < 0 ? 0 : set_.balls()[gap.second].mass;
  const Real mass = gap.second < 0 ? one : one * two / (one + two);
  const Real reduced = gap.second < 0 ? a : a * b / (a + b);
  return mass > 0 ? mass * closing_speed(gap) / (6 * M_PI * reduced * reduced) : 0;
}

/// N = sum r r^T over covered faces and the diagonal block
///
///     D = sum k r r^T + sum push g g^T
///
/// the second term being what the pressure of its cells does when the sphere moves alone.
void RigidSpheres::find_blocks() {
  std::vector<SixBySix> faces(set_.size(), SixBySix{});
  std::vector<SixBySix> block(set_.size(), SixBySix{});
  const auto add = [](SixBySix& out, Real weight, const Six& r) {
    for (int i = 0; i < 6; ++i) {
      for (int j = 0; j < 6; ++j) {
        out[6 * i + j] += weight * r[i] * r[j];
      }
    }
  };
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (const RigidFace& q : cuts()[b].faces) {
      if (q.face.owned) {
        add(faces[b], q.volume, q.face.row());
      }
    }
    for (const SphereLink& q : cuts()[b].links) {
      if (q.face.owned) {
        add(block[b], q.friction * q.volume, q.face.row());
      }
    }
    for (const SphereCell& q : cuts()[b].cells) {
      if (q.owned) {
        const Six g{q.flux[0], q.flux[1], q.flux[2], q.flux[3], q.flux[4], q.flux[5]};
        add(block[b], level_.push[q.at], g);
      }
    }
  }
  set_.sum(faces);
  set_.sum(block);
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (const int x : {3, 4, 5}) {
      block[b][7 * x] += 2 * set_.volume(b);
    }
    for (int x = 0; x < 6; ++x) {
      block[b][7 * x] += x < 3 ? set_.balls()[b].mass : set_.balls()[b].moment;
    }
  }
  alone_ = block;
  std::vector<SixBySix> bonds(set_.size(), SixBySix{});
  for (const Lubrication& gap : gaps_) {
    add_own_blocks(gap, 1 / set_.cell_volume(), bonds);
  }
  set_.sum(bonds);
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (std::size_t x = 0; x < 36; ++x) {
      block[b][x] += bonds[b][x];
    }
  }
  const bool here = std::any_of(gaps_.begin(), gaps_.end(),
                                [](const Lubrication& gap) { return gap.second >= 0; });
  bound_ = comm_.max(here ? 1.0 : 0.0) > 0;
  lower_.clear();
  spread_.clear();
  inverse_.clear();
  for (std::size_t b = 0; b < set_.size(); ++b) {
    const bool held = set_.balls()[b].held;
    lower_.push_back(cholesky(faces[b]));
    spread_.push_back(held ? SixBySix{} : inverse_from(lower_.back()));
    inverse_.push_back(held ? SixBySix{} : inverse_from(cholesky(block[b])));
  }
}

template <typename T>
void RigidSpheres::load_motion(const T* tail) {
  std::fill(motion_.begin(), motion_.end(), Six{});
  for (std::size_t b = 0; b < set_.owned(); ++b) {
    std::copy_n(tail + tail_of(b), 6, motion_[b].begin());
  }
  set_.sum(motion_);
}

template <typename T>
void RigidSpheres::store_motion(T* tail) const {
  for (std::size_t b = 0; b < set_.owned(); ++b) {
    for (std::size_t x = 0; x < 6; ++x) {
      tail[tail_of(b) + x] = static_cast<T>(motion_[b][x]);
    }
  }
}

/// Of the fluid on a ball as it moves: sum k r (u - r.V) + sum g p, this rank's part.
Six RigidSpheres::pull(std::size_t ball) const {
  Six sum{};
  const Six& v = motion_[ball];
  for (const SphereLink& q : cuts()[ball].links) {
    if (q.face.owned) {
      const Real slip = level_.u[q.face.component][q.face.at] - q.face.of(v);
      q.face.add(q.friction * q.volume * slip, sum);
    }
  }
  for (const SphereCell& q : cuts()[ball].cells) {
    if (q.owned) {
      for (std::size_t x = 0; x < 6; ++x) {
        sum[x] += q.flux[x] * level_.p[q.at];
      }
    }
  }
  return sum;
}

void RigidSpheres::find_rows() {
  for (std::size_t b = 0; b < set_.size(); ++b) {
    row_[b] = pull(b);
  }
  for (const Lubrication& gap : gaps_) {
    add_lubrication(gap, motion_, 1 / set_.cell_volume(), row_);
  }
  set_.sum(row_);
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (const int x : {3, 4, 5}) {
      row_[b][x] -= 2 * set_.volume(b) * motion_[b][x];
    }
    const Ball& ball = set_.balls()[b];
    for (std::size_t x = 0; x < 6 && !ball.held; ++x) {
      row_[b][x] -= (x < 3 ? ball.mass : ball.moment) * motion_[b][x];
    }
  }
}

template <typename T>
void RigidSpheres::apply(T* fluid, T* tail) {
  for (std::size_t b = 0; b < set_.size(); ++b) {
    const Six& v = motion_[b];
    for (const SphereLink& q : cuts()[b].links) {
      if (q.face.owned) {
        fluid[q.packed] -= static_cast<T>(q.friction * q.face.of(v));
      }
    }
    for (const SphereCell& q : cuts()[b].cells) {
      if (q.owned) {
        fluid[q.packed] += static_cast<T>(q.of(v));
      }
    }
  }
  find_rows();
  for (std::size_t b = 0; b < set_.owned(); ++b) {
    const bool held = set_.balls()[b].held;
    const Six scaled = solve_lower(lower_[b], row_[b]);
    for (std::size_t x = 0; x < 6; ++x) {
      tail[tail_of(b) + x] = static_cast<T>(held ? 0 : -scaled[x]);
    }
  }
}

void RigidSpheres::scale_force(std::size_t ball, Six& force) const {
  force = set_.balls()[ball].held ? Six{} : solve_lower(lower_[ball], force);
}

template <typename T>
void RigidSpheres::load_force(const T* tail, Real scale) {
  for (std::size_t b = 0; b < set_.size(); ++b) {
    Six force{};
    for (std::size_t i = 0; b < set_.owned() && i < 6; ++i) {
      for (std::size_t j = 0; j <= i; ++j) {
        force[i] += lower_[b][6 * i + j] * scale * tail[tail_of(b) + j];
      }
    }
    force_[b] = force;
  }
  set_.sum(force_);
}

void RigidSpheres::rest() {
  std::fill(motion_.begin(), motion_.end(), Six{});
}

/// V += change: f and g follow.
void RigidSpheres::add_motion(std::size_t ball, const Six& change) {
  motion_[ball] = sum_of(motion_[ball], change);
  show_motion(ball, change);
}

void RigidSpheres::show_motion(std::size_t ball, const Six& change) {
  for (const SphereLink& q : cuts()[ball].links) {
    level_.f[q.face.component][q.face.at] += static_cast<float>(q.friction * q.face.of(change));
  }
  for (const SphereCell& q : cuts()[ball].cells) {
    level_.g[q.at] -= static_cast<float>(q.of(change));
  }
}

void RigidSpheres::show_motion() {
  for (std::size_t b = 0; b < set_.size(); ++b) {
    show_motion(b, motion_[b]);
  }
}

/// The push of one cell by the flux that a sphere newly drives into it.
void RigidSpheres::push_cell(std::uint32_t at, Real flux) {
  const float q = -level_.push[at] * static_cast<float>(flux);
  const Int3 cell = cover_.index_of(at);
  level_.p[at] += q;
  for (int a = 0; a < 3; ++a) {
    const auto& axis = level_.axis[a];
    const std::size_t i = cell[a] + axis.offset;
    const std::ptrdiff_t high = at + level_.block.stride(a);
    const auto mobility = [&](std::ptrdiff_t face) {
      return level_.inverse_diagonal[a][face] * level_.weight[a][face];
    };
    level_.u[a][at] -= mobility(at) * axis.gradient[i] * q;
    level_.u[a][high] += mobility(high) * axis.gradient[i + 1] * q;
  }
}

void RigidSpheres::update() {
  find_rows();
  std::vector<Six> change(set_.size());
  for (std::size_t b = 0; b < set_.size(); ++b) {
    change[b] = sum_of(force_[b], row_[b]);
  }
  change = solve_together(std::move(change));
  for (std::size_t b = 0; b < set_.size(); ++b) {
    add_motion(b, change[b]);
    for (const SphereCell& q : cuts()[b].cells) {
      push_cell(q.at, q.of(change[b]));
    }
  }
}

void RigidSpheres::spread_residual() {
  find_rows();
  for (std::size_t b = 0; b < set_.size(); ++b) {
    const Six density = times(spread_[b], sum_of(force_[b], row_[b]));
    for (const RigidFace& q : cuts()[b].faces) {
      const int c = q.face.component;
      level_.r[c][q.face.at] = level_.carry[c][q.face.at] * static_cast<float>(q.face.of(density));
    }
  }
}

void RigidSpheres::take_correction() {
  std::vector<Six> sums(set_.size(), Six{});
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (const RigidFace& q : cuts()[b].faces) {
      float& u = level_.u[q.face.component][q.face.at];
      if (q.face.owned) {
        q.face.add(q.volume * u, sums[b]);
      }
      u = 0;
    }
  }
  set_.sum(sums);
  for (std::size_t b = 0; b < set_.size(); ++b) {
    add_motion(b, times(spread_[b], sums[b]));
  }
}

void RigidSpheres::write_faces(bool moving) {
  for (std::size_t b = 0; b < set_.size(); ++b) {
    for (const RigidFace& q : cuts()[b].faces) {
      level_.u[q.face.component][q.face.at] =
          moving ? static_cast<float>(q.face.of(motion_[b])) : 0.0F;
    }
  }
}

std::vector<Six> RigidSpheres::take_drive(Packed<float>& b) {
  std::vector<Six> sums(set_.size(), Six{});
  for (std::size_t ball = 0; ball < set_.size(); ++ball) {
    for (const RigidFace& q : cuts()[ball].faces) {
      if (q.face.owned) {
        float& value = b[op_.position(q.face.component, cover_.index_of(q.face.at))];
        q.face.add(q.volume * value, sums[ball]);
        value = 0;
      }
    }
  }
  for (const std::uint32_t at : cover_.covered_cells()) {
    const Int3 cell = cover_.index_of(at);
    if (level_.owns(3, cell)) {
      b[op_.position(3, cell)] = 0;
    }
  }
  set_.sum(sums);
  return sums;
}

void RigidSpheres::put_forces(Packed<float>& b, const std::vector<Six>& drive) const {
  b.resize(op_.size(), 0.0F);
  for (std::size_t q = 0; q < set_.owned(); ++q) {
    Six force = sum_of(drive[q], set_.balls()[q].force);
    scale_force(q, force);
    for (std::size_t x = 0; x < 6; ++x) {
      b[op_.fluid_size() + tail_of(q) + x] = static_cast<float>(force[x]);
    }
  }
}

std::vector<Six> RigidSpheres::contact_forces() {
  std::vector<Six> forces(set_.size(), Six{});
  for (const Lubrication& gap : gaps_) {
    add_contact(gap, motion_, 1 / set_.cell_volume(), forces);
  }
  set_.sum(forces);
  return forces;
}

template void RigidSpheres::load_motion<float>(const float*);
template void RigidSpheres::load_motion<double>(const double*);
template void RigidSpheres::store_motion<float>(float*) const;
template void RigidSpheres::store_motion<double>(double*) const;
template void RigidSpheres::apply<float>(float*, float*);
template void RigidSpheres::apply<double>(double*, double*);
template void RigidSpheres::load_force<float>(const float*, Real);
template void RigidSpheres::load_force<double>(const double*, Real);

}  // namespace porefines::flow
