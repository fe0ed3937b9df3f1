// SPDX-License-Identifier: MPL-2.0
#include "inspection.hpp"

#include <algorithm>
#include <filesystem>

#include <mpi.h>

#include "config/reader.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "geom/rasterise.hpp"
#include "sim/domain.hpp"

namespace porefines {
namespace {

Real length_of(const std::string& text, std::string_view name) {
  return text.empty() ? 0 : parse_quantity(text, kind::length, name);
}

BoxFace parse_face(const std::string& text) {
  if (text.size() != 2 || text[0] < 'x' || text[0] > 'z' || (text[1] != '+' && text[1] != '-')) {
    throw InputError("--flow " + text + ": one of x+, x-, y+, y-, z+, z- is meant");
  }
  return box_face(text[0] - 'x', text[1] == '+');
}

Inspection from_case(const InspectArguments& arguments) {
  const config::Case the_case = config::load_case(arguments.input, arguments.overrides);
  Inspection out;
  out.spec = sim::geometry_spec(the_case);
  out.flow_to = sim::flow_to(the_case.flow);
  out.question.fine_diameter = the_case.analysis.fine_diameter;
  out.question.cell_size = the_case.grid.cell_size;
  out.simplify = the_case.geometry.simplify;
  return out;
}

Inspection from_image(const InspectArguments& arguments) {
  Inspection out;
  out.spec.source = arguments.input;
  if (!std::filesystem::exists(arguments.input)) {
    throw InputError(arguments.input + ": there is no such file or folder");
  }
  if (arguments.pixel_size.empty()) {
    throw InputError(arguments.input +
                     ": the image does not say how large a pixel is; add --pixel-size \"2 um\"");
  }
  out.spec.pixel_size = length_of(arguments.pixel_size, "--pixel-size");
  out.spec.segmentation.pore_value = arguments.pore_value;
  out.spec.segmentation.pore_is_bright = !arguments.dark_pores;
  out.spec.segmentation.otsu = arguments.threshold == "otsu";
  if (!arguments.threshold.empty() && !out.spec.segmentation.otsu) {
    out.spec.segmentation.threshold =
        static_cast<int>(parse_quantity(arguments.threshold, kind::number, "--threshold"));
  }
  if (arguments.raw_size.size() == 3) {
    std::copy_n(arguments.raw_size.begin(), 3, out.spec.raw_size.begin());
  }
  out.spec.erode_grains = length_of(arguments.erode_grains, "--erode-grains");
  out.spec.edit_mask = arguments.edit_mask;
  out.spec.reconnect_gap = arguments.reconnect_gap;
  out.spec.minimum_throat = length_of(arguments.minimum_throat, "--minimum-throat");
  out.flow_to = parse_face(arguments.flow);
  out.spec.flow_axis = axis_of(out.flow_to);
  return out;
}

/// Lists of grains become an image of the cells of the case, with at least 200 voxels along the
/// longest edge.
Real list_pixel(const geom::Sample& sample, Real cell_size) {
  const Vec3 size = sample.box.size;
  const Real finest = std::max({size.x, size.y, size.z}) / 200;
  return cell_size > 0 ? std::min(cell_size, finest) : finest;
}

}  // namespace

Inspection understand(const InspectArguments& arguments) {
  Inspection out = std::filesystem::path(arguments.input).extension() == ".toml"
                       ? from_case(arguments)
                       : from_image(arguments);
  if (!arguments.depth.empty()) {
    out.spec.depth = length_of(arguments.depth, "--depth");
  }
  if (!arguments.fine_diameter.empty()) {
    out.question.fine_diameter = length_of(arguments.fine_diameter, "--fine-diameter");
  }
  out.question.depth = out.spec.depth;
  out.question.flow_axis = out.spec.flow_axis;
  return out;
}

Volumes build_volumes(Inspection& inspection) {
  geom::Spec raw = inspection.spec;
  raw.only_percolating = false;
  raw.remove_grains_below = raw.fill_pores_below = raw.reconnect_gap = 0;
  raw.minimum_throat = raw.erode_grains = 0;
  raw.edit_mask.clear();
  const geom::Sample found = geom::build_sample(raw, MPI_COMM_SELF);
  Volumes out{found.voxels, found.voxels, found.pixel, ""};
  if (inspection.spec.kind != geom::Kind::image) {
    out.pixel = list_pixel(found, inspection.question.cell_size);
    geom::Voxels voxels = geom::rasterise(found, out.pixel);
    out.found = out.kept = geom::share(std::move(voxels), MPI_COMM_SELF);
    return out;
  }
  inspection.question.smooth =
      inspection.spec.smooth < 0 ? 1 : inspection.spec.smooth / inspection.spec.pixel_size;
  try {
    out.kept = geom::build_sample(inspection.spec, MPI_COMM_SELF).voxels;
  } catch (const InputError& no_path) {
    out.warning = no_path.what();
    geom::Spec all = inspection.spec;
    all.only_percolating = false;
    out.kept = geom::build_sample(all, MPI_COMM_SELF).voxels;
  }
  return out;
}

}  // namespace porefines
