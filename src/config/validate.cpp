// SPDX-License-Identifier: MPL-2.0
// What holds between keys of geometry and grid; the flow has its own file.
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "config/checks.hpp"
#include "config/key.hpp"
#include "config/reader.hpp"

namespace porefines::config {
namespace {

constexpr Real most_cells = 1LL << 40;

/// Enough digits for a message: 0.0002 m, not 0.00019999999999999998 m.
std::string metres(Real length) {
  return fmt::format("{:.6g} m", length);
}

void require(const Node& given, const std::string& path, bool present, const std::string& hint) {
  if (!present) {
    fail(place_of(given, path), "is missing", hint);
  }
}

void check_geometry(const Geometry& geometry, const Node& given) {
  const bool image = geometry.kind == GeometryKind::image;
  if (geometry.kind != GeometryKind::empty) {
    require(given, "geometry.source", !geometry.source.empty(),
            image ? "name the image, e.g. source = \"rock.tif\""
                  : "name the list of grains, e.g. source = \"grains.txt\"");
  }
  if (image) {
    require(given, "geometry.pixel_size", geometry.pixel_size > 0,
            "an image does not know its size: pixel_size = \"5.345 um\"");
  } else {
    require(given, "geometry.size", geometry.size[0] > 0,
            "the box: size = [\"1 mm\", \"1 mm\", \"1 mm\"]");
  }
}

/// The box, where it is known before the image is read.
std::optional<std::array<Real, 3>> known_box(const Geometry& geometry) {
  if (geometry.kind != GeometryKind::image) {
    return geometry.size;
  }
  if (geometry.raw_size == Int3{}) {
    return std::nullopt;
  }
  std::array<Real, 3> box{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int cropped = geometry.crop[1][axis] - geometry.crop[0][axis];
    box[axis] = geometry.pixel_size * (cropped > 0 ? cropped : geometry.raw_size[axis]);
  }
  return box;
}

void check_cells(const Grid& grid, const Geometry& geometry, const Node& given) {
  if (grid.cell_size > 0 && grid.cells != Int3{}) {
    fail(place_of(given, "grid.cells"), "is given beside cell_size", "delete one of the two");
  }
  if (grid.cells != Int3{}) {
    if (static_cast<Real>(product(grid.cells)) > most_cells) {
      fail(place_of(given, "grid.cells"), "asks for more than 2^40 cells");
    }
    return;
  }
  require(given, "grid.cell_size", grid.cell_size > 0,
          geometry.kind == GeometryKind::image
              ? fmt::format("a good start is one cell per pixel: cell_size = {}",
                            toml_quantity(geometry.pixel_size, kind::length))
              : "give cell_size = \"5 um\", or cells = [64, 64, 64]");
  const auto box = known_box(geometry);
  if (!box) {
    return;
  }
  Real cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Real edge = (*box)[axis];
    if (grid.cell_size > edge * (1 + 1e-9)) {
      fail(place_of(given, "grid.cell_size"),
           fmt::format("{} is larger than the box, {} along {}", metres(grid.cell_size),
                       metres(edge), axis_names()[axis]),
           "is the unit right?");
    }
    cells *= std::ceil(edge / grid.cell_size);
  }
  if (cells > most_cells) {
    fail(place_of(given, "grid.cell_size"),
         fmt::format("{} makes {:.3g} cells, more than 2^40", metres(grid.cell_size), cells),
         "is the unit right?");
  }
}

}  // namespace

void validate(const Case& subject, const Node& given) {
  check_geometry(subject.geometry, given);
  check_particles(subject, given);
  check_drive_changes(subject, given);
  if (is_dry(subject)) {
    check_dry(subject, given);
    return;
  }
  check_cells(subject.grid, subject.geometry, given);
  check_faces(subject.flow, given);
  check_inertial(subject, given);
  const Flow& flow = subject.flow;
  const bool pushed =
      flow.inlet || flow.outlet || flow.pressure_gradient != Triple{} || !is_inertial(subject);
  const bool particles_push = is_coupled(subject) && !pushed;  // they fall, or start with a speed
  if (!subject.inertia.lid && !particles_push) {
    check_drive(flow, given);
  }
  if (is_coupled(subject)) {
    check_coupled(subject, given);
  } else if (!is_inertial(subject)) {
    check_steady(subject, given);
  }
}

}  // namespace porefines::config
