// SPDX-License-Identifier: MPL-2.0
// InertialFlow with rigid spheres.
#include <algorithm>

#include "flow/inertial_flow.hpp"
#include "flow/smoother.hpp"

namespace porefines::flow {

namespace {

Six six(const Vec3& a, const Vec3& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}

}  // namespace

void InertialFlow::set_spheres(std::span<const Sphere> owned, std::span<const WallGap> walls) {
  solver_.set_spheres(owned, walls);
}

/// Mass over the step, (a0/dt) m; what the former motions leave of it joins the force:
///
///     m (a0 V + a1 V_old + a2 V_older)/dt = F
std::vector<Ball> InertialFlow::heavy_balls(const std::array<Real, 3>& a, Real ratio) const {
  std::vector<Ball> balls = solver_.scaled_spheres();
  const Vec3& h = parts_.spacing;
  const Real unit = velocity_unit();
  for (std::size_t q = 0; q < balls.size(); ++q) {
    Ball& ball = balls[q];
    const Sphere& sphere = solver_.given_[q];
    const Real r = ball.body;
    const Real cells = 4.0 / 3 * M_PI * r * r * r * h.x * h.x / (h.y * h.z);
    ball.mass = sphere.density / density_ * cells * weight_;
    ball.moment = 0.4 * r * r * ball.mass;
    const Real turn = h.x / unit;
    const Six now = six(sphere.velocity / unit, sphere.spin * turn);
    const Six old = six(sphere.velocity_before / unit, sphere.spin_before * turn);
    for (std::size_t x = 0; x < 6 && !ball.held; ++x) {
      const Real kept = -(a[1] * now[x] + a[2] * old[x]) / a[0];
      ball.force[x] += (x < 3 ? ball.mass : ball.moment) * kept;
      ball.motion[x] = now[x] + ratio * (now[x] - old[x]);
    }
  }
  return balls;
}

/// The grid without spheres; unknowns end with those of the fluid.
void InertialFlow::lift_spheres() {
  if (spheres() != nullptr) {
    vacated_ = spheres()->cover().covered_cells();
    solver_.lift_spheres();
    parts_.unknowns.resize(parts_.equations.fluid_size());
  }
}

/// Covers the grid where the spheres of the last step were, as that step left it.
void InertialFlow::put_back_spheres() {
  RigidSpheres& all = *solver_.spheres_;
  all.place(solver_.scaled_spheres(), {});
  parts_.equations.attach(&all);
  Packed<double>& x = parts_.unknowns;
  x.resize(parts_.equations.size(), 0.0);
  for (std::size_t q = 0; q < all.set().owned(); ++q) {
    for (std::size_t i = 0; i < 6; ++i) {
      x[parts_.equations.fluid_size() + RigidSpheres::tail_of(q) + i] =
          all.set().balls()[q].motion[i];
    }
  }
}

/// Covers the grid, and makes guess and right-hand side those of the fluid outside.
void InertialFlow::place_spheres(const std::array<Real, 3>& a, Real ratio) {
  rows_ = drive_rows_;
  if (!solver_.spheres_) {
    return;
  }
  Operator& op = parts_.equations;
  Level& level = parts_.hierarchy.finest();
  Packed<double>& x = parts_.unknowns;
  RigidSpheres& all = *solver_.spheres_;
  all.place(heavy_balls(a, ratio), solver_.scaled_walls(), solver_.roughness_ / parts_.spacing.x,
            inertia_ / weight_);
  op.attach(&all);
  beside_.place(all);
  const std::size_t fluid = op.fluid_size();
  all.for_covered([&](const RigidFace& q, Real) {
    x[op.position(q.face.component, all.cover().index_of(q.face.at))] = 0;
  });
  x.resize(op.size(), 0.0);
  for (std::size_t q = 0; q < all.set().owned(); ++q) {
    for (std::size_t i = 0; i < 6; ++i) {
      x[fluid + RigidSpheres::tail_of(q) + i] = all.set().balls()[q].motion[i];
    }
  }
  op.load_unknowns(x);
  solver_.fill_vacated(vacated_);
  const auto take_pressure = [&](const std::vector<std::uint32_t>& cells) {
    for (const std::uint32_t at : cells) {
      const Int3 cell = all.cover().index_of(at);
      if (level.owns(3, cell)) {
        const auto here = op.position(3, cell);
        x[here] = old_[here] = level.push[at] != 0 ? level.p[at] : 0;
      }
    }
  };
  take_pressure(vacated_);
  take_pressure(all.cover().covered_cells());
  solver_.drive_on_ = all.take_drive(rows_);
  all.put_forces(rows_, solver_.drive_on_);
  for (Packed<double>* v : {&r_, &image_}) {
    v->assign(op.size(), 0.0);
  }
  part_.assign(op.size(), 0.0F);
  carried_.assign(op.size(), 0.0F);
}

/// Motions and forces of the step; covered faces get their velocity, which is the fluid's history when
/// a sphere leaves them.
void InertialFlow::find_motions() {
  found_.clear();
  if (spheres() == nullptr) {
    return;
  }
  Operator& op = parts_.equations;
  RigidSpheres& all = *spheres();
  Packed<double>& x = parts_.unknowns;
  const std::size_t fluid = op.fluid_size();
  op.load_unknowns(x);
  op.apply(image_);
  all.load_motion(x.data() + fluid);
  for (std::size_t q = 0; q < all.set().owned(); ++q) {
    const Ball& ball = all.set().balls()[q];
    const Six v = all.motion()[q];
    Six f = sum_of(all.rows()[q], solver_.drive_on_[q]);
    for (std::size_t i = 0; i < 6 && !ball.held; ++i) {
      f[i] += (i < 3 ? ball.mass : ball.moment) * v[i];
    }
    found_.push_back(solver_.in_si(v, f));
  }
  all.for_covered([&](const RigidFace& q, Real velocity) {
    x[op.position(q.face.component, all.cover().index_of(q.face.at))] = velocity;
  });
  extend_history();
}

/// Below a Stokes number of 1 the liquid stops the approach by itself.
void InertialFlow::find_closing_rate() {
  Real rate = 0;
  if (const RigidSpheres* all = spheres()) {
    for (const Lubrication& q : all->gaps()) {
      if (all->impact(q) * inertia_ / weight_ > 1) {
        rate = std::max(rate, all->closing_speed(q) / std::max(std::abs(q.gap), q.least));
      }
    }
  }
  closing_rate_ = parts_.comm.max(rate) * velocity_unit() / parts_.spacing.x;
}

/// Faces that the spheres may leave next: the fluid's velocity, extended under the surface.
void InertialFlow::extend_history() {
  Operator& op = parts_.equations;
  const Level& level = parts_.hierarchy.finest();
  RigidSpheres& all = *spheres();
  u_.load(parts_.hierarchy.finest(), op, parts_.unknowns, inlet_, u_);
  show_covered(u_);
  beside_.for_extended(all, u_, [&](int component, std::uint32_t at, Real velocity) {
    const Int3 index = all.cover().index_of(at);
    if (level.owns(component, index)) {
      parts_.unknowns[op.position(component, index)] = velocity;
    }
  });
}

/// Rigid velocities on covered faces, by the motions that are loaded.
void InertialFlow::show_covered(FaceVelocity& u) const {
  if (spheres() != nullptr) {
    spheres()->for_all_covered([&](int component, std::uint32_t at, Real velocity) {
      u.data(component)[at] = static_cast<float>(velocity);
    });
  }
}

}  // namespace porefines::flow
