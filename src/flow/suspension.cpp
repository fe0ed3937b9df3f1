// SPDX-License-Identifier: MPL-2.0
// StokesSolver with rigid spheres.
#include <algorithm>
#include <cmath>

#include "flow/smoother.hpp"
#include "flow/stokes.hpp"

namespace porefines::flow {

namespace {

constexpr Real calibration = 0.26;  ///< cells squared: radius that the grid sees - radius, times D
constexpr int guess_sweeps = 2;     ///< of the finest level before the first residual
constexpr int vacated_layers = 3;   ///< of cells that a sphere may leave in one step

Six six(const Vec3& a, const Vec3& b) {
  return {a.x, a.y, a.z, b.x, b.y, b.z};
}

}  // namespace

void StokesSolver::set_spheres(std::span<const Sphere> owned, std::span<const WallGap> walls) {
  given_.assign(owned.begin(), owned.end());
  walls_.assign(walls.begin(), walls.end());
  if (!spheres_) {
    spheres_ = std::make_unique<RigidSpheres>(comm_, *operator_, *friction_, spacing_ / spacing_.x,
                                              boundaries_);
  }
}

/// [Pa/m] force density, or viscous stress over radius, that moves the spheres by itself.
Real StokesSolver::sphere_scale() const {
  Real scale = 0;
  for (const Sphere& q : given_) {
    const Real volume = 4.0 / 3 * M_PI * q.radius * q.radius * q.radius;
    const Real speed = norm(q.velocity) + q.radius * norm(q.spin);
    scale = std::max({scale, norm(q.force) / volume, norm(q.torque) / (volume * q.radius),
                      q.held ? viscosity_ * speed / (q.radius * q.radius) : 0});
  }
  return comm_.max(scale);
}

std::vector<Ball> StokesSolver::scaled_spheres() const {
  const Real h = spacing_.x;
  const Real velocity_unit = scale_ * h * h / viscosity_;
  const Real force_unit = scale_ * spacing_.x * spacing_.y * spacing_.z;
  std::vector<Ball> balls;
  for (const Sphere& q : given_) {
    Ball ball;
    ball.id = q.id;
    ball.centre = q.position / h;
    ball.radius = q.radius / h;
    ball.body = ball.radius;
    ball.radius += calibration / (2 * ball.radius);
    ball.held = q.held;
    ball.force = six(q.force / force_unit, q.torque / (force_unit * h));
    ball.motion = six(q.velocity / velocity_unit, q.spin * (h / velocity_unit));
    balls.push_back(ball);
  }
  return balls;
}

std::vector<WallGap> StokesSolver::scaled_walls() const {
  std::vector<WallGap> walls = walls_;
  for (WallGap& q : walls) {
    q.gap /= spacing_.x;
  }
  return walls;
}

/// Pressure of cells that spheres have left: the mean of open neighbours, layer by layer. Their
/// faces keep the sphere's velocity. Stale values would make a warm solve converge to a wrong answer.
void StokesSolver::fill_vacated(const std::vector<std::uint32_t>& vacated) {
  Level& level = hierarchy_.finest();
  level.lend_sides(false);
  Floats& known = level.rg;
  for (std::size_t at = 0; at < known.size(); ++at) {
    known[at] = level.push[at] != 0 ? 1.0F : 0.0F;
    level.p[at] = level.push[at] != 0 ? level.p[at] : 0.0F;
  }
  for (const std::uint32_t at : vacated) {
    known[at] = 0;
  }
  for (int layer = 0; layer < vacated_layers; ++layer) {
    const std::array<float*, 2> fields{level.p.data(), known.data()};
    level.halo.exchange(fields, 1);
    std::vector<std::pair<std::uint32_t, float>> found;
    for (const std::uint32_t at : vacated) {
      if (level.push[at] == 0 || known[at] != 0 || !level.owns(3, spheres_->cover().index_of(at))) {
        continue;
      }
      float sum = 0;
      float count = 0;
      for (int a = 0; a < 3; ++a) {
        for (const std::ptrdiff_t there :
             {at - level.block.stride(a), at + level.block.stride(a)}) {
          sum += known[there] * level.p[there];
          count += known[there];
        }
      }
      if (count > 0) {
        found.emplace_back(at, sum / count);
      }
    }
    for (const auto& [at, p] : found) {
      level.p[at] = p;
      known[at] = 1;
    }
  }
}

/// Held spheres resist like grains: coarse levels are made anew when they change. (Free ones hardly
/// resist; coarse levels take them for fluid.)
void StokesSolver::show_held_to_coarse_levels() {
  std::vector<std::pair<std::uint64_t, Vec3>> held;
  std::vector<Ball> balls;
  for (const Ball& ball : scaled_spheres()) {
    if (ball.held) {
      held.emplace_back(ball.id, ball.centre);
      balls.push_back(ball);
    }
  }
  if (comm_.sum(static_cast<Index>(held != held_)) == 0) {
    return;
  }
  held_ = held;
  spheres_->place(balls, {});
  hierarchy_.build();
}

/// The grid and the operator without spheres.
void StokesSolver::lift_spheres() {
  spheres_->lift();
  operator_->attach(nullptr);
}

/// Those of the last set_spheres, after lift_spheres().
void StokesSolver::place_given() {
  spheres_->place(scaled_spheres(), scaled_walls(), roughness_ / spacing_.x);
  operator_->attach(spheres_.get());
}

/// Places the spheres; leaves the right-hand side in b and the first guess in x_.
void StokesSolver::place_and_guess(const Drive& drive, Packed<float>& b, bool warm) {
  Level& level = hierarchy_.finest();
  Operator& op = *operator_;
  std::vector<std::uint32_t> vacated;
  if (warm) {
    op.load_unknowns(x_);
    spheres_->write_faces(true);
    vacated = spheres_->cover().covered_cells();
  }
  lift_spheres();
  b = right_hand_side(drive);
  show_held_to_coarse_levels();  // writes over the unknowns of all levels
  if (!warm) {
    op.load_unknowns(first_guess(drive));
  }
  place_given();
  level.exchange_unknowns(sweep_depth);
  spheres_->write_faces(false);
  fill_vacated(vacated);
  drive_on_ = spheres_->take_drive(b);
  spheres_->put_forces(b, drive_on_);
  if (warm) {
    op.load_right_hand_side(b, 1);
    level.exchange_sides(sweep_depth);
    spheres_->show_motion();
    smooth_finest(hierarchy_, spheres_.get(), guess_sweeps);
  }
  x_.assign(op.size(), 0.0);
  op.store_unknowns(x_);
}

StokesSolver::Memory StokesSolver::remember() const {
  return {{x_.begin(), x_.end()}, scale_, given_};
}

void StokesSolver::recall(const Memory& memory) {
  set_spheres(memory.spheres);
  scale_ = memory.scale;
  lift_spheres();
  show_held_to_coarse_levels();
  place_given();
  if (memory.unknowns.size() != operator_->size()) {
    x_.clear();  // of another number of ranks: from rest
    return;
  }
  x_.assign(memory.unknowns.begin(), memory.unknowns.end());
  operator_->load_unknowns(x_);  // with the motions that were found
}

SolveReport StokesSolver::solve_suspension(const Drive& drive, SolveOptions options) {
  const Real before = scale_;
  scale_ = std::max(force_scale(drive), sphere_scale());
  const bool warm = !x_.empty();
  if (warm && before != scale_) {
    for (double& value : x_) {
      value *= before / scale_;
    }
  }
  Packed<float> b;
  place_and_guess(drive, b, warm);
  Real squares = reference_norm(drive, b);
  squares *= squares;
  Real own = 0;
  for (std::size_t at = operator_->fluid_size(); at < operator_->size(); ++at) {
    own += static_cast<Real>(b[at]) * b[at];
  }
  options.reference = std::sqrt(squares + comm_.sum(own));
  const SolveReport report = solve_gcr(comm_, hierarchy_, *operator_, b, x_, options);
  operator_->load_unknowns(x_);
  Packed<double> rows(operator_->size());
  operator_->apply(rows);  // motions and forces of what was found
  contact_on_ = spheres_->contact_forces();
  return report;
}

std::vector<SphereMotion> StokesSolver::sphere_motions() const {
  std::vector<SphereMotion> out;
  for (std::size_t q = 0; q < given_.size(); ++q) {
    out.push_back(in_si(spheres_->motion()[q], sum_of(spheres_->rows()[q], drive_on_[q])));
    const Six& c = contact_on_[q];
    out.back().contact = scale_ * spacing_.x * spacing_.y * spacing_.z * Vec3{c[0], c[1], c[2]};
  }
  return out;
}

SphereMotion StokesSolver::in_si(const Six& v, const Six& f) const {
  const Real h = spacing_.x;
  const Real velocity_unit = scale_ * h * h / viscosity_;
  const Real force_unit = scale_ * spacing_.x * spacing_.y * spacing_.z;
  SphereMotion m;
  m.velocity = velocity_unit * Vec3{v[0], v[1], v[2]};
  m.spin = velocity_unit / h * Vec3{v[3], v[4], v[5]};
  m.force = force_unit * Vec3{f[0], f[1], f[2]};
  m.torque = force_unit * h * Vec3{f[3], f[4], f[5]};
  return m;
}

}  // namespace porefines::flow
