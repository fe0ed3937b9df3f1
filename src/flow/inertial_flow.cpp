// SPDX-License-Identifier: MPL-2.0
#include "flow/inertial_flow.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::flow {

namespace {

constexpr int width = grid::line_width;

/// a0, a1, a2 of the time term; `ratio` = this step over the last.
std::array<Real, 3> coefficients(TimeScheme scheme, bool first, Real ratio) {
  if (scheme == TimeScheme::midpoint) {
    return {2, -2, 0};
  }
  if (scheme == TimeScheme::euler || first) {
    return {1, -1, 0};
  }
  return {(1 + 2 * ratio) / (1 + ratio), -(1 + ratio), ratio * ratio / (1 + ratio)};
}

}  // namespace

InertialFlow::InertialFlow(StokesSolver& solver, Real density, Scheme scheme, TimeScheme time,
                           Real speed, First first)
    : solver_(solver),
      parts_(solver.parts()),
      density_(density),
      scheme_in_time_(time),
      base_(parts_.friction.excess),
      base_inverse_(parts_.hierarchy.finest().inverse_diagonal),
      advection_(parts_.hierarchy.finest(), parts_.boundaries, scheme),
      beside_(parts_.hierarchy.finest()),
      u_(parts_.hierarchy.finest(), parts_.boundaries),
      z_(parts_.hierarchy.finest(), parts_.boundaries) {
  const Real h = parts_.spacing.x;
  const Real before = parts_.scale;
  parts_.scale = speed * parts_.viscosity / (h * h);
  inertia_ = scheme == Scheme::none ? 0 : density * speed * h / parts_.viscosity;
  const std::size_t size = parts_.equations.size();
  const bool known = first == First::solved && parts_.unknowns.size() == size;
  parts_.unknowns.resize(size);
  for (double& value : parts_.unknowns) {
    value *= known ? before / parts_.scale : 0;
  }
  for (Packed<double>* v : {&old_, &older_, &r_, &image_, &time_weight_}) {
    v->assign(size, 0.0);
  }
  part_.assign(size, 0.0F);
  carried_.assign(size, 0.0F);
  weigh_inlets();
}

/// Faces of an inlet hold no unknowns, but carry momentum in: with weight 1 where fluid is behind.
void InertialFlow::weigh_inlets() {
  Level& level = parts_.hierarchy.finest();
  const grid::Block& b = level.block;
  for (int a = 0; a < 3; ++a) {
    for (const bool high : {false, true}) {
      const bool mine = high ? b.start[a] + b.n[a] == b.global[a] : b.start[a] == 0;
      if (!mine || parts_.boundaries.at(a, high) != FaceKind::velocity) {
        continue;
      }
      grid::for_layer(b, a, high ? b.n[a] : 0, [&](std::ptrdiff_t at) { level.weight[a][at] = 1; });
    }
  }
}

Real InertialFlow::velocity_unit() const {
  return parts_.velocity_unit();
}

void InertialFlow::set_velocity(const std::function<Vec3(const Vec3&)>& velocity) {
  const Real unit = velocity_unit();
  parts_.equations.for_each([&](int c, int i, int j, int k, std::size_t at) {
    const Vec3 x = parts_.place(c, {i, j, k});
    parts_.unknowns[at] = c < 3 ? velocity(x)[c] / unit : 0;
  });
  states_ = 1;
}

std::array<Real, 6> InertialFlow::inlet_values(const Drive& drive) const {
  std::array<Real, 6> values{};
  for (std::size_t face = 0; face < 6; ++face) {
    const bool given = parts_.boundaries.kind[face] == FaceKind::velocity;
    values[face] = given ? drive.face_value[face] / velocity_unit() : 0;
  }
  return values;
}

/// Weight of u in the momentum rows: on the diagonal of every level, on the coarse ones through the
/// mobility. Coarse levels of a weight not too far away do as well.
void InertialFlow::set_weight(Real weight) {
  constexpr Real near = 4.0 / 3;
  if (weight == weight_) {
    return;
  }
  weight_ = weight;
  Level& level = parts_.hierarchy.finest();
  for (int c = 0; c < 3; ++c) {
    for (std::size_t at = 0; at < level.block.size; ++at) {
      if (base_inverse_[c][at] != 0) {
        const float base = base_[c][at];
        const auto now = static_cast<float>(base + weight * level.weight[c][at]);
        parts_.friction.excess[c][at] = now;
        const Real diagonal = 1 / static_cast<Real>(base_inverse_[c][at]) - base + now;
        level.inverse_diagonal[c][at] = static_cast<float>(1 / diagonal);
      }
    }
  }
  parts_.equations.for_each_line([&](int i, int j, int k, std::size_t line) {
    const std::ptrdiff_t face = level.block.at(i, j, k);
    for (int c = 0; c < 3; ++c) {
      for (int l = 0; l < width; ++l) {
        time_weight_[line + c * width + l] =
            static_cast<double>(parts_.friction.excess[c][face + l]) - base_[c][face + l];
      }
    }
  });
  finish_level(level);
  if (built_ == 0 || weight > near * built_ || built_ > near * weight) {
    parts_.hierarchy.build();
    built_ = weight;
  }
}

