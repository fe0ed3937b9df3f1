// SPDX-License-Identifier: MPL-2.0
#include "vision/stuck.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::vision {
namespace {

constexpr std::size_t most_places = 256;

/// Drops every other place, so that memory stays bounded however long a particle rests.
void thin_out(std::vector<cv::Point2f>& places) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < places.size(); i += 2) {
    places[kept++] = places[i];
  }
  places.resize(kept);
}

Real shift_between_halves(const std::vector<cv::Point2f>& places) {
  const std::size_t half = places.size() / 2;
  cv::Point2d early;
  cv::Point2d late;
  for (std::size_t i = 0; i < half; ++i) {
    early += cv::Point2d(places[i]);
    late += cv::Point2d(places[places.size() - 1 - i]);
  }
  return std::hypot(late.x - early.x, late.y - early.y) /
         static_cast<Real>(std::max<std::size_t>(half, 1));
}

}  // namespace

void RestFinder::close(Index id, const Anchored& a) {
  if (a.last - a.first + 1 < settings_.frames || 2 * a.count < a.last - a.first + 1) {
    return;
  }
  const auto half = static_cast<Real>(std::max<std::size_t>(a.places.size() / 2, 1));
  const Real allowed = std::max(0.25, 4 * settings_.noise * std::sqrt(2 / half));
  if (shift_between_halves(a.places) < allowed) {
    rests_.push_back({id, a.first, a.last, a.x / a.count, a.y / a.count});
  }
}

void RestFinder::add(int frame, const Spots& spots, const std::vector<Index>& ids) {
  for (std::size_t i = 0; i < spots.size(); ++i) {
    Anchored& a = live_[ids[i]];
    const Spot& s = spots[i];
    if (a.count > 0 && std::hypot(s.x - a.x / a.count, s.y - a.y / a.count) > settings_.tolerance) {
      constexpr int leaves = 3;
      if (++a.astray < leaves) {
        continue;
      }
      close(ids[i], a);
      a = {};
    }
    a.astray = 0;
    if (a.count == 0) {
      a.first = frame;
    }
    if (a.count % a.stride == 0) {
      a.places.emplace_back(static_cast<float>(s.x), static_cast<float>(s.y));
    }
    if (a.places.size() >= most_places) {
      thin_out(a.places);
      a.stride *= 2;
    }
    a.last = frame;
    a.x += s.x;
    a.y += s.y;
    ++a.count;
  }
  constexpr int rarely = 32;
  constexpr int gone = 64;  // frames without being seen
  if (frame % rarely == 0) {
    std::erase_if(live_, [&](const auto& track) {
      const bool ended = track.second.last + gone < frame;
      if (ended) {
        close(track.first, track.second);
      }
      return ended;
    });
  }
}

std::vector<Rest> RestFinder::finish() {
  for (const auto& [id, anchored] : live_) {
    close(id, anchored);
  }
  live_.clear();
  std::sort(rests_.begin(), rests_.end(), [](const Rest& a, const Rest& b) {
    return a.first != b.first ? a.first < b.first : a.id < b.id;
  });
  return std::move(rests_);
}

}  // namespace porefines::vision
