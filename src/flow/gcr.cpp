// SPDX-License-Identifier: MPL-2.0
#include "flow/gcr.hpp"

#include <cmath>
#include <deque>

namespace porefines::flow {

namespace {

constexpr int lanes = grid::line_width;
constexpr Real vanishing = 1e-10;  ///< share of a direction's square that float can still tell
constexpr Real little_gain = 0.7;  ///< of the residual left: the cycle gained little
constexpr Real slow_gain = 0.35;   ///< of the residual left: another direction is called for

/// Sum of products with one accumulator per lane: vectorised, and the same on every run.
class Accumulator {
 public:
  template <typename A, typename B>
  void add(const A* a, const B* b) {
    for (int l = 0; l < lanes; ++l) {
      sum_[l] += static_cast<double>(a[l]) * static_cast<double>(b[l]);
    }
  }
  [[nodiscard]] double value() const {
    double total = 0;
    for (const double lane : sum_) {
      total += lane;
    }
    return total;
  }

 private:
  std::array<double, lanes> sum_{};
};

struct Direction {
  Packed<float> z;
  Packed<float> q;
  Real norm_squared = 0;
};

Real norm(const par::Communicator& comm, const Packed<float>& v) {
  Accumulator sum;
  for (std::size_t at = 0; at < v.size(); at += lanes) {
    sum.add(v.data() + at, v.data() + at);
  }
  return std::sqrt(comm.sum(sum.value()));
}

/// (q, q), (r, q) and (q, Q_s) of every kept direction, in one pass and one reduction.
std::vector<Real> products(const par::Communicator& comm, const Packed<float>& q,
                           const Packed<float>& r, const std::deque<Direction>& kept) {
  std::vector<Accumulator> sums(2 + kept.size());
  for (std::size_t at = 0; at < q.size(); at += lanes) {
    sums[0].add(q.data() + at, q.data() + at);
    sums[1].add(r.data() + at, q.data() + at);
    for (std::size_t s = 0; s < kept.size(); ++s) {
      sums[2 + s].add(q.data() + at, kept[s].q.data() + at);
    }
  }
  std::vector<Real> values;
  for (const Accumulator& sum : sums) {
    values.push_back(sum.value());
  }
  comm.sum(values);
  return values;
}

/// Orthogonalises the newest direction and takes the step; returns the sum of r^2 on this rank.
Real step(Direction& newest, const std::deque<Direction>& kept, const std::vector<float>& beta,
          Real alpha, Packed<double>& x, Packed<float>& r) {
  Accumulator sum;
  for (std::size_t at = 0; at < x.size(); at += lanes) {
    float* z = newest.z.data() + at;
    float* q = newest.q.data() + at;
    for (std::size_t s = 0; s < kept.size(); ++s) {
      const float* zs = kept[s].z.data() + at;
      const float* qs = kept[s].q.data() + at;
      for (int l = 0; l < lanes; ++l) {
        z[l] -= beta[s] * zs[l];
        q[l] -= beta[s] * qs[l];
      }
    }
    for (int l = 0; l < lanes; ++l) {
      x[at + l] += alpha * static_cast<double>(z[l]);
      r[at + l] = static_cast<float>(r[at + l] - alpha * static_cast<double>(q[l]));
    }
    sum.add(r.data() + at, r.data() + at);
  }
  return sum.value();
}

}  // namespace

SolveReport solve_gcr(const par::Communicator& comm, Hierarchy& hierarchy, Operator& k,
                      const Packed<float>& b, Packed<double>& x, const SolveOptions& options) {
  Packed<float> r(k.size());
  k.residual(b, x, r);
  Real size = norm(comm, r);
  const Real reference = options.reference > 0 ? options.reference : size;
  SolveReport report;
  std::deque<Direction> kept;
  int allowed = options.directions;
  bool exact = true;  // r is b - K x to double precision
  int stalled = 0;    // steps in a row that gained little
  while (true) {
    report.residual = reference > 0 ? size / reference : 0;
    if (report.residual <= options.tolerance && !exact) {
      kept.clear();  // before the residual needs room of its own
      k.residual(b, x, r);
      size = norm(comm, r);
      exact = true;
      stalled = 0;
      continue;
    }
    report.converged = report.residual <= options.tolerance;
    const bool stop = report.converged || report.cycles >= options.max_cycles ||
                      !std::isfinite(size) || (options.interrupted && options.interrupted());
    if (stop) {
      return report;
    }
    if (stalled > allowed) {  // what can be kept does not hold the residual: begin anew with it
      kept.clear();
      stalled = 0;
    }
    Direction newest;
    if (kept.size() > static_cast<std::size_t>(allowed)) {
      newest = std::move(kept.front());
      kept.pop_front();
    }
    newest.z.resize(k.size());
    newest.q.resize(k.size());
    const auto load_sides = [&] {
      if (stalled > 0) {
        k.load_right_hand_side(kept.back().q, 1 / std::sqrt(kept.back().norm_squared));
      } else {
        k.load_right_hand_side(r, 1 / size);
      }
    };
    cycle(hierarchy, load_sides, k.spheres());
    k.store_unknowns(newest.z);
    k.apply(newest.q);
    const std::vector<Real> dots = products(comm, newest.q, r, kept);
    newest.norm_squared = dots[0];
    std::vector<float> beta;
    for (std::size_t s = 0; s < kept.size(); ++s) {
      beta.push_back(static_cast<float>(dots[2 + s] / kept[s].norm_squared));
      newest.norm_squared -= dots[2 + s] * dots[2 + s] / kept[s].norm_squared;
    }
    if (newest.norm_squared < vanishing * dots[0]) {  // nothing new in this direction
      kept.clear();
      beta.clear();
      newest.norm_squared = dots[0];
    }
    const Real alpha = dots[1] / newest.norm_squared;
    const Real before = size;
    size = std::sqrt(comm.sum(step(newest, kept, beta, alpha, x, r)));
    stalled = size > little_gain * before ? stalled + 1 : 0;
    if (size > slow_gain * before && allowed < options.most_directions) {
      ++allowed;
    }
    exact = false;
    kept.push_back(std::move(newest));
    ++report.cycles;
    if (options.progress) {
      options.progress(report.cycles, size / reference);
    }
  }
}

}  // namespace porefines::flow