/// First guess, extrapolated from the last times; the last step is kept. With s, s0 and s1 the steps to come,
/// of the last and of the one before, a parabola through three times is
///
///     x = (s + s0)(s + s0 + s1)/(s0 (s0 + s1)) x_0 - s (s + s0 + s1)/(s0 s1) x_1 + s (s + s0)/((s0 + s1) s1) x_2
void InertialFlow::find_guess(Real step) {
  Packed<double>& x = parts_.unknowns;
  const Real s0 = last_step_;
  const Real s1 = step_before_;
  const bool bends = bends_guess();
  const bool moves = states_ > 1;
  const Real w1 = bends ? -step * (step + s0 + s1) / (s0 * s1) : moves ? -step / s0 : 0;
  const Real w2 = bends ? step * (step + s0) / ((s0 + s1) * s1) : 0;
  const Real share =
      scheme_in_time_ == TimeScheme::midpoint ? 0.5 : 1;  // of the step, for velocity
  const auto go = [&](std::size_t first, int count, Real part) {
    for (std::size_t at = first; at < first + static_cast<std::size_t>(count); ++at) {
      const double now = x[at];
      x[at] += part * (w1 * (old_[at] - now) + w2 * (older_[at] - now));
      older_[at] = old_[at];
      old_[at] = now;
    }
  };
  for (std::size_t line = 0; line < old_.size(); line += packed_width) {
    go(line, 3 * width, share);
    go(line + 3 * width, width, 1);
  }
}

/// Where no face gives a pressure its mean is nobody's: without this the guess lets it drift for ever.
void InertialFlow::level_pressure() {
  const auto& kinds = parts_.boundaries.kind;
  if (std::any_of(kinds.begin(), kinds.end(), gives_pressure)) {
    return;
  }
  const Level& level = parts_.hierarchy.finest();
  Packed<double>& x = parts_.unknowns;
  std::vector<Real> sums(2, 0);  // of the pressure, of cells
  const auto for_cells = [&](const auto& visit) {
    parts_.equations.for_each([&](int c, int i, int j, int k, std::size_t at) {
      if (c == 3 && level.push[level.block.at(i, j, k)] != 0) {
        visit(at);
      }
    });
  };
  for_cells([&](std::size_t at) {
    sums[0] += x[at];
    sums[1] += 1;
  });
  parts_.comm.sum(sums);
  const Real mean = sums[1] > 0 ? sums[0] / sums[1] : 0;
  for_cells([&](std::size_t at) { x[at] -= mean; });
}

/// Rows and inlets of a drive, anew where it changed.
void InertialFlow::show_drive(const Drive& drive) {
  if (!drive_ || !(*drive_ == drive)) {
    drive_rows_ = solver_.right_hand_side(drive);
    inlet_ = inlet_values(drive);
    drive_ = drive;
  }
}

std::array<Real, 3> InertialFlow::time_weights(Real step) const {
  return coefficients(scheme_in_time_, states_ == 1, last_step_ > 0 ? step / last_step_ : 1);
}

StepReport InertialFlow::advance(Real step, const Drive& drive, const StepOptions& options) {
  const Real ratio = last_step_ > 0 ? step / last_step_ : 1;
  const std::array<Real, 3> a = time_weights(step);
  const auto [a0, a1, a2] = a;
  const Real h = parts_.spacing.x;
  lift_spheres();
  set_weight(a0 * density_ * h * h / (parts_.viscosity * step));
  find_guess(step);
  past_ = {-a1 / a0, -a2 / a0};
  show_drive(drive);
  place_spheres(a, ratio);
  const StepReport report = solve(rows_, options);
  level_pressure();
  find_motions();
  find_closing_rate();
  if (scheme_in_time_ == TimeScheme::midpoint) {
    Packed<double>& x = parts_.unknowns;
    for (std::size_t line = 0; line < old_.size(); line += packed_width) {
      for (std::size_t at = line; at < line + 3 * width; ++at) {
        x[at] = 2 * x[at] - old_[at];
      }
    }
  }
  time_ += step;
  step_before_ = last_step_;
  last_step_ = step;
  states_ = std::min(states_ + 1, 3);
  return report;
}

void InertialFlow::show_velocity(const Drive& drive) {
  show_drive(drive);
  u_.load(parts_.hierarchy.finest(), parts_.equations, parts_.unknowns, inlet_, u_);
  show_covered(u_);
}

