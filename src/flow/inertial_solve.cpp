// SPDX-License-Identifier: MPL-2.0
// The nonlinear solve of one step of InertialFlow.
#include <cmath>

#include "flow/inertial_flow.hpp"

namespace porefines::flow {

namespace {

constexpr int width = grid::line_width;
constexpr Real vanishing = 1e-10;    ///< share of a direction's square that float can still tell
constexpr Real little_gain = 0.8;    ///< of the residual left: the cycle gained little
constexpr Real little_curved = 0.1;  ///< of the tolerance: what linear rows may miss
constexpr Real easy_weight = 1;      ///< of the time term, as of a link between faces: V cycles do
constexpr Real trusted = 1e-2;  ///< reduction after which the linearised residual is looked at anew

/// Sum of a b over lines, momentum and continuity apart, one accumulator per lane.
class RowSum {
 public:
  template <typename A, typename B>
  void add(const A* a, const B* b) {
    for (int c = 0; c < 3; ++c) {
      for (int l = 0; l < width; ++l) {
        momentum_[l] +=
            static_cast<double>(a[c * width + l]) * static_cast<double>(b[c * width + l]);
      }
    }
    for (int l = 0; l < width; ++l) {
      continuity_[l] +=
          static_cast<double>(a[3 * width + l]) * static_cast<double>(b[3 * width + l]);
    }
  }
  /// Rows of spheres count as momentum.
  template <typename A, typename B>
  void add_tail(const A* a, const B* b, std::size_t count) {
    for (std::size_t at = 0; at < count; ++at) {
      momentum_[at % width] += static_cast<double>(a[at]) * static_cast<double>(b[at]);
    }
  }
  template <typename A, typename B>
  void add_all(const A& a, const B& b, std::size_t fluid) {
    for (std::size_t at = 0; at < fluid; at += packed_width) {
      add(a.data() + at, b.data() + at);
    }
    add_tail(a.data() + fluid, b.data() + fluid, a.size() - fluid);
  }
  [[nodiscard]] double value(double factor) const {
    double total = 0;
    for (int l = 0; l < width; ++l) {
      total += factor * momentum_[l] + continuity_[l];
    }
    return total;
  }

