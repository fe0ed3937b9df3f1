// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "commands.hpp"
#include "config/reader.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "geom/metrics.hpp"
#include "geom/pore_size.hpp"
#include "geom/stl.hpp"
#include "geometry_spec.hpp"
#include "io/provenance.hpp"
#include "report/draw_geometry.hpp"
#include "report/draw_histogram.hpp"

namespace porefines {
namespace {

namespace fs = std::filesystem;

struct Arguments {
  std::string input;
  std::vector<std::string> overrides;
  std::string pixel_size;
  int pore_value = 255;
  std::string threshold;
  bool dark_pores = false;
  std::vector<int> raw_size;
  std::string depth;
  std::string fine_diameter;
  std::string minimum_throat;
  std::string flow = "x+";
  std::string stl;
  std::string output = "inspect";
};

/// What to look at and what is asked of it.
struct Inspection {
  geom::Spec spec;
  geom::Question question;
  BoxFace flow_to = BoxFace::x_high;
  Real simplify = 0.5;  ///< [pixels]
};

Real length_of(const std::string& text, std::string_view name) {
  return text.empty() ? 0 : parse_quantity(text, kind::length, name);
}

BoxFace parse_face(const std::string& text) {
  if (text.size() != 2 || text[0] < 'x' || text[0] > 'z' || (text[1] != '+' && text[1] != '-')) {
    throw InputError("--flow " + text + ": one of x+, x-, y+, y-, z+, z- is meant");
  }
  return box_face(text[0] - 'x', text[1] == '+');
}

Inspection from_case(const Arguments& arguments) {
  const config::Case the_case = config::load_case(arguments.input, arguments.overrides);
  Inspection out;
  out.spec = geometry_spec(the_case);
  out.flow_to = flow_direction(the_case.flow);
  out.question.fine_diameter = the_case.analysis.fine_diameter;
  out.question.cell_size = the_case.grid.cell_size;
  out.simplify = the_case.geometry.simplify;
  return out;
}

Inspection from_image(const Arguments& arguments) {
  Inspection out;
  out.spec.source = arguments.input;
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
  out.spec.minimum_throat = length_of(arguments.minimum_throat, "--minimum-throat");
  out.flow_to = parse_face(arguments.flow);
  out.spec.flow_axis = axis_of(out.flow_to);
  return out;
}

Inspection understand(const Arguments& arguments) {
  Inspection out = fs::path(arguments.input).extension() == ".toml" ? from_case(arguments)
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

/// Lists of grains become an image with about 200 voxels along the longest edge, or the cells of
/// the case if those are fewer.
geom::Voxels rasterise(const geom::Sample& sample, Real cell_size, Real& pixel) {
  const Vec3 size = sample.box.size;
  const Real longest = std::max({size.x, size.y, size.z});
  pixel = std::max(cell_size, longest / 200);
  const bool flat = sample.spec.kind == geom::Kind::cylinders;
  Int3 n{};
  for (int axis = 0; axis < 3; ++axis) {
    n[static_cast<std::size_t>(axis)] =
        flat && axis == 2 ? 1 : std::max(static_cast<int>(std::lround(size[axis] / pixel)), 1);
  }
  const geom::Solid solid = geom::make_solid(sample, {}, size, pixel);
  geom::Voxels voxels = geom::make_voxels(n, 0);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const Vec3 x = pixel * Vec3{i + 0.5, j + 0.5, k + 0.5};
        voxels.at(i, j, k) = geom::signed_distance(solid, x) > 0 ? 1 : 0;
      }
    }
  }
  return voxels;
}

/// The binary volumes before and after cleaning.
struct Volumes {
  geom::SharedVoxels found;
  geom::SharedVoxels kept;
  Real pixel = 0;
  std::string warning;
};