Real InertialFlow::crossing_rate() {
  const Level& level = parts_.hierarchy.finest();
  const grid::Block& b = level.block;
  u_.load(parts_.hierarchy.finest(), parts_.equations, parts_.unknowns, inlet_, u_);
  float fastest = 0;
  for (int k = 0; k < b.n[2]; ++k) {
    for (int j = 0; j < b.n[1]; ++j) {
      for (int i = 0; i < b.n[0]; ++i) {
        const std::ptrdiff_t at = b.at(i, j, k);
        float sum = 0;
        for (int a = 0; a < 3; ++a) {
          const float* u = u_.data(a) + at;
          sum += (std::abs(u[0]) + std::abs(u[b.stride(a)])) *
                 static_cast<float>(0.5 / level.widths[a].front());
        }
        fastest = std::max(fastest, sum);
      }
    }
  }
  return parts_.comm.max(static_cast<Real>(fastest)) * velocity_unit() / parts_.spacing.x;
}

Real InertialFlow::kinetic_energy() const {
  const Level& level = parts_.hierarchy.finest();
  Real sum = 0;
  parts_.equations.for_each([&](int c, int i, int j, int k, std::size_t at) {
    const Real u = parts_.unknowns[at];
    sum += c < 3 ? level.weight[c][level.block.at(i, j, k)] * u * u : 0;
  });
  const Vec3& h = parts_.spacing;
  const Real unit = velocity_unit();
  return parts_.comm.sum(sum) * unit * unit * density_ / 2 * h.x * h.y * h.z;
}

/// Calls visit(place in a packed vector, place among the cells' columns) for every unknown, those that
/// spheres cover included: they hold the history of what spheres leave.
template <typename Visit>
void InertialFlow::for_columns(const Visit& visit) const {
  const Level& level = parts_.hierarchy.finest();
  const Int3& n = level.block.n;
  const auto visit_one = [&](int c, Int3 cell, std::size_t at) {
    if (cell[0] > n[0] || !level.owns(c, cell)) {
      return;
    }
    int column = c < 3 ? c : 6;
    if (c < 3 && cell[c] == n[c]) {
      --cell[c];
      column = 3 + c;
    }
    const Index place = cell[0] + Index{n[0]} * (cell[1] + Index{n[1]} * cell[2]);
    visit(at, static_cast<std::size_t>(place * columns + column));
  };
  parts_.equations.for_each_line([&](int i, int j, int k, std::size_t line) {
    for (int c = 0; c < 4; ++c) {
      for (int l = 0; l < width; ++l) {
        visit_one(c, {i + l, j, k}, line + c * width + l);
      }
    }
  });
}

std::vector<Real> InertialFlow::of_cells(const Packed<double>& x) const {
  const grid::Block& b = parts_.hierarchy.finest().block;
  std::vector<Real> cells(static_cast<std::size_t>(b.cells() * columns), 0);
  for_columns([&](std::size_t at, std::size_t place) { cells[place] = x[at]; });
  return cells;
}

void InertialFlow::from_cells(const std::vector<Real>& cells, Packed<double>& x) const {
  std::fill(x.begin(), x.end(), 0.0);
  for_columns([&](std::size_t at, std::size_t place) { x[at] = cells.at(place); });
}

InertialFlow::Memory InertialFlow::remember() const {
  return {of_cells(parts_.unknowns),
          of_cells(old_),
          bends_guess() ? of_cells(older_) : std::vector<Real>{},
          time_,
          last_step_,
          step_before_,
          built_,
          closing_rate_,
          states_};
}

void InertialFlow::recall(const Memory& memory, std::span<const Sphere> spheres) {
  lift_spheres();
  from_cells(memory.now, parts_.unknowns);
  from_cells(memory.old, old_);
  if (!memory.older.empty()) {
    from_cells(memory.older, older_);
  }
  time_ = memory.time;
  last_step_ = memory.step;
  step_before_ = memory.before;
  closing_rate_ = memory.closing;
  states_ = memory.states;
  if (memory.built > 0) {
    set_weight(memory.built);  // the coarse levels are those of this weight
  }
  if (parts_.comm.sum(static_cast<Index>(spheres.size())) > 0) {
    set_spheres(spheres);
    put_back_spheres();
  }
}

InertialFlow::SteadyReport InertialFlow::settle(const Drive& drive, const StepOptions& options,
                                                int max_steps) {
  constexpr int easy = 12;  // cycles of a step that may grow
  constexpr int hard = 40;  // of one that must shrink
  SteadyReport report;
  scheme_in_time_ = TimeScheme::euler;
  Real courant = 1;
  while (report.steps < max_steps && !report.converged) {
    const Real rate = crossing_rate();
    const Real step = rate > 0 ? courant / rate
                               : density_ * parts_.spacing.x * parts_.spacing.x / parts_.viscosity;
    states_ = 1;  // no extrapolation: it would undo the damping
    const StepReport one = advance(step, drive, options);
    report.cycles += one.cycles;
    ++report.steps;
    report.residual = change() / step / crossing_rate();
    report.converged = one.converged && report.residual <= options.tolerance;
    if (options.interrupted && options.interrupted()) {
      break;
    }
    courant *= one.cycles <= easy ? 1.5 : one.cycles >= hard ? 0.5 : 1;
  }
  return report;
}

}  // namespace porefines::flow
