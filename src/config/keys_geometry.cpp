// SPDX-License-Identifier: MPL-2.0
#include <fmt/format.h>

#include "config/item_key.hpp"
#include "config/key.hpp"

namespace porefines::config {
namespace {

constexpr Real longest = 1e3;  // [m] no pore-scale sample is larger
constexpr Range some_length{0, longest, true};
constexpr Range length_or_none{0, longest};
constexpr Range grey_levels{0, 65535};
constexpr Range image_edge{1, 1 << 20};
constexpr Range pixels{0, 1 << 30};

Key path_key(const std::string& path, std::string Geometry::*member, const std::string& absent,
             const std::string& doc) {
  Key key = text_key(path, &Case::geometry, member, absent, doc);
  key.read = [=](Case& c, const Node& node) { c.geometry.*member = read_path(node, c); };
  return key;
}

void read_threshold(Case& c, const Node& node) {
  c.geometry.otsu = false;
  c.geometry.threshold.reset();
  if (const auto* text = std::get_if<std::string>(&node.value); text && *text == "otsu") {
    c.geometry.otsu = true;
  } else if (std::holds_alternative<std::int64_t>(node.value)) {
    c.geometry.threshold = static_cast<int>(read_integer(node, grey_levels));
  } else {
    fail_wants(node, "\"otsu\" or a grey level such as 128");
  }
}

std::string write_threshold(const Case& c) {
  return c.geometry.otsu        ? "\"otsu\""
         : c.geometry.threshold ? std::to_string(*c.geometry.threshold)
                                : "";
}

bool is_grey(const Case& c) {
  return c.geometry.otsu || c.geometry.threshold.has_value();
}

void read_pore_value(Case& c, const Node& node) {
  if (is_grey(c)) {
    fail(node.place, "has no meaning beside threshold",
         "a binary image has a pore_value, a grey one a threshold: delete one of them");
  }
  c.geometry.pore_value = static_cast<int>(read_integer(node, grey_levels));
}

void read_brightness(Case& c, const Node& node) {
  if (!is_grey(c)) {
    fail(node.place, "has no meaning without threshold",
         "for a binary image say which value is pore: pore_value = 0");
  }
  c.geometry.pore_is_bright = read_flag(node);
}

void read_size(Case& c, const Node& node) {
  constexpr auto example = "[\"1 mm\", \"1 mm\", \"1 mm\"]";
  const List& list = read_list(node, example);
  if (list.size() != 3) {
    fail(node.place, fmt::format("has {} lengths, needs 3: {}", list.size(), example));
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    c.geometry.size[axis] = read_quantity(list[axis], kind::length, some_length);
  }
}

std::string write_size(const Case& c) {
  const auto& size = c.geometry.size;
  const auto edge = [&](std::size_t axis) { return toml_quantity(size[axis], kind::length); };
  return size[0] > 0 ? fmt::format("[{}, {}, {}]", edge(0), edge(1), edge(2)) : "";
}

void read_crop(Case& c, const Node& node) {
  constexpr auto example = "[[0, 400], [0, 300]], and a third pair for a volume";
  const List& axes = read_list(node, example);
  if (axes.size() != 2 && axes.size() != 3) {
    fail(node.place, fmt::format("has {} pairs, needs one per axis: {}", axes.size(), example));
  }
  c.geometry.crop = {};
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const List& pair = read_list(axes[axis], "[0, 400]");
    if (pair.size() != 2) {
      fail(axes[axis].place, "wants pairs [first, past-last] of voxels");
    }
    const auto first = static_cast<int>(read_integer(pair[0], pixels));
    const auto last = static_cast<int>(read_integer(pair[1], pixels));
    if (first >= last) {
      fail(axes[axis].place,
           fmt::format("[{}, {}] is empty: first must be less than past-last", first, last));
    }
    c.geometry.crop[0][axis] = first;
    c.geometry.crop[1][axis] = last;
  }
}

std::string write_crop(const Case& c) {
  const auto& [first, last] = c.geometry.crop;
  std::string pairs;
  for (std::size_t axis = 0; axis < 3 && last[axis] > 0; ++axis) {
    pairs += fmt::format("{}[{}, {}]", axis == 0 ? "" : ", ", first[axis], last[axis]);
  }
  return pairs.empty() ? "" : "[" + pairs + "]";
}

Key image_only(Key key) {
  key.only_for = {GeometryKind::image};
  return key;
}

std::vector<Key> image_keys() {
  const auto part = &Case::geometry;
  return {
      quantity_key("geometry.pixel_size", part, &Geometry::pixel_size, kind::length, some_length,
                   "required", "physical edge of one pixel or voxel"),
      {"geometry.threshold", "`\"otsu\"` or a grey level", "grey image: where pore begins",
       read_threshold, write_threshold, "the image is binary"},
      {"geometry.pore_is_bright", "true or false",
       "with `threshold`: pore is the bright side, at or above it", read_brightness,
       [](const Case& c) -> std::string {
         return !is_grey(c) ? "" : c.geometry.pore_is_bright ? "true" : "false";
       },
       "true"},
      {"geometry.pore_value", "whole number, " + grey_levels.text(),
       "binary image: which value is pore", read_pore_value,
       [](const Case& c) { return is_grey(c) ? "" : std::to_string(c.geometry.pore_value); }},
      int3_key("geometry.raw_size", part, &Geometry::raw_size, image_edge, "[200, 200, 200]",
               "not a raw file", "raw volume of bytes: voxels along x, y, z; x runs fastest"),
      quantity_key("geometry.depth", part, &Geometry::depth, kind::length, some_length,
                   "required for a 2D image", "extrusion of a 2D image along z"),
      {"geometry.crop", "a pair [first, past-last] for each axis, in voxels",
       "the part of the image that is used; y points up; two pairs for a 2D image", read_crop,
       write_crop, "the whole image"},
      choice_key("geometry.surface", part, &Geometry::surface, {"smooth", "voxel"},
                 "a sub-pixel surface, or the staircase of the pixels itself"),
      quantity_key("geometry.smooth", part, &Geometry::smooth, kind::length, length_or_none,
                   "one pixel", "radius of the curvature filter on the surface"),
      integer_key("geometry.remove_grains_below", part, &Geometry::remove_grains_below, pixels,
                  "grains of fewer pixels than this are noise and vanish"),
      integer_key("geometry.fill_pores_below", part, &Geometry::fill_pores_below, pixels,
                  "pores of fewer pixels than this are filled"),
      quantity_key("geometry.simplify", part, &Geometry::simplify, kind::number, Range{0, 100}, "",
                   "tolerance of the simplified outlines, in pixels"),
      quantity_key("geometry.erode_grains", part, &Geometry::erode_grains, kind::length,
                   length_or_none, "", "every grain recedes by this much, in whole pixels"),
      path_key("geometry.edit_mask", &Geometry::edit_mask, "none",
               "an image as large as `source`: white (255) opens, black (0) closes, any other grey "
               "leaves a pixel as it is; relative to the case file"),
      integer_key("geometry.reconnect_gap", part, &Geometry::reconnect_gap, Range{0, 1000},
                  "grain walls of at most so many pixels between pores that are not connected "
                  "otherwise are opened"),
      quantity_key("geometry.minimum_throat", part, &Geometry::minimum_throat, kind::length,
                   length_or_none, "", "narrower throats are reopened to this width"),
  };
}

}  // namespace

