// SPDX-License-Identifier: MPL-2.0
#include "vision/track_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::vision {
namespace {

constexpr std::array<const char*, 10> wanted{"time_s", "id",    "x_m",   "y_m",        "z_m",
                                             "u_m_s",  "v_m_s", "w_m_s", "diameter_m", "state"};
constexpr std::size_t state_column = 9;

std::vector<std::string_view> split(std::string_view line) {
  std::vector<std::string_view> cells;
  while (true) {
    const auto comma = line.find(',');
    cells.push_back(line.substr(0, comma));
    if (comma == std::string_view::npos) {
      return cells;
    }
    line.remove_prefix(comma + 1);
  }
}

std::string text_of(Real value) {
  return std::isfinite(value) ? fmt::format("{}", value) : std::string();
}

}  // namespace

const std::string& track_header() {
  static const std::string header =
      "time_s,id,x_m,y_m,z_m,u_m_s,v_m_s,w_m_s,wx_rad_s,wy_rad_s,wz_rad_s,diameter_m,state\n";
  return header;
}

std::string track_line(const TrackRow& r) {
  const char* const state = r.state == TrackState::mobile     ? "mobile"
                            : r.state == TrackState::retained ? "retained"
                                                              : "out";
  return fmt::format("{},{},{},{},{},{},{},{},,,,{},{}\n", r.time, r.id, text_of(r.x), text_of(r.y),
                     text_of(r.z), text_of(r.u), text_of(r.v), text_of(r.w), text_of(r.diameter),
                     state);
}

TrackReader::TrackReader(const std::string& path) : path_(path), file_(path) {
  std::string header;
  if (!file_ || !std::getline(file_, header)) {
    throw InputError(path + ": no such table of tracks");
  }
  for (const auto cell : split(header)) {
    names_.emplace_back(cell);
  }
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    columns_.push_back(column(wanted[k], k < 4));
  }
  pending_ = read_row(ahead_);
}

int TrackReader::column(const std::string& name, bool needed) const {
  const auto at = std::find(names_.begin(), names_.end(), name);
  if (at == names_.end() && needed) {
    throw InputError(fmt::format("{}: has no column {}\nporefines writes tracks as {}", path_, name,
                                 track_header()));
  }
  return at == names_.end() ? -1 : static_cast<int>(at - names_.begin());
}

bool TrackReader::read_row(TrackRow& row) {
  std::string line;
  if (!std::getline(file_, line)) {
    return false;
  }
  ++line_;
  const auto cells = split(line);
  std::array<Real, wanted.size()> values{};
  for (std::size_t k = 0; k < wanted.size(); ++k) {
    values[k] = TrackRow::unknown;
    const int c = columns_[k];
    if (k == state_column || c < 0 || static_cast<std::size_t>(c) >= cells.size()) {
      continue;
    }
    const auto cell = cells[static_cast<std::size_t>(c)];
    const auto result = std::from_chars(cell.data(), cell.data() + cell.size(), values[k]);
    const bool whole = result.ec == std::errc{} && result.ptr == cell.data() + cell.size();
    if (!whole && (!cell.empty() || k < 4)) {
      throw InputError(fmt::format("{}:{}: {} is no number in column {}", path_, line_,
                                   cell.empty() ? "nothing" : std::string(cell), wanted[k]));
    }
  }
  row = {values[0], static_cast<Index>(values[1]),
         values[2], values[3],
         values[4], values[5],
         values[6], values[7],
         values[8], TrackState::mobile};
  const int c = columns_[state_column];
  if (c >= 0 && static_cast<std::size_t>(c) < cells.size()) {
    const auto state = cells[static_cast<std::size_t>(c)];
    row.state = state == "retained" ? TrackState::retained
                : state == "out"    ? TrackState::out
                                    : TrackState::mobile;
  }
  return true;
}

bool TrackReader::next(std::vector<TrackRow>& rows) {
  rows.clear();
  if (!pending_) {
    return false;
  }
  const Real time = ahead_.time;
  do {
    rows.push_back(ahead_);
    pending_ = read_row(ahead_);
  } while (pending_ && ahead_.time == time);
  return true;
}

}  // namespace porefines::vision
