// SPDX-License-Identifier: MPL-2.0
#include "vision/link.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "vision/assignment.hpp"

namespace porefines::vision {
namespace {

constexpr Real gate = 16;  // squared deviations at which a track rather stays alone

Real length2(const cv::Point2d& v) {
  return v.x * v.x + v.y * v.y;
}

/// d^T C^-1 d
Real mahalanobis(const cv::Point2d& d, const Step& c) {
  const Real determinant = std::max(c.xx * c.yy - c.xy * c.xy, 1e-6);
  return (c.yy * d.x * d.x - 2 * c.xy * d.x * d.y + c.xx * d.y * d.y) / determinant;
}

/// First spot that is not above this.
auto first_below(const Spots& spots, Real y) {
  return std::lower_bound(spots.begin(), spots.end(), y,
                          [](const Spot& s, Real value) { return s.y < value; });
}

}  // namespace

Linker::Prediction Linker::predict(const Live& track) const {
  const Real frames = track.missed + 1;
  const Step step = expected(guide_, track.at);
  if (track.links == 0) {
    // Where the guide knows no direction a new particle may go anywhere within the range.
    const Real n2 =
        2 * settings_.noise * settings_.noise + frames * motion_.spread * motion_.spread;
    return {advect(guide_, track.at, frames),
            {{}, frames * step.xx + n2, frames * step.xy, frames * step.yy + n2}};
  }
  const cv::Point2d drift = advect(guide_, track.at, frames * track.pace) - track.at;
  const Real s = motion_.deviation * frames;
  constexpr Real share = 0.12;  // of its step a particle may surprise by
  const Real v2 = s * s + share * share * length2(drift + frames * track.excess);
  return {track.at + drift + frames * motion_.persistence * track.excess, {{}, v2, 0, v2}};
}

/// How well the frame after next continues the step to `to`, in squared deviations.
Real Linker::continuation(const Live& track, const cv::Point2d& to, const Spots& after) const {
  Live moved = track;
  const Guide& guide = guide_;
  const cv::Point2d mean = advect(guide, track.at, 1) - track.at;
  moved.excess = to - track.at - mean;
  moved.at = to;
  moved.links = 1;
  moved.missed = 0;
  const Prediction p = predict(moved);
  const Real reach = std::sqrt(gate * std::max(p.about.xx, p.about.yy));
  Real best = gate;
  for (auto s = first_below(after, p.at.y - reach); s != after.end() && s->y < p.at.y + reach;
       ++s) {
    best = std::min(best, mahalanobis({s->x - p.at.x, s->y - p.at.y}, p.about));
  }
  return best;
}

std::vector<int> Linker::assign_spots(const Spots& spots, const Spots& after) const {
  std::vector<Candidate> candidates;
  std::vector<Real> alone(live_.size(), gate);
  for (std::size_t k = 0; k < live_.size(); ++k) {
    const Live& track = live_[k];
    const Prediction p = predict(track);
    const Real most = settings_.range * (track.missed + 1);
    const Real reach = std::min(std::sqrt(gate * std::max(p.about.xx, p.about.yy)), 2 * most);
    // A particle seen once may be noise: letting it go costs less than a track.
    const bool newborn = track.links == 0;
    alone[k] = newborn ? 0.8 * gate : gate;
    for (auto s = first_below(spots, p.at.y - reach); s != spots.end() && s->y < p.at.y + reach;
         ++s) {
      const cv::Point2d to(s->x, s->y);
      if (std::abs(to.x - p.at.x) > reach || length2(to - track.at) > most * most) {
        continue;
      }
      Real cost = mahalanobis(to - p.at, p.about);
      if (newborn && motion_.persistence > 0.3 && !after.empty()) {
        cost = 0.5 * cost + 0.5 * continuation(track, to, after);
      }
      if (cost < gate) {
        candidates.push_back({static_cast<int>(k), static_cast<int>(s - spots.begin()), cost});
      }
    }
  }
  return assign(static_cast<int>(live_.size()), static_cast<int>(spots.size()), candidates, alone);
}

std::vector<int> Linker::nearest_spots(const Spots& spots) const {
  std::vector<Candidate> steps;
  for (std::size_t k = 0; k < live_.size(); ++k) {
    const Live& track = live_[k];
    const Real reach = settings_.range * (track.missed + 1);
    for (auto s = first_below(spots, track.at.y - reach);
         s != spots.end() && s->y < track.at.y + reach; ++s) {
      const cv::Point2d d(s->x - track.at.x, s->y - track.at.y);
      const Real along = d.dot(settings_.flow);
      const Real across = std::abs(d.cross(settings_.flow));
      const bool against = along < -settings_.noise;
      if (length2(d) < reach * reach && !(against && across < settings_.least_slope * -along)) {
        steps.push_back({static_cast<int>(k), static_cast<int>(s - spots.begin()), length2(d)});
      }
    }
  }
  std::stable_sort(steps.begin(), steps.end(),
                   [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  std::vector<int> out(live_.size(), -1);
  std::vector<char> taken(spots.size(), 0);
  for (const Candidate& step : steps) {
    auto& mine = out[static_cast<std::size_t>(step.row)];
    auto& used = taken[static_cast<std::size_t>(step.column)];
    if (mine < 0 && used == 0) {
      mine = step.column;
      used = 1;
    }
  }
  return out;
}

void Linker::learn(const Prediction& p, const Live& track, const cv::Point2d& to) {
  if (track.links < 2 || track.missed > 0) {
    return;
  }
  constexpr Real forget = 0.9995;
  const cv::Point2d step = to - track.at;
  const cv::Point2d drift = advect(guide_, track.at, track.pace) - track.at;
  const cv::Point2d excess = step - drift;
  sum_weights_ = forget * sum_weights_ + 1;
  sum_squares_ = forget * sum_squares_ + 0.5 * std::min(length2(to - p.at), 16 * p.about.xx);
  sum_kept_ = forget * sum_kept_ + excess.dot(track.excess);
  sum_excess_ = forget * sum_excess_ + length2(track.excess);
  constexpr Real enough = 200;
  if (sum_weights_ > enough) {
    motion_.deviation = std::max(std::sqrt(sum_squares_ / sum_weights_), 1.5 * settings_.noise);
    motion_.spread = std::sqrt(0.5 * sum_excess_ / sum_weights_);
    motion_.persistence =
        sum_excess_ > 0 ? std::clamp(sum_kept_ / sum_excess_, 0.0, 1.0) : motion_.persistence;
  }
}

/// Pace and excess of the step that was just made.
void Linker::follow(Live& track, const cv::Point2d& to) {
  const Real frames = track.missed + 1;
  const cv::Point2d step = (to - track.at) / frames;
  const cv::Point2d mean = (advect(guide_, track.at, frames) - track.at) / frames;
  constexpr Real weak = 2;  // [pixels] steps of the guide below this say nothing about a pace
  Real pace = 1;
  if (length2(mean) > weak * weak) {
    pace = std::clamp(step.dot(mean) / length2(mean), 0.0, 3.0);
  }
  track.pace = track.links == 0 ? pace : 0.5 * (track.pace + pace);
  const cv::Point2d paced = (advect(guide_, track.at, frames * track.pace) - track.at) / frames;
  track.excess = step - paced;
  track.at = to;
  track.missed = 0;
  ++track.links;
}

std::vector<Index> Linker::next(const Spots& spots, const Spots& after) {
  const auto chosen =
      settings_.method == LinkMethod::thesis ? nearest_spots(spots) : assign_spots(spots, after);
  std::vector<Index> ids(spots.size(), -1);
  for (std::size_t k = 0; k < live_.size(); ++k) {
    if (chosen[k] < 0) {
      ++live_[k].missed;
      continue;
    }
    const Spot& spot = spots[static_cast<std::size_t>(chosen[k])];
    const Prediction p = predict(live_[k]);
    const Real determinant = p.about.xx * p.about.yy - p.about.xy * p.about.xy;
    surprise_ += 0.5 * mahalanobis({spot.x - p.at.x, spot.y - p.at.y}, p.about) +
                 0.5 * std::log(determinant) + std::log(2 * std::numbers::pi);
    learn(p, live_[k], {spot.x, spot.y});
    if (record_ != nullptr && live_[k].links > 0 && live_[k].missed == 0) {
      const cv::Point2d step(spot.x - live_[k].at.x, spot.y - live_[k].at.y);
      record_->push_back({live_[k].at + 0.5 * step, step});
    }
    follow(live_[k], {spot.x, spot.y});
    ids[static_cast<std::size_t>(chosen[k])] = live_[k].id;
  }
  counted_ += static_cast<Real>(spots.size());
  std::erase_if(live_, [&](const Live& track) {
    return track.missed > (track.links == 0 ? 0 : settings_.memory);
  });
  for (std::size_t i = 0; i < spots.size(); ++i) {
    if (ids[i] < 0) {
      ids[i] = next_id_++;
      surprise_ += std::log(std::numbers::pi * settings_.range * settings_.range) + 4;
      Live born;
      born.id = ids[i];
      born.at = {spots[i].x, spots[i].y};
      live_.push_back(born);
    }
  }
  return ids;
}

namespace {

Learnt run(const LinkSettings& settings, const Guide& guide, const Motion& start,
           std::span<const Spots> frames, std::vector<SeenStep>* steps) {
  Linker linker(settings, guide, start);
  linker.record(steps);
  for (std::size_t f = 0; f < frames.size(); ++f) {
    (void)linker.next(frames[f], f + 1 < frames.size() ? frames[f + 1] : Spots{});
  }
  return {guide, linker.motion(), linker.surprise()};
}

}  // namespace

Learnt learn_motion(const LinkSettings& settings, const Guide& guide, std::span<const Spots> frames,
                    cv::Size size, bool refine) {
  const Real wide = settings.range / 3;
  Learnt best{guide, {}, std::numeric_limits<Real>::max()};
  for (const Motion& start : {Motion{0.5, 0.1 * settings.range + 1, 0}, Motion{0.95, 2, wide},
                              Motion{0, 0.15 * settings.range + 1, 0}, Motion{0, wide, wide}}) {
    const Learnt first = run(settings, guide, start, frames, nullptr);
    const Learnt second = run(settings, guide, first.motion, frames, nullptr);
    best = second.surprise < best.surprise ? second : best;
  }
  constexpr int rounds = 3;
  for (int round = 0; refine && round < rounds; ++round) {
    std::vector<SeenStep> steps;
    (void)run(settings, best.guide, best.motion, frames, &steps);
    const Real per_cell = 12;
    const Real cell =
        std::max(8.0, std::sqrt(per_cell * size.area() / (1 + static_cast<Real>(steps.size()))));
    const Guide finer = refined(best.guide, size, cell, steps);
    const Learnt next = run(settings, finer, best.motion, frames, nullptr);
    if (!(next.surprise < best.surprise)) {
      break;
    }
    best = next;
  }
  return best;
}

}  // namespace porefines::vision
