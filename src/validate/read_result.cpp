// SPDX-License-Identifier: MPL-2.0
#include "validate/read_result.hpp"

#include <cmath>

#include "core/json_read.hpp"
#include "io/read_table.hpp"

namespace porefines::validate {
namespace {

Reading read(const FromSummary& source, const Row& row, const std::vector<std::string>& folders) {
  const Real number = number_in(folders[row.job] + "/" + source.file, source.key);
  return {.value = source.offset + source.factor * number};
}

Reading read(const FromTracks& source, const Row& row, const std::vector<std::string>& folders) {
  Real first = NAN;
  Real last = NAN;
  io::for_rows(folders[row.job] + "/out/tracks.csv", [&](const auto& head, const auto& words) {
    const int id = head.column("id");
    const int column = head.column(source.column);
    if (id >= 0 && column >= 0 &&
        io::number_of(words[static_cast<std::size_t>(id)]) == static_cast<Real>(source.id)) {
      last = io::number_of(words[static_cast<std::size_t>(column)]);
      first = std::isnan(first) ? last : first;
    }
  });
  switch (source.measure) {
    case FromTracks::Measure::change:
      return {.value = source.factor * (last - first)};
    case FromTracks::Measure::ratio:
      return {.value = source.factor * last / first};
    case FromTracks::Measure::last:
      break;
  }
  return {.value = source.factor * last};
}

Reading read(const Extrapolated& source, const Row& row, const std::vector<std::string>& folders) {
  const auto value = [&](std::size_t k) {
    return number_in(folders[row.job + k] + "/out/summary.json", source.key);
  };
  const std::size_t finest = source.cells.size() - 1;
  const Real h2 = source.cells[finest - 1] * source.cells[finest - 1];
  const Real h3 = source.cells[finest] * source.cells[finest];
  const Real change = (value(finest) - value(finest - 1)) * h3 / (h2 - h3);
  return {value(finest) + change, std::abs(change)};
}

Reading read(const Computed& source, const Row& row, const std::vector<std::string>& folders) {
  return {.value = source.read(std::span(folders).subspan(row.job))};
}

}  // namespace

Real number_in(const std::string& path, const std::string& key) {
  const auto json = read_flat_json(path);
  return json ? json->number(key) : NAN;
}

Reading read_row(const Row& row, const std::vector<std::string>& folders) {
  return std::visit([&](const auto& source) { return read(source, row, folders); }, row.source);
}

bool agrees(const Row& row, const Reading& reading) {
  const Real scale = row.reference == 0 ? 1 : std::abs(row.reference);
  return std::abs(reading.value - row.reference) <= row.tolerance * scale;
}

}  // namespace porefines::validate
