// SPDX-License-Identifier: MPL-2.0
#include "vision/statistics.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace porefines::vision {
namespace {

constexpr std::uint32_t bootstrap_key = 0x626f6f74;

/// Sums that mean speed and spreads follow from.
struct Sums {
  Real speed = 0;
  Real with_speed = 0;
  Real x = 0;
  Real y = 0;
  Real xx = 0;
  Real yy = 0;
  Real n = 0;

  [[nodiscard]] Real mean_speed() const {
    return with_speed > 0 ? speed / with_speed : TrackRow::unknown;
  }
  [[nodiscard]] Real sigma_x() const {
    return std::sqrt(std::max<Real>(xx / n - x * x / n / n, 0));
  }
  [[nodiscard]] Real sigma_y() const {
    return std::sqrt(std::max<Real>(yy / n - y * y / n / n, 0));
  }
};

struct Particle {
  Real speed;
  Real x;
  Real y;
};

void add(Sums& sums, const Particle& p) {
  if (std::isfinite(p.speed)) {
    sums.speed += p.speed;
    sums.with_speed += 1;
  }
  sums.x += p.x;
  sums.y += p.y;
  sums.xx += p.x * p.x;
  sums.yy += p.y * p.y;
  sums.n += 1;
}

Banded band(Real value, std::vector<Real>& resampled) {
  std::erase_if(resampled, [](Real r) { return !std::isfinite(r); });
  if (resampled.size() < 2) {
    return {value, value, value};
  }
  std::sort(resampled.begin(), resampled.end());
  constexpr Real tail = 0.025;
  const auto last = static_cast<Real>(resampled.size() - 1);
  return {value, resampled[static_cast<std::size_t>(std::lround(tail * last))],
          resampled[static_cast<std::size_t>(std::lround((1 - tail) * last))]};
}

}  // namespace

Moment moment_of(std::span<const TrackRow> rows, std::uint64_t number, int resamples) {
  Moment out;
  out.time = rows.empty() ? 0 : rows.front().time;
  std::vector<Particle> mobile;
  for (const TrackRow& r : rows) {
    if (r.state == TrackState::mobile) {
      mobile.push_back({std::hypot(r.u, r.v), r.x, r.y});
    }
    out.retained += r.state == TrackState::retained ? 1 : 0;
  }
  out.particles = static_cast<Index>(mobile.size());
  if (mobile.empty()) {
    return out;
  }
  Sums all;
  for (Particle& p : mobile) {
    add(all, p);
  }
  out.mean_x = all.x / all.n;
  out.mean_y = all.y / all.n;
  std::vector<Real> speeds;
  std::vector<Real> sigmas_x;
  std::vector<Real> sigmas_y;
  const auto n = static_cast<std::uint64_t>(mobile.size());
  for (int k = 0; k < resamples; ++k) {
    Sums sums;
    for (std::uint64_t i = 0; i < n; i += 4) {
      const auto bits =
          philox({static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(k),
                  static_cast<std::uint32_t>(number), static_cast<std::uint32_t>(number >> 32)},
                 {bootstrap_key, 0});
      for (std::uint64_t j = 0; j < 4 && i + j < n; ++j) {
        Particle p = mobile[(bits[j] * n) >> 32];
        p.x -= out.mean_x;  // squares of small numbers keep their digits
        p.y -= out.mean_y;
        add(sums, p);
      }
    }
    speeds.push_back(sums.mean_speed());
    sigmas_x.push_back(sums.sigma_x());
    sigmas_y.push_back(sums.sigma_y());
  }
  Sums centred;
  for (Particle p : mobile) {
    p.x -= out.mean_x;
    p.y -= out.mean_y;
    add(centred, p);
  }
  out.speed = band(all.mean_speed(), speeds);
  out.sigma_x = band(centred.sigma_x(), sigmas_x);
  out.sigma_y = band(centred.sigma_y(), sigmas_y);
  return out;
}

void MeanSquares::add(int frame, std::span<const TrackRow> rows) {
  Real dx = 0;
  Real dy = 0;
  Real n = 0;
  const auto moves = [&](const TrackRow& r) { return r.state == TrackState::mobile; };
  // past_ holds places without the common drift, so the drift of this step comes first.
  for (const TrackRow& r : rows) {
    const auto seen = past_.find(r.id);
    if (moves(r) && seen != past_.end() && seen->second.back().frame == frame - 1) {
      dx += r.x - drift_x_ - seen->second.back().x;
      dy += r.y - drift_y_ - seen->second.back().y;
      n += 1;
    }
  }
  drift_x_ += n > 0 ? dx / n : 0;
  drift_y_ += n > 0 ? dy / n : 0;
  for (const TrackRow& r : rows) {
    if (!moves(r)) {
      continue;
    }
    auto& places = past_[r.id];
    const Seen now{frame, r.x - drift_x_, r.y - drift_y_};
    for (const Seen& then : places) {
      const auto lag = static_cast<std::size_t>(frame - then.frame);
      if (lag <= lags_) {
        const Real x = now.x - then.x;
        const Real y = now.y - then.y;
        sums_[lag].mean_square += x * x + y * y;
        ++sums_[lag].count;
      }
    }
    places.push_back(now);
    while (places.size() > lags_) {
      places.pop_front();
    }
  }
  constexpr int rarely = 64;
  if (frame % rarely == 0) {
    std::erase_if(past_, [&](const auto& track) {
      return track.second.back().frame + static_cast<int>(lags_) < frame;
    });
  }
}

std::vector<MeanSquares::Lag> MeanSquares::result() const {
  std::vector<Lag> out = sums_;
  for (Lag& lag : out) {
    lag.mean_square /= static_cast<Real>(std::max<Index>(lag.count, 1));
  }
  return out;
}

Diffusion fit_diffusion(const std::vector<MeanSquares::Lag>& lags, Real frame_time,
                        int first_lags) {
  Real w = 0;
  Real wt = 0;
  Real wtt = 0;
  Real wm = 0;
  Real wtm = 0;
  int used = 0;
  for (std::size_t k = 1; k < lags.size() && static_cast<int>(k) <= first_lags; ++k) {
    if (lags[k].count > 0) {
      const Real t = static_cast<Real>(k) * frame_time;
      const Real weight = static_cast<Real>(lags[k].count) / static_cast<Real>(k * k);
      w += weight;
      wt += weight * t;
      wtt += weight * t * t;
      wm += weight * lags[k].mean_square;
      wtm += weight * t * lags[k].mean_square;
      ++used;
    }
  }
  if (used < 2) {
    return {};
  }
  const Real slope = (w * wtm - wt * wm) / (w * wtt - wt * wt);
  const Real offset = (wm - slope * wt) / w;
  return {slope / 4, std::sqrt(std::max<Real>(offset, 0) / 4)};
}

}  // namespace porefines::vision
