// SPDX-License-Identifier: MPL-2.0
#include "page/tracks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>
#include <vector>

#include "core/json.hpp"
#include "io/read_table.hpp"
#include "page/pack.hpp"

namespace porefines::page {
namespace {

/// What the first pass learns.
struct Survey {
  std::vector<Real> times;  ///< [s]
  std::size_t rows = 0;
  std::array<Range16, 3> box{Range16{INFINITY, -INFINITY}, Range16{INFINITY, -INFINITY},
                             Range16{INFINITY, -INFINITY}};
  Real fastest = 0;
  std::vector<Real> force_mean;  ///< [N] per time
  std::vector<Real> force_max;
};

using Row = std::vector<std::string_view>;

/// Columns of tracks.csv by name, looked up once.
struct Columns {
  std::array<int, 3> x{-1, -1, -1};
  std::array<int, 3> u{-1, -1, -1};
  std::array<int, 3> force{-1, -1, -1};
  int time = -1;
  int id = -1;
  int diameter = -1;
  int state = -1;

  explicit Columns(const io::TextTable& head) {
    x = {head.column("x_m"), head.column("y_m"), head.column("z_m")};
    u = {head.column("u_m_s"), head.column("v_m_s"), head.column("w_m_s")};
    force = {head.column("fx_n"), head.column("fy_n"), head.column("fz_n")};
    time = head.column("time_s");
    id = head.column("id");
    diameter = head.column("diameter_m");
    state = head.column("state");
  }
  [[nodiscard]] static Real at(const Row& row, int column) {
    return column < 0 ? 0 : io::number_of(row[static_cast<std::size_t>(column)]);
  }
  [[nodiscard]] static Real length(const Row& row, const std::array<int, 3>& columns) {
    return std::hypot(at(row, columns[0]), at(row, columns[1]), at(row, columns[2]));
  }
};

Survey survey(const std::string& path) {
  Survey out;
  std::vector<Index> with_force;
  std::optional<Columns> columns;
  io::for_rows(path, [&](const io::TextTable& head, const Row& row) {
    if (!columns) {
      columns.emplace(head);
    }
    const Real time = Columns::at(row, columns->time);
    if (out.times.empty() || time > out.times.back()) {
      out.times.push_back(time);
      out.force_mean.push_back(0);
      out.force_max.push_back(0);
      with_force.push_back(0);
    }
    ++out.rows;
    for (std::size_t a = 0; a < 3; ++a) {
      const Real x = Columns::at(row, columns->x[a]);
      out.box[a].low = std::min(out.box[a].low, x);
      out.box[a].high = std::max(out.box[a].high, x);
    }
    out.fastest = std::max(out.fastest, Columns::length(row, columns->u));
    if (columns->force[0] >= 0) {
      const Real force = Columns::length(row, columns->force);
      out.force_mean.back() += force;
      out.force_max.back() = std::max(out.force_max.back(), force);
      ++with_force.back();
    }
  });
  for (std::size_t k = 0; k < with_force.size(); ++k) {
    out.force_mean[k] /= static_cast<Real>(std::max<Index>(with_force[k], 1));
  }
  if (!columns || columns->force[0] < 0) {
    out.force_mean.clear();
  }
  return out;
}

std::vector<Real> every(const std::vector<Real>& values, std::size_t step) {
  std::vector<Real> out;
  for (std::size_t k = 0; k < values.size(); k += step) {
    out.push_back(values[k]);
  }
  return out;
}

/// What the second pass collects.
struct Frames {
  std::vector<Real> times;
  std::vector<Real> starts;
  std::vector<Real> ids;
  std::vector<Real> diameters;
  std::map<Real, std::size_t> place;  ///< of an id in ids
  std::vector<std::uint16_t> particle;
  std::array<std::vector<std::uint16_t>, 3> x;
  std::vector<std::uint16_t> speed;
  std::vector<std::uint16_t> state;
};

void take(Frames& frames, const Columns& columns, const Row& row, const Survey& seen) {
  const Real id = Columns::at(row, columns.id);
  const auto [found, is_new] = frames.place.emplace(id, frames.ids.size());
  if (is_new) {
    frames.ids.push_back(id);
    frames.diameters.push_back(Columns::at(row, columns.diameter));
  }
  frames.particle.push_back(static_cast<std::uint16_t>(found->second));
  for (std::size_t a = 0; a < 3; ++a) {
    frames.x[a].push_back(seen.box[a].code(Columns::at(row, columns.x[a])));
  }
  frames.speed.push_back(Range16{0, seen.fastest}.code(Columns::length(row, columns.u)));
  const std::string_view state =
      columns.state < 0 ? "mobile" : row[static_cast<std::size_t>(columns.state)];
  frames.state.push_back(state == "out" ? 2 : state == "retained" ? 1 : 0);
}

Frames collect(const std::string& path, const Survey& seen, std::size_t step) {
  Frames frames;
  std::optional<Columns> columns;
  std::size_t time_place = 0;
  io::for_rows(path, [&](const io::TextTable& head, const Row& row) {
    if (!columns) {
      columns.emplace(head);
    }
    const Real time = Columns::at(row, columns->time);
    while (seen.times[time_place] < time) {
      ++time_place;
    }
    const bool last = time_place + 1 == seen.times.size();
    if ((time_place % step != 0 && !last) || frames.ids.size() >= none16) {
      return;
    }
    if (frames.times.empty() || time > frames.times.back()) {
      frames.times.push_back(time);
      frames.starts.push_back(static_cast<Real>(frames.particle.size()));
    }
    take(frames, *columns, row, seen);
  });
  frames.starts.push_back(static_cast<Real>(frames.particle.size()));
  return frames;
}

std::string to_json(const Frames& frames, const Survey& seen) {
  Json json;
  json.set("times_in_file", seen.times.size());
  json.set("rows_in_file", seen.rows);
  json.set_json("times", json_numbers(frames.times));
  json.set_json("starts", json_numbers(frames.starts));
  json.set_json("ids", json_numbers(frames.ids));
  json.set_json("diameters_m", json_numbers(frames.diameters));
  const auto& box = seen.box;
  json.set_json("low_m", json_numbers(std::array{box[0].low, box[1].low, box[2].low}));
  json.set_json("high_m", json_numbers(std::array{box[0].high, box[1].high, box[2].high}));
  json.set("fastest_m_s", seen.fastest);
  json.set_json("particle", pack_numbers(frames.particle));
  for (std::size_t a = 0; a < 3; ++a) {
    json.set_json(std::string(1, static_cast<char>('x' + a)), pack_numbers(frames.x[a]));
  }
  json.set_json("speed", pack_numbers(frames.speed));
  json.set_json("state", pack_numbers(frames.state));
  if (!seen.force_mean.empty()) {
    const std::size_t step = seen.times.size() / 1000 + 1;
    Json forces;
    forces.set_json("time_s", json_numbers(every(seen.times, step)));
    forces.set_json("mean_n", json_numbers(every(seen.force_mean, step)));
    forces.set_json("max_n", json_numbers(every(seen.force_max, step)));
    json.set_json("forces", forces.text());
  }
  return json.text();
}

}  // namespace

std::string tracks_json(const std::string& folder, std::size_t most) {
  const std::string path = folder + "/tracks.csv";
  const Survey seen = survey(path);
  if (seen.rows == 0) {
    return "null";
  }
  const std::size_t step = std::max<std::size_t>(1, (seen.rows + most - 1) / most);
  return to_json(collect(path, seen, step), seen);
}

}  // namespace porefines::page
