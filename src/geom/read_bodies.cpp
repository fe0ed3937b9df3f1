// SPDX-License-Identifier: MPL-2.0
#include <charconv>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geom/round_bodies.hpp"

namespace porefines::geom {

namespace {

/// The numbers of a line; false when something else stands in it.
bool parse_numbers(std::string_view line, std::vector<Real>& numbers) {
  constexpr std::string_view gaps = " \t\r,;";
  numbers.clear();
  line = line.substr(0, line.find('#'));
  for (std::size_t at = line.find_first_not_of(gaps); at != std::string_view::npos;
       at = line.find_first_not_of(gaps, at)) {
    const std::size_t end = std::min(line.find_first_of(gaps, at), line.size());
    Real value = 0;
    const char* const first = line.data() + at + (line[at] == '+' ? 1 : 0);
    const auto [stop, error] = std::from_chars(first, line.data() + end, value);
    if (error != std::errc{} || stop != line.data() + end || !std::isfinite(value)) {
      return false;
    }
    numbers.push_back(value);
    at = end;
  }
  return true;
}

Body make_body(const std::vector<Real>& numbers, int dims, Real unit, const std::string& place) {
  if (!(numbers.back() > 0)) {
    throw InputError(fmt::format("{}: a radius of {} must be positive.", place, numbers.back()));
  }
  return {{numbers[0] * unit, numbers[1] * unit, dims == 3 ? numbers[2] * unit : 0},
          numbers.back() * unit};
}

}  // namespace

std::vector<Body> read_bodies(const std::string& path, int dims, Real unit) {
  std::ifstream file(path);
  if (!file) {
    throw InputError(
        path + ": the list of grains cannot be opened.\nThe path is taken relative to the case.");
  }
  const char* const wanted = dims == 3 ? "x y z r" : "x y r";
  std::vector<Body> bodies;
  std::vector<Real> numbers;
  std::string line;
  std::string first_row;
  for (int row = 1; std::getline(file, line); ++row) {
    const bool clean = parse_numbers(line, numbers);
    if (clean && numbers.empty()) {
      continue;  // blank line or comment
    }
    if (!clean || numbers.size() != static_cast<std::size_t>(dims) + 1) {
      if (bodies.empty()) {  // header
        first_row = first_row.empty() && clean ? fmt::format("line {}: {}", row, line) : first_row;
        continue;
      }
      throw InputError(fmt::format("{}:{}: '{}' is not a row of {} numbers ({}).", path, row,
                                   line.substr(0, 60), dims + 1, wanted));
    }
    bodies.push_back(make_body(numbers, dims, unit, fmt::format("{}:{}", path, row)));
  }
  if (bodies.empty()) {
    throw InputError(fmt::format(
        "{}: no row of {} numbers ({}) was found{}.\n{} need one grain per row.", path, dims + 1,
        wanted, first_row.empty() ? "" : "; the first row of numbers is " + first_row,
        dims == 3 ? "Spheres" : "Cylinders"));
  }
  return bodies;
}

}  // namespace porefines::geom