std::vector<Key> geometry_keys() {
  const auto part = &Case::geometry;
  std::vector<Key> keys{choice_key("geometry.kind", part, &Geometry::kind, geometry_kind_names(),
                                   "where the grains come from"),
                        path_key("geometry.source", &Geometry::source, "required",
                                 "image: 2D or 3D; spheres: rows x y z r; cylinders: rows x y r "
                                 "(axis z); relative to the case file"),
                        {"geometry.size",
                         "three lengths, e.g. `[\"1 mm\", \"1 mm\", \"1 mm\"]`",
                         "edges of the box",
                         read_size,
                         write_size,
                         "required",
                         {GeometryKind::spheres, GeometryKind::cylinders, GeometryKind::empty}}};
  keys[1].only_for = {GeometryKind::image, GeometryKind::spheres, GeometryKind::cylinders};
  Key unit = quantity_key("geometry.list_unit", part, &Geometry::list_unit, kind::length,
                          some_length, "", "unit of the numbers in a list of grains");
  unit.only_for = {GeometryKind::spheres, GeometryKind::cylinders};
  Key images = flag_key("geometry.periodic_images", part, &Geometry::periodic_images,
                        "grains reaching over a periodic face continue on the other side");
  images.only_for = unit.only_for;
  keys.push_back(unit);
  keys.push_back(images);
  for (const Key& key : image_keys()) {
    keys.push_back(image_only(key));
  }
  keys.push_back(choice_key("geometry.keep", part, &Geometry::keep, {"all", "percolating"},
                            "drop the pores that do not connect inlet and outlet, or keep all"));
  return keys;
}

}  // namespace porefines::config