Volumes build(Inspection& inspection) {
  geom::Spec raw = inspection.spec;
  raw.only_percolating = false;
  raw.remove_grains_below = raw.fill_pores_below = raw.reconnect_gap = 0;
  raw.minimum_throat = 0;
  const geom::Sample found = geom::build_sample(raw, MPI_COMM_SELF);
  Volumes out{found.voxels, found.voxels, found.pixel, ""};
  if (inspection.spec.kind != geom::Kind::image) {
    geom::Voxels voxels = rasterise(found, inspection.question.cell_size, out.pixel);
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

void write_surface(const std::string& path, const geom::VoxelSolid& solid, Real depth,
                   Real simplify) {
  if (solid.n[2] > 1) {
    geom::write_stl(path, geom::grain_surface(solid));
    return;
  }
  const auto outlines = geom::simplify(geom::grain_outlines(solid), simplify * solid.pixel);
  geom::write_stl(path, geom::extrude(outlines, depth > 0 ? depth : solid.pixel));
}

std::string micrometres(Real metres) {
  return fmt::format("{:.4g} um", 1e6 * metres);
}

void print(const geom::Metrics& m, const Volumes& volumes, const geom::Question& question,
           const std::string& folder) {
  std::cout << fmt::format("{} x {} x {} voxels of {}\n", m.voxels[0], m.voxels[1], m.voxels[2],
                           micrometres(m.pixel));
  std::cout << fmt::format("porosity            {:.4f}  (connected {:.4f})\n", m.porosity,
                           m.porosity_connected);
  std::cout << fmt::format("specific surface    {:.4g} 1/m\n", m.specific_surface);
  std::cout << fmt::format("pores               median {}, mean {}\n",
                           micrometres(m.pores.quantile(0.5)), micrometres(m.pores.mean()));
  if (!m.throats.empty()) {
    std::cout << fmt::format("throats             {}: median {}, mean {}\n", m.throats.size(),
                             micrometres(m.throat_widths.quantile(0.5)),
                             micrometres(m.throat_widths.mean()));
    std::cout << fmt::format("  under four cells  {:.1f} %\n", 100 * m.throats_under_4_cells);
  }
  std::cout << fmt::format("grains              {}: median {}, mean {}\n", m.grains.size.size(),
                           micrometres(m.grains.quantile(0.5)), micrometres(m.grains.mean()));
  if (question.fine_diameter > 0) {
    std::cout << fmt::format("throat / fine o/d   median {:.3g};  grain / fine D/d median {:.3g}\n",
                             m.throat_widths.quantile(0.5) / question.fine_diameter,
                             m.grains.quantile(0.5) / question.fine_diameter);
  }
  if (!volumes.warning.empty()) {
    std::cout << "warning: " << volumes.warning << "\n";
  }
  std::cout << "written: " << folder << "/metrics.json, throats.csv, geometry.png, "
            << "pore_sizes.png, throat_sizes.png\n";
}

void draw(const geom::Metrics& m, const Volumes& volumes, const Inspection& inspection,
          const geom::VoxelSolid& solid, const fs::path& folder) {
  const io::Provenance provenance = io::make_provenance(1, 0);
  const std::string title = fmt::format("{}: porosity {:.3f}, {} throats",
                                        fs::path(inspection.spec.source).filename().string(),
                                        m.porosity, m.throats.size());
  report::write_picture((folder / "geometry.png").string(),
                        report::draw_geometry({volumes.found.view(), volumes.kept.view(), &solid,
                                               &m.throats, inspection.flow_to},
                                              title),
                        provenance, title);
  report::write_picture((folder / "pore_sizes.png").string(),
                        report::draw_histogram(m.pores, {.title = "Pore sizes",
                                                         .quantity = "local pore diameter",
                                                         .share = "share of pore volume"}),
                        provenance, "Pore sizes");
  const Real cell = inspection.question.cell_size > 0 ? inspection.question.cell_size : m.pixel;
  report::write_picture((folder / "throat_sizes.png").string(),
                        report::draw_histogram(m.throat_widths, {.title = "Throat sizes",
                                                                 .quantity = "throat width",
                                                                 .share = "share of throats",
                                                                 .mark = 4 * cell,
                                                                 .mark_name = "four cells"}),
                        provenance, "Throat sizes");
}

void inspect(const Arguments& arguments) {
  Inspection inspection = understand(arguments);
  const Volumes volumes = build(inspection);
  const geom::VoxelView image = volumes.kept.view();
  const geom::Metrics m =
      geom::measure(image, volumes.pixel, inspection.spec.beyond, inspection.question);
  const geom::VoxelSolid solid =
      geom::whole_solid(image, volumes.pixel, inspection.spec.beyond, inspection.question.smooth);
  make_folder(arguments.output);
  const fs::path folder = arguments.output;
  Json json = geom::to_json(m, inspection.question);
  json.set("source", inspection.spec.source);
  write_file((folder / "metrics.json").string(), json.text());
  geom::write_throats((folder / "throats.csv").string(), m.throats);
  draw(m, volumes, inspection, solid, folder);
  if (!arguments.stl.empty()) {
    const Real depth = inspection.spec.kind == geom::Kind::cylinders ? inspection.spec.size.z
                                                                     : inspection.spec.depth;
    write_surface(arguments.stl, solid, depth, inspection.simplify);
  }
  print(m, volumes, inspection.question, arguments.output);
}

}  // namespace

void add_inspect(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("inspect", "Show what was understood of a geometry");
  command->footer(
      "Examples:\n"
      "  porefines inspect rock.tif --pixel-size \"2 um\"\n"
      "  porefines inspect chip.png --pixel-size \"1.5 um\" --threshold otsu --depth \"20 um\" "
      "--stl chip.stl\n"
      "  porefines inspect case.toml -o look");
  auto a = std::make_shared<Arguments>();
  command->add_option("CASE.toml or IMAGE", a->input, "a case, an image, or a folder of slices")
      ->required();
  command->add_option("key.path=value", a->overrides, "with a case: values that replace its own");
  command->add_option("--pixel-size", a->pixel_size, "edge of one pixel, such as \"2 um\"");
  command->add_option("--pore-value", a->pore_value, "binary image: this value is pore (255)");
  command->add_option("--threshold", a->threshold, "grey image: \"otsu\" or a grey level 0..255");
  command->add_flag("--dark-pores", a->dark_pores, "with a threshold: dark is pore");
  command->add_option("--raw-size", a->raw_size, "raw volume: voxels along x, y, z")->expected(3);
  command->add_option("--depth", a->depth, "depth of a 2D geometry, such as \"20 um\"");
  command->add_option("--fine-diameter", a->fine_diameter, "for o/d and D/d");
  command->add_option("--minimum-throat", a->minimum_throat, "open narrower throats to this width");
  command->add_option("--flow", a->flow, "direction of the flow: x+, x-, y+, ... (x+)");
  command->add_option("--stl", a->stl, "write the grain surface as triangles");
  command->add_option("-o,--output", a->output, "output folder (inspect)");
  command->callback([a, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      inspect(*a);
    }
    exit_code = exit_code::done;
  });
}

}  // namespace porefines
