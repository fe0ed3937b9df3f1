// SPDX-License-Identifier: MPL-2.0
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/suggest.hpp"
#include "sim/beds.hpp"

namespace porefines::sim {
namespace {

std::vector<std::string> split(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) {
    const auto first = word.find_first_not_of(" \t\r");
    const auto last = word.find_last_not_of(" \t\r");
    words.push_back(first == std::string::npos ? "" : word.substr(first, last - first + 1));
  }
  return words;
}

/// Where each quantity stands: x, y, z, diameter, u, v, w; -1: not there.
using Columns = std::array<int, 7>;

Columns find_columns(const std::string& path, const std::vector<std::string>& header) {
  static const std::vector<std::string> known{"x_m",   "y_m",   "z_m",  "diameter_m",
                                              "u_m_s", "v_m_s", "w_m_s"};
  Columns columns;
  columns.fill(-1);
  for (std::size_t c = 0; c < header.size(); ++c) {
    const std::string& name = header[c];
    std::size_t at = 0;
    while (at < known.size() && name != known[at] && !(at > 3 && name == known[at].substr(0, 1))) {
      ++at;
    }
    if (at == known.size()) {
      const std::string guess = closest(name, known);
      throw InputError(
          fmt::format("{}:1: unknown column {}{}\nknown: x_m, y_m, z_m, diameter_m, u, "
                      "v, w",
                      path, name, guess.empty() ? "" : "; did you mean " + guess + "?"));
    }
    columns[at] = static_cast<int>(c);
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (columns[axis] < 0) {
      throw InputError(
          fmt::format("{}:1: there is no column {}\nthe first line names the columns: "
                      "x_m,y_m,z_m,diameter_m",
                      path, known[axis]));
    }
  }
  return columns;
}

Real number(const std::string& path, int line, const std::string& word) {
  char* end = nullptr;
  const Real value = std::strtod(word.c_str(), &end);
  if (word.empty() || *end != '\0' || !std::isfinite(value)) {
    throw InputError(fmt::format("{}:{}: \"{}\" is not a number", path, line, word));
  }
  return value;
}

}  // namespace

std::vector<dem::Body> read_spheres(const std::string& path, Real diameter) {
  std::ifstream file(path);
  std::string text;
  if (!file || !std::getline(file, text)) {
    throw InputError(fmt::format("{}: cannot be read", path));
  }
  const std::vector<std::string> header = split(text);
  const Columns columns = find_columns(path, header);
  if (columns[3] < 0 && diameter <= 0) {
    throw InputError(
        fmt::format("{}:1: there is no column diameter_m\nadd it, or give a diameter in "
                    "[[particles]]",
                    path));
  }
  std::vector<dem::Body> bodies;
  for (int line = 2; std::getline(file, text); ++line) {
    const std::vector<std::string> words = split(text);
    if (words.empty() || (words.size() == 1 && words[0].empty()) || words[0].starts_with('#')) {
      continue;
    }
    if (words.size() != header.size()) {
      throw InputError(
          fmt::format("{}:{}: {} values for {} columns", path, line, words.size(), header.size()));
    }
    const auto value = [&](int c) { return c < 0 ? 0 : number(path, line, words[c]); };
    dem::Body body;
    body.position = {value(columns[0]), value(columns[1]), value(columns[2])};
    body.velocity = {value(columns[4]), value(columns[5]), value(columns[6])};
    body.radius = (columns[3] < 0 ? diameter : value(columns[3])) / 2;
    if (!(body.radius > 0)) {
      throw InputError(fmt::format("{}:{}: a diameter of {:.6g} m; it must be positive", path, line,
                                   2 * body.radius));
    }
    bodies.push_back(body);
  }
  if (bodies.empty()) {
    throw InputError(fmt::format("{}: holds no particles", path));
  }
  return bodies;
}

}  // namespace porefines::sim
