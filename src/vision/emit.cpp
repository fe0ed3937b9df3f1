// SPDX-License-Identifier: MPL-2.0
#include "vision/emit.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::vision {
namespace {

/// Velocity between two sightings.
void set_velocity(TrackRow& row, const TrackRow& from, const TrackRow& to) {
  const Real time = to.time - from.time;
  if (time > 0) {
    row.u = (to.x - from.x) / time;
    row.v = (to.y - from.y) / time;
  }
}

}  // namespace

TrackState RowMaker::state_of(Index id, int frame) const {
  const auto rests = kept_.rests.find(id);
  if (rests != kept_.rests.end()) {
    for (const Rest& rest : rests->second) {
      if (frame >= rest.first && frame <= rest.last) {
        return TrackState::retained;
      }
    }
  }
  return TrackState::mobile;
}

void RowMaker::add(int frame, const Spots& spots, const std::vector<Index>& ids) {
  Waiting now;
  now.frame = frame;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const Index number = kept_.number[static_cast<std::size_t>(ids[i])];
    if (number == 0) {
      continue;
    }
    TrackRow row;
    row.time = time_of(scale_, frame);
    row.id = number;
    row.x = (spots[i].x + 0.5) * scale_.pixel_size;
    row.y = (scale_.height - 0.5 - spots[i].y) * scale_.pixel_size;
    row.diameter = scale_.diameter;
    row.state = state_of(ids[i], frame);
    TrackRow before;
    before.time = -1;
    const auto last = last_.find(ids[i]);
    if (last != last_.end()) {
      const auto& [then, at] = last->second;
      const int front = waiting_.empty() ? frame : waiting_.front().frame;
      if (then >= front) {
        Waiting& w = waiting_[static_cast<std::size_t>(then - front)];
        w.next_frame[at] = frame;
        w.next[at] = row;
        before = w.rows[at];
        fill_gap(then, at, row, frame);
      }
    }
    last_[ids[i]] = {frame, now.rows.size()};
    now.before_frame.push_back(before.time < 0 ? -1 : 0);
    now.before.push_back(before);
    now.rows.push_back(row);
    now.ids.push_back(ids[i]);
    now.next_frame.push_back(-1);
    now.next.emplace_back();
  }
  waiting_.push_back(std::move(now));
  while (waiting_.size() > static_cast<std::size_t>(memory_) + 1) {
    release();
  }
}

void RowMaker::fill_gap(int from, std::size_t at, const TrackRow& to, int frame) {
  const int front = waiting_.front().frame;
  const TrackRow start = waiting_[static_cast<std::size_t>(from - front)].rows[at];
  const Index id = waiting_[static_cast<std::size_t>(from - front)].ids[at];
  for (int f = from + 1; f < frame; ++f) {
    Waiting& w = waiting_[static_cast<std::size_t>(f - front)];
    const Real t = static_cast<Real>(f - from) / (frame - from);
    TrackRow row = start;
    row.time = time_of(scale_, f);
    row.x = (1 - t) * start.x + t * to.x;
    row.y = (1 - t) * start.y + t * to.y;
    row.state = state_of(id, f);
    w.rows.push_back(row);
    w.ids.push_back(-1);  // last_ does not point here
    w.next_frame.push_back(frame);
    w.next.push_back(to);
    w.before_frame.push_back(0);
    w.before.push_back(start);
  }
}

void RowMaker::release() {
  Waiting& w = waiting_.front();
  for (std::size_t i = 0; i < w.rows.size(); ++i) {
    const bool later = w.next_frame[i] >= 0;
    const bool earlier = w.before_frame[i] >= 0;
    set_velocity(w.rows[i], earlier ? w.before[i] : w.rows[i], later ? w.next[i] : w.rows[i]);
    if (!later) {
      last_.erase(w.ids[i]);
    }
  }
  std::sort(w.rows.begin(), w.rows.end(),
            [](const TrackRow& a, const TrackRow& b) { return a.id < b.id; });
  sink_(w.frame, w.rows);
  waiting_.pop_front();
}

void RowMaker::finish() {
  while (!waiting_.empty()) {
    release();
  }
}

}  // namespace porefines::vision