 private:
  std::array<double, width> momentum_{};
  std::array<double, width> continuity_{};
};

}  // namespace

/// 1/d^2 in the bulk: momentum rows over their diagonal are velocities.
Real InertialFlow::row_factor() const {
  Real diagonal = weight_;
  for (const auto& w : parts_.hierarchy.finest().widths) {
    diagonal += w.size() > 1 ? 2 / (w.front() * w.front()) : 0;
  }
  return 1 / (diagonal * diagonal);
}

template <typename T>
Real InertialFlow::row_norm(const Packed<T>& rows) const {
  RowSum sum;
  sum.add_all(rows, rows, parts_.equations.fluid_size());
  return std::sqrt(parts_.comm.sum(sum.value(row_factor())));
}

Real InertialFlow::velocity_norm() const {
  const Packed<double>& x = parts_.unknowns;
  Real total = 0;
  for (std::size_t at = 0; at < old_.size(); at += packed_width) {
    for (int l = 0; l < 3 * width; ++l) {
      total += x[at + l] * x[at + l];
    }
  }
  return std::sqrt(parts_.comm.sum(total));
}

/// |u - u_old| / |u|.
Real InertialFlow::change() const {
  const Packed<double>& x = parts_.unknowns;
  Real total = 0;
  for (std::size_t at = 0; at < old_.size(); at += packed_width) {
    for (int l = 0; l < 3 * width; ++l) {
      const double d = x[at + l] - old_[at + l];
      total += d * d;
    }
  }
  const Real size = velocity_norm();
  return size > 0 ? std::sqrt(parts_.comm.sum(total)) / size : 0;
}

/// Does one float of every unknown tell the residual to a fifth of the tolerance? Rounding to half of 2^-23
/// at most, 0.3 of it in the mean square; u counts by its rows' diagonal and neighbours, p by its two cells.
bool InertialFlow::floats_do(Real tolerance) const {
  constexpr Real rounding = 0.3 / (1 << 23);
  constexpr Real counted_u = 3;  // of velocities in momentum and continuity, mean square
  constexpr Real counted_p = 6;  // differences along three axes
  constexpr Real share = 0.2;
  const Packed<double>& x = parts_.unknowns;
  Real u = 0;
  Real p = 0;
  for (std::size_t line = 0; line < old_.size(); line += packed_width) {
    for (int l = 0; l < 3 * width; ++l) {
      u += x[line + l] * x[line + l];
    }
    for (int l = 3 * width; l < packed_width; ++l) {
      p += x[line + l] * x[line + l];
    }
  }
  std::vector<Real> sums{u, p};
  parts_.comm.sum(sums);
  const Real error = counted_u * counted_u * sums[0] + counted_p * row_factor() * sums[1];
  return rounding * std::sqrt(error) < share * tolerance * std::sqrt(sums[0]);
}

/// r += c history, c being the time term's coefficient.
void InertialFlow::add_past() {
  const Level& level = parts_.hierarchy.finest();
  parts_.equations.for_each_line([&](int i, int j, int k, std::size_t line) {
    const std::ptrdiff_t face = level.block.at(i, j, k);
    for (int c = 0; c < 3; ++c) {
      if (!level.flows[c]) {
        continue;
      }
      const float* inverse = level.inverse_diagonal[c].data() + face;
      const std::size_t at = line + c * width;
      for (int l = 0; l < width; ++l) {
        const double history = past_[0] * old_[at + l] + past_[1] * older_[at + l];
        r_[at + l] += inverse[l] != 0 ? time_weight_[at + l] * history : 0;
      }
    }
  });
}

/// r = b + c (history - u) - K (u, p) - inertia A(u, u), in double; exactly: with the unknowns split into two floats.
/// Leaves the velocity in u_.
void InertialFlow::find_residual(const Packed<float>& b, bool exactly) {
  Operator& op = parts_.equations;
  const Packed<double>& x = parts_.unknowns;
  u_.load(parts_.hierarchy.finest(), op, x, inlet_, u_);
  if (spheres() != nullptr) {
    spheres()->load_motion(x.data() + op.fluid_size());
    show_covered(u_);
  }
  if (inertia_ != 0) {
    advection_.apply(op, u_, carried_);
  }
  if (spheres() != nullptr) {
    beside_.apply(*spheres(), u_, carried_);
  }
  op.load_unknowns(x);
  op.apply(r_);
  for (std::size_t at = 0; at < x.size(); ++at) {
    r_[at] = b[at] - inertia_ * carried_[at] - r_[at];
  }
  add_past();
  if (exactly) {
    for (std::size_t at = 0; at < x.size(); ++at) {
      part_[at] = static_cast<float>(x[at] - static_cast<double>(static_cast<float>(x[at])));
    }
    op.load_unknowns(part_);
    op.apply(image_);
    for (std::size_t at = 0; at < x.size(); ++at) {
      r_[at] -= image_[at];
    }
  }
}

/// A new direction z from the residual, or from the last image where that led nowhere, and its image
/// q = (K + inertia A'(u)) z.
void InertialFlow::search(bool stalled, Real size) {
  Operator& op = parts_.equations;
  Direction newest;
  if (!spare_.empty()) {
    newest = std::move(spare_.back());
    spare_.pop_back();
  }
  newest.z.resize(op.size());
  newest.q.resize(op.size());
  const auto load_sides = [&] {
    if (stalled) {
      op.load_right_hand_side(kept_.back().q, 1 / std::sqrt(kept_.back().square));
    } else {
      op.load_right_hand_side(r_, 1 / size);
    }
  };
  const int visits = weight_ > easy_weight ? 1 : 2;
  cycle(parts_.hierarchy, load_sides, op.spheres(), visits);
  op.store_unknowns(newest.z);
  op.apply(newest.q);
  if (inertia_ != 0) {
    add_carriage(newest);
  }
  kept_.push_back(std::move(newest));
}

/// What the direction carries and is carried by, to its image.
void InertialFlow::add_carriage(Direction& direction) {
  Operator& op = parts_.equations;
  z_.load(parts_.hierarchy.finest(), op, direction.z, {}, u_);
  show_covered(z_);
  advection_.change(op, u_, z_, carried_);
  if (spheres() != nullptr) {
    beside_.change(*spheres(), u_, z_, carried_);
  }
  const auto inertia = static_cast<float>(inertia_);
  for (std::size_t at = 0; at < direction.q.size(); ++at) {
    direction.q[at] += inertia * carried_[at];
  }
}

/// The oldest ones go; their memory stays for those to come.
void InertialFlow::drop_directions(std::size_t most) {
  while (kept_.size() > most) {
    spare_.push_back(std::move(kept_.front()));
    kept_.pop_front();
  }
}

/// Makes the newest direction orthogonal to the ones before and goes along it. @return |r| as a velocity
Real InertialFlow::descend(std::size_t most) {
  const Real factor = row_factor();
  Direction& newest = kept_.back();
  const std::size_t before = kept_.size() - 1;
  std::vector<RowSum> sums(2 + before);
  const std::size_t fluid = parts_.equations.fluid_size();
  const std::size_t tail = r_.size() - fluid;
  for (std::size_t at = 0; at < fluid; at += packed_width) {
    sums[0].add(newest.q.data() + at, newest.q.data() + at);
    sums[1].add(r_.data() + at, newest.q.data() + at);
    for (std::size_t s = 0; s < before; ++s) {
      sums[2 + s].add(newest.q.data() + at, kept_[s].q.data() + at);
    }
  }
  sums[0].add_tail(newest.q.data() + fluid, newest.q.data() + fluid, tail);
  sums[1].add_tail(r_.data() + fluid, newest.q.data() + fluid, tail);
  for (std::size_t s = 0; s < before; ++s) {
    sums[2 + s].add_tail(newest.q.data() + fluid, kept_[s].q.data() + fluid, tail);
  }
  std::vector<Real> dots;
  for (const RowSum& sum : sums) {
    dots.push_back(sum.value(factor));
  }
  parts_.comm.sum(dots);
  newest.square = dots[0];
  for (std::size_t s = 0; s < before; ++s) {
    newest.square -= dots[2 + s] * dots[2 + s] / kept_[s].square;
  }
  const bool nothing_new = newest.square < vanishing * dots[0];
  std::vector<float> beta(before, 0.0F);
  if (nothing_new) {
    newest.square = dots[0];
  }
  for (std::size_t s = 0; s < before && !nothing_new; ++s) {
    beta[s] = static_cast<float>(dots[2 + s] / kept_[s].square);
  }
  const Real alpha = newest.square > 0 ? dots[1] / newest.square : 0;
  Packed<double>& x = parts_.unknowns;
  RowSum left;
  const auto go = [&](std::size_t at, int count) {
    float* z = newest.z.data() + at;
    float* q = newest.q.data() + at;
    for (std::size_t s = 0; s < before; ++s) {
      const float* zs = kept_[s].z.data() + at;
      const float* qs = kept_[s].q.data() + at;
      for (int l = 0; l < count; ++l) {
        z[l] -= beta[s] * zs[l];
        q[l] -= beta[s] * qs[l];
      }
    }
    for (int l = 0; l < count; ++l) {
      x[at + l] += alpha * static_cast<double>(z[l]);
      r_[at + l] -= alpha * static_cast<double>(q[l]);
    }
  };
  for (std::size_t at = 0; at < fluid; at += packed_width) {
    go(at, packed_width);
    left.add(r_.data() + at, r_.data() + at);
  }
  go(fluid, static_cast<int>(tail));
  left.add_tail(r_.data() + fluid, r_.data() + fluid, tail);
  drop_directions(nothing_new ? 1 : most);
  return std::sqrt(parts_.comm.sum(left.value(factor)));
}

StepReport InertialFlow::solve(const Packed<float>& b, const StepOptions& options) {
  StepReport report;
  Real reference = velocity_norm();
  while (true) {
    find_residual(b, !floats_do(options.tolerance));
    drop_directions(0);
    ++report.evaluations;
    const Real first = row_norm(r_);
    reference = reference > 0 ? reference : first;
    Real size = first;
    const auto small = [&] { return size <= options.tolerance * reference; };
    const auto exhausted = [&] {
      return report.cycles >= options.max_cycles || !std::isfinite(size);
    };
    // What the linear rows miss is quadratic in the change that they ask for.
    const bool linear = first * first <= little_curved * options.tolerance * reference * reference;
    const Real floor = linear ? 0 : trusted * first;
    bool stalled = false;
    while (size > floor && !exhausted() && (report.cycles == 0 || !small())) {
      search(stalled, size);
      const Real before = size;
      size = descend(static_cast<std::size_t>(options.directions));
      stalled = size > little_gain * before;
      ++report.cycles;
    }
    report.residual = reference > 0 ? size / reference : 0;
    report.converged = small();
    const bool known = linear || size > floor;
    if ((report.converged && known) || exhausted() ||
        (options.interrupted && options.interrupted())) {
      return report;
    }
  }
}

}  // namespace porefines::flow
