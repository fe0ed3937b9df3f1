// SPDX-License-Identifier: MPL-2.0
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/mesh.hpp"

namespace porefines::dem {

namespace {

constexpr std::size_t header = 84;  // title and count of a binary file
constexpr std::size_t record = 50;  // bytes per triangle

std::vector<geom::Triangle> read_binary(const std::string& bytes, std::size_t count) {
  std::vector<geom::Triangle> triangles(count);
  for (std::size_t t = 0; t < count; ++t) {
    std::memcpy(&triangles[t], &bytes[header + record * t + 12], sizeof(geom::Triangle));
  }
  return triangles;
}

std::vector<geom::Triangle> read_ascii(const std::string& path, const std::string& bytes) {
  std::vector<geom::Triangle> triangles;
  std::istringstream in(bytes);
  std::string word;
  std::size_t corners = 0;
  while (in >> word) {
    if (word != "vertex") {
      continue;
    }
    if (corners % 3 == 0) {
      triangles.emplace_back();
    }
    for (float& v : triangles.back()[corners % 3]) {
      if (!(in >> v)) {
        throw InputError(fmt::format("{}: corner {} of triangle {} is not three numbers.", path,
                                     corners % 3 + 1, triangles.size()));
      }
    }
    ++corners;
  }
  if (corners % 3 != 0) {
    throw InputError(fmt::format("{}: ends within triangle {}.", path, triangles.size()));
  }
  return triangles;
}

}  // namespace

std::vector<geom::Triangle> read_stl(const std::string& path, Real unit) {
  std::ifstream in(path, std::ios::binary);
  if (!in) {
    throw InputError(fmt::format("{}: cannot be opened; check the path.", path));
  }
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  std::uint32_t count = 0;
  if (bytes.size() >= header) {
    std::memcpy(&count, &bytes[80], sizeof count);
  }
  // ASCII files begin with "solid", but so do some binary ones: their size tells.
  const bool is_binary = bytes.size() >= header && bytes.size() == header + record * count;
  if (!is_binary && bytes.compare(0, 5, "solid") != 0) {
    throw InputError(
        fmt::format("{}: no STL file: {} bytes do not hold the {} triangles it announces, nor does "
                    "it begin with "
                    "\"solid\"; export it anew.",
                    path, bytes.size(), count));
  }
  auto triangles = is_binary ? read_binary(bytes, count) : read_ascii(path, bytes);
  if (triangles.empty()) {
    throw InputError(fmt::format("{}: holds no triangles.", path));
  }
  for (geom::Triangle& triangle : triangles) {
    for (auto& corner : triangle) {
      for (float& v : corner) {
        v = static_cast<float>(v * unit);
      }
    }
  }
  return triangles;
}

}  // namespace porefines::dem
