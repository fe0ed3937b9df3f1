// SPDX-License-Identifier: MPL-2.0
#include "vision/tracers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "core/error.hpp"
#include "core/random.hpp"

namespace porefines::vision {
namespace {

constexpr int most_tries = 100000;
constexpr int polite_tries = 2000;  // then others may be near
constexpr Real slowest = 0.01;  // of the fastest at the inlet: what is slower would rest in a film

struct Tracer {
  Index id = 0;
  Vec3 x;
  bool stuck = false;
};

struct Inlet {
  int axis = 0;
  bool from_low = true;
  Real fastest = 0;  ///< [m/s] along the axis on the inlet plane
};

class Nursery {
 public:
  Nursery(const FlowField& field, const TracerSpec& spec)
      : field_(field), spec_(spec), draws_(spec.seed, Stream::place, 0x747261636572) {
    Vec3 sum;
    for (std::size_t k = 0; k + 2 < field.velocity.values.size(); k += 3) {
      sum += Vec3{field.velocity.values[k], field.velocity.values[k + 1],
                  field.velocity.values[k + 2]};
    }
    inlet_.axis = std::abs(sum.x) >= std::abs(sum.y) ? 0 : 1;
    inlet_.from_low = sum[inlet_.axis] > 0;
    for (int k = 0; k < 2000; ++k) {
      inlet_.fastest = std::max(inlet_.fastest, speed_in(on_inlet()));
    }
    if (!(inlet_.fastest > 0)) {
      throw InputError("the velocity field does not flow along x or y: no tracers can be carried");
    }
  }

  /// A place in the pores where the flow moves.
  Vec3 anywhere(std::span<const Tracer> others) {
    const Vec3 low = field_.low();
    const Vec3 size = field_.high() - low;
    for (int k = 0; k < most_tries; ++k) {
      Vec3 x = low;
      x.x += size.x * draws_.uniform();
      x.y += size.y * draws_.uniform();
      x.z += size.z * (spec_.middle ? 0.5 : draws_.uniform());
      if (is_clear(x) && norm(velocity_at(field_, x)) > slowest * inlet_.fastest &&
          (k > polite_tries || is_apart(x, others))) {
        return x;
      }
    }
    throw InputError("there is no pore in the velocity field");
  }

  /// A place just inside of the inlet, more often where the flow is strong, some way into its frame.
  Vec3 entering(std::span<const Tracer> others) {
    for (int k = 0; k < most_tries; ++k) {
      const Vec3 x = on_inlet();
      if (draws_.uniform() * inlet_.fastest < speed_in(x) && is_clear(x)) {
        const Vec3 at = follow_flow(field_, x, draws_.uniform() * spec_.frame_time);
        if (k > polite_tries || is_apart(at, others)) {
          return at;
        }
      }
    }
    return anywhere(others);
  }

 private:
  /// No grain within the clearance, in eight directions on the plane.
  [[nodiscard]] bool is_clear(const Vec3& x) const {
    for (int k = 0; k < 8; ++k) {
      const Real angle = k * std::numbers::pi / 4;
      const Vec3 there = x + spec_.clearance * Vec3{std::cos(angle), std::sin(angle), 0};
      if (solid_fraction(field_, there) > 0.5) {
        return false;
      }
    }
    return !is_solid(field_, x);
  }

  [[nodiscard]] bool is_apart(const Vec3& x, std::span<const Tracer> others) const {
    return std::none_of(others.begin(), others.end(),
                        [&](const Tracer& t) { return norm(t.x - x) < spec_.apart; });
  }

  Vec3 on_inlet() {
    const Vec3 low = field_.low();
    const Vec3 size = field_.high() - low;
    Vec3 x = low;
    for (int axis = 0; axis < 3; ++axis) {
      const Real share = axis == inlet_.axis         ? (inlet_.from_low ? 1e-6 : 1 - 1e-6)
                         : axis == 2 && spec_.middle ? 0.5
                                                     : draws_.uniform();
      x[axis] += size[axis] * share;
    }
    return x;
  }
  [[nodiscard]] Real speed_in(const Vec3& x) const {
    const Real along = velocity_at(field_, x)[inlet_.axis];
    return is_solid(field_, x) ? 0 : inlet_.from_low ? along : -along;
  }

  const FlowField& field_;
  const TracerSpec& spec_;
  Draws draws_;
  Inlet inlet_;
};

TrackRow row_of(Real time, Index id, const Vec3& x, const Vec3& v, TrackState state) {
  TrackRow row;
  row.time = time;
  row.id = id;
  row.x = x.x;
  row.y = x.y;
  row.z = x.z;
  row.u = v.x;
  row.v = v.y;
  row.w = v.z;
  row.state = state;
  return row;
}

}  // namespace

std::vector<std::vector<TrackRow>> make_tracers(const FlowField& field, const TracerSpec& spec) {
  Nursery nursery(field, spec);
  std::vector<Tracer> all;
  Index next = 1;
  for (int k = 0; k < spec.stuck + spec.count; ++k) {
    all.push_back({next++, nursery.anywhere(all), k < spec.stuck});
  }
  std::vector<std::vector<TrackRow>> frames;
  for (int f = 0; f < spec.frames; ++f) {
    const Real time = f * spec.frame_time;
    std::vector<TrackRow> rows;
    for (Tracer& t : all) {
      if (t.stuck) {
        rows.push_back(row_of(time, t.id, t.x, {}, TrackState::retained));
        continue;
      }
      rows.push_back(row_of(time, t.id, t.x, velocity_at(field, t.x), TrackState::mobile));
      t.x = follow_flow(field, t.x, spec.frame_time);
      if (is_solid(field, t.x)) {  // gone, or a rounding into a grain
        t = {next++, nursery.entering(all), false};
      }
    }
    std::sort(rows.begin(), rows.end(),
              [](const TrackRow& a, const TrackRow& b) { return a.id < b.id; });
    frames.push_back(std::move(rows));
  }
  return frames;
}

}  // namespace porefines::vision
