// SPDX-License-Identifier: MPL-2.0
#include "vision/measures.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "vision/assignment.hpp"

namespace porefines::vision {
namespace {

/// What two tracks have in common.
struct Shared {
  int frames = 0;  ///< in which both are there
  int close = 0;   ///< and nearer than the gate
  Real distance = 0;
  Real squares = 0;
};

Shared compare(const Path& a, const Path& b, Real gate) {
  Shared out;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    if (a[i].frame != b[j].frame) {
      (a[i].frame < b[j].frame ? i : j) += 1;
      continue;
    }
    const Real d = std::hypot(a[i].x - b[j].x, a[i].y - b[j].y);
    ++out.frames;
    if (d < gate) {
      ++out.close;
      out.distance += d;
      out.squares += d * d;
    }
    ++i, ++j;
  }
  return out;
}

Real distance(const Path& a, const Path& b, const Shared& shared, Real gate) {
  const auto frames = static_cast<Real>(a.size() + b.size()) - shared.frames;
  return gate * (frames - shared.close) + shared.distance;
}

struct Place {
  Real x;
  Real y;
  int track;
};
using Frames = std::map<int, std::vector<Place>>;

Frames by_frame(const std::vector<Path>& paths) {
  Frames frames;
  for (std::size_t k = 0; k < paths.size(); ++k) {
    for (const PathPoint& p : paths[k]) {
      frames[p.frame].push_back({p.x, p.y, static_cast<int>(k)});
    }
  }
  for (auto& [frame, places] : frames) {
    std::sort(places.begin(), places.end(),
              [](const Place& a, const Place& b) { return a.x < b.x; });
  }
  return frames;
}

/// Pairs of tracks that meet at least once; no others can be worth pairing.
std::vector<Candidate> meetings(const std::vector<Path>& truth, const std::vector<Path>& found,
                                Real gate) {
  std::vector<std::pair<int, int>> pairs;
  const Frames there = by_frame(found);
  for (const auto& [frame, places] : by_frame(truth)) {
    const auto others = there.find(frame);
    if (others == there.end()) {
      continue;
    }
    for (const Place& p : places) {
      auto q = std::lower_bound(others->second.begin(), others->second.end(), p.x - gate,
                                [](const Place& place, Real x) { return place.x < x; });
      for (; q != others->second.end() && q->x < p.x + gate; ++q) {
        if (std::hypot(p.x - q->x, p.y - q->y) < gate) {
          pairs.emplace_back(p.track, q->track);
        }
      }
    }
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::vector<Candidate> out;
  for (const auto& [x, y] : pairs) {
    const Path& a = truth[static_cast<std::size_t>(x)];
    const Path& b = found[static_cast<std::size_t>(y)];
    out.push_back({x, y, distance(a, b, compare(a, b, gate), gate)});
  }
  return out;
}

std::size_t positions(const std::vector<Path>& paths) {
  std::size_t count = 0;
  for (const Path& path : paths) {
    count += path.size();
  }
  return count;
}

}  // namespace

Agreement measure(const std::vector<Path>& truth, const std::vector<Path>& found, Real gate) {
  std::vector<Real> alone;
  for (const Path& path : truth) {
    alone.push_back(gate * static_cast<Real>(path.size()));
  }
  const auto partner = assign(static_cast<int>(truth.size()), static_cast<int>(found.size()),
                              meetings(truth, found, gate), alone);
  Real paired_distance = 0;
  Real paired_positions = 0;  // of found tracks with a partner
  Real hits = 0;
  Real squares = 0;
  Real pairs = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    if (partner[k] < 0) {
      paired_distance += alone[k];
      continue;
    }
    const Path& other = found[static_cast<std::size_t>(partner[k])];
    const Shared shared = compare(truth[k], other, gate);
    paired_distance += distance(truth[k], other, shared, gate);
    paired_positions += static_cast<Real>(other.size());
    hits += shared.close;
    squares += shared.squares;
    ++pairs;
  }
  const auto true_positions = static_cast<Real>(positions(truth));
  const auto found_positions = static_cast<Real>(positions(found));
  const Real none = gate * true_positions;
  const Real spurious = gate * (found_positions - paired_positions);
  Agreement out;
  out.alpha = none > 0 ? 1 - paired_distance / none : 0;
  out.beta = none > 0 ? (none - paired_distance) / (none + spurious) : 0;
  const Real any = true_positions + found_positions - hits;
  out.jaccard = any > 0 ? hits / any : 0;
  const auto tracks = static_cast<Real>(truth.size() + found.size()) - pairs;
  out.jaccard_tracks = tracks > 0 ? pairs / tracks : 0;
  out.rmse = hits > 0 ? std::sqrt(squares / hits) : 0;
  return out;
}

}  // namespace porefines::vision
