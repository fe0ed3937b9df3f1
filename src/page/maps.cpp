// SPDX-License-Identifier: MPL-2.0
#include "page/maps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/json.hpp"
#include "io/read_fields.hpp"
#include "page/pack.hpp"

namespace porefines::page {
namespace {

struct Plane {
  std::array<int, 2> axes;
  int normal;
};

/// Axes to the right and up, as in the pictures of a run.
constexpr std::array<Plane, 3> planes{Plane{{0, 1}, 2}, Plane{{0, 2}, 1}, Plane{{2, 1}, 0}};

/// Where pressure means nothing: in grains, and in fines where the file says where they are.
io::FieldVolume blocked(const std::string& folder, int normal, bool fines_too) {
  io::FieldVolume solid = io::read_last_plane(folder, "solid_fraction", normal);
  if (fines_too && io::has_field(folder, "fluid")) {
    const io::FieldVolume fluid = io::read_last_plane(folder, "fluid", normal);
    for (std::size_t at = 0; at < solid.values.size(); ++at) {
      solid.values[at] = fluid.values[at] > 0 ? solid.values[at] : 1;
    }
  }
  return solid;
}

/// Length of every vector; a scalar as it is. NaN in grains.
std::vector<float> values_of(const io::FieldVolume& field, const io::FieldVolume& solid) {
  const auto parts = static_cast<std::size_t>(field.components);
  std::vector<float> out(solid.values.size());
  for (std::size_t at = 0; at < out.size(); ++at) {
    float square = 0;
    for (std::size_t c = 0; c < parts; ++c) {
      square += field.values[parts * at + c] * field.values[parts * at + c];
    }
    const float value = parts == 1 ? field.values[at] : std::sqrt(square);
    out[at] = solid.values[at] > 0.5F ? NAN : value;
  }
  return out;
}

/// Every `step`th cell of a plane, the right axis fastest.
std::vector<float> thinned(const std::vector<float>& values, const Int3& cells, const Plane& plane,
                           int step) {
  const auto [right, up] = plane.axes;
  std::vector<float> out;
  for (int b = step / 2; b < cells[up]; b += step) {
    for (int a = step / 2; a < cells[right]; a += step) {
      Int3 at{};
      at[right] = a;
      at[up] = b;
      const Index place = at[0] + cells[0] * (at[1] + Index{cells[1]} * at[2]);
      out.push_back(values[static_cast<std::size_t>(place)]);
    }
  }
  return out;
}

std::string map_json(const std::string& folder, const std::string& field, const Plane& plane,
                     std::size_t most) {
  const io::FieldVolume solid = blocked(folder, plane.normal, field == "pressure");
  const io::FieldVolume data = io::read_last_plane(folder, field, plane.normal);
  const auto [right, up] = plane.axes;
  int step = 1;
  while (data.cells[right] / step * (data.cells[up] / step) > static_cast<int>(most)) {
    ++step;
  }
  const std::vector<float> values = thinned(values_of(data, solid), data.cells, plane, step);
  const Range16 range = range_of(values);
  std::vector<std::uint16_t> codes(values.size());
  std::transform(values.begin(), values.end(), codes.begin(),
                 [&](float value) { return range.code(value); });
  const int width = (data.cells[right] - step / 2 + step - 1) / step;
  const int height = (data.cells[up] - step / 2 + step - 1) / step;
  constexpr std::string_view names = "xyz";
  Json json;
  json.set("quantity", data.components == 3 ? "speed" : field);
  json.set("unit", data.components == 3 ? "m/s" : "Pa");
  json.set("time_s", data.time);
  json.set("normal", names.substr(static_cast<std::size_t>(plane.normal), 1));
  json.set_json("axes", fmt::format(R"(["{}","{}"])", names[right], names[up]));
  json.set("thinned", step);
  json.set_json("n", fmt::format("[{},{}]", width, height));
  const int half = step / 2;
  const auto first = [&](int axis) {
    return data.origin[axis] + (half + 0.5) * data.spacing[axis];
  };
  json.set_json("low_m", json_numbers(std::array{first(right), first(up)}));
  json.set_json("step_m",
                json_numbers(std::array{step * data.spacing[right], step * data.spacing[up]}));
  json.set("position_m", data.origin[plane.normal] + 0.5 * data.spacing[plane.normal]);
  json.set_json("range", json_numbers(std::array{range.low, range.high}));
  json.set_json("values", pack_numbers(codes));
  return json.text();
}

}  // namespace

std::string maps_json(const std::string& folder, std::size_t most) {
  std::vector<std::string> maps;
  try {
    const Int3 across = io::read_last_plane(folder, "pressure", 2).cells;
    const int depth = io::read_last_plane(folder, "pressure", 0).cells[2];
    const bool flat = 4 * depth <= std::min(across[0], across[1]);
    for (const char* field : {"velocity", "pressure"}) {
      for (std::size_t p = 0; p < (flat ? 1U : 3U); ++p) {
        maps.push_back(map_json(folder, field, planes[p], flat ? most : most / 3));
      }
    }
  } catch (const InputError&) {  // no fields: the page says so
    return "[]";
  }
  return json_list(maps);
}

}  // namespace porefines::page
