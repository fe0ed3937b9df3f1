// SPDX-License-Identifier: MPL-2.0
#include "flow/body_forces.hpp"

#include <cmath>

#include "flow/links.hpp"

namespace porefines::flow {

namespace {

/// Friction that box walls add to a face: see link_to_surface.
Real box_friction(const Level& level, const Boundaries& boundaries, int c, const Int3& index) {
  Real friction = 0;
  for (int a = 0; a < 3; ++a) {
    if (a == c || boundaries.periodic(a)) {
      continue;
    }
    const auto& axis = level.axis[a];
    const int here = index[a] + level.block.start[a];
    for (const bool high : {false, true}) {
      if (here == (high ? level.block.global[a] - 1 : 0)) {
        const FaceKind kind = boundaries.at(a, high);
        const Real e = (high ? axis.cell_high : axis.cell_low)[index[a] + axis.offset];
        friction += kind == FaceKind::slip || kind == FaceKind::outflow ? -e : e;
      }
    }
  }
  return friction;
}

}  // namespace

BodyForces::BodyForces(InertialFlow& flow, StokesSolver& solver,
                       const std::function<int(const Vec3&)>& body_of, int bodies)
    : flow_(flow), parts_(solver.parts()), level_(parts_.hierarchy.finest()), bodies_(bodies) {
  parts_.equations.for_each([&](int c, int i, int j, int k, std::size_t at) {
    const Int3 index{i, j, k};
    const int body = body_of(parts_.place(c, index));
    if (body >= 0 && c < 3) {
      add_face(parts_.boundaries, c, index, body);
    } else if (body >= 0) {
      add_cell(parts_.boundaries, index, at, body);
    }
  });
}

void BodyForces::add_face(const Boundaries& boundaries, int c, const Int3& index, int body) {
  const grid::Block& b = level_.block;
  const std::ptrdiff_t at = b.at(index[0], index[1], index[2]);
  Real friction = flow_.friction()[c][at] - box_friction(level_, boundaries, c, index);
  for (int t = 0; t < 3; ++t) {
    const auto& axis = level_.axis[t];
    const std::size_t here = index[t] + axis.offset;
    for (const bool high : {false, true}) {
      const std::ptrdiff_t s = high ? b.stride(t) : -b.stride(t);
      const bool closed = exists(level_.block, boundaries, c, t, index[t] + (high ? 1 : -1)) &&
                          level_.inverse_diagonal[c][at + s] == 0;
      if (!closed) {
        continue;
      }
      friction += t == c ? (high ? axis.face_high : axis.face_low)[here]
                         : (high ? axis.cell_high : axis.cell_low)[here];
      const std::ptrdiff_t side = t == c ? at : high ? at + b.stride(t) : at;
      const std::ptrdiff_t other = t == c ? at + s : side - b.stride(c);
      const Real width = level_.widths[t].front();
      // F v = (W u + W u)/2 * u_P/2, outwards
      through_.push_back({body, c, t, at, side, other, (high ? 1 : -1) * 0.25 / width});
    }
  }
  if (std::abs(friction) > 1e-5) {
    friction_.push_back({body, c, at, friction});
  }
}

void BodyForces::add_cell(const Boundaries& boundaries, const Int3& index, std::size_t packed,
                          int body) {
  const grid::Block& b = level_.block;
  const std::ptrdiff_t at = b.at(index[0], index[1], index[2]);
  for (int a = 0; a < 3; ++a) {
    const auto weight = [&](bool high) {
      const std::ptrdiff_t face = high ? at + b.stride(a) : at;
      return level_.inverse_diagonal[a][face] != 0 ? Real{level_.weight[a][face]} : 0.0;
    };
    const auto there = [&](bool high) {
      return exists(level_.block, boundaries, a, a, index[a] + (high ? 1 : 0));
    };
    const auto share = [&](bool high) {  // a wall of the box: as open as the other side
      return there(high) ? weight(high) : there(!high) && weight(!high) > 0 ? weight(!high) : 1.0;
    };
    const Real step = share(false) - share(true);
    if (std::abs(step) > 1e-6) {
      const auto& axis = level_.axis[a];
      pressure_.push_back({body, a, static_cast<std::ptrdiff_t>(packed),
                           step * axis.divergence[index[a] + axis.offset]});
    }
  }
}

std::vector<Vec3> BodyForces::sum(const Drive& drive) {
  flow_.show_velocity(drive);
  const FaceVelocity& u = flow_.velocity();
  std::vector<Real> sums(static_cast<std::size_t>(3 * bodies_), 0.0);
  for (const Pull& q : friction_) {
    sums[3 * q.body + q.axis] += q.factor * u.data(q.axis)[q.at];
  }
  for (const Pull& q : pressure_) {
    sums[3 * q.body + q.axis] += q.factor * parts_.unknowns[q.at];
  }
  for (const Through& q : through_) {
    const float* carrier = u.data(q.along);
    const float* w = level_.weight[q.along].data();
    const Real flux = Real{w[q.first]} * carrier[q.first] + Real{w[q.second]} * carrier[q.second];
    sums[3 * q.body + q.axis] += flow_.inertia() * q.factor * flux * u.data(q.axis)[q.at];
  }
  parts_.comm.sum(sums);
  const Vec3& h = parts_.spacing;
  const Real unit = parts_.scale * h.x * h.y * h.z;
  std::vector<Vec3> forces;
  for (int body = 0; body < bodies_; ++body) {
    const std::size_t at = 3 * static_cast<std::size_t>(body);
    forces.push_back(Vec3{sums[at], sums[at + 1], sums[at + 2]} * unit);
  }
  return forces;
}

}  // namespace porefines::flow
