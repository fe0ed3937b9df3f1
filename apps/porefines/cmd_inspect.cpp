// SPDX-License-Identifier: MPL-2.0
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "commands.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "geom/metrics.hpp"
#include "geom/pore_network.hpp"
#include "geom/pore_size.hpp"
#include "geom/stl.hpp"
#include "inspection.hpp"
#include "io/provenance.hpp"
#include "report/draw_geometry.hpp"
#include "report/draw_histogram.hpp"

namespace porefines {
namespace {

namespace fs = std::filesystem;

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

void inspect(const InspectArguments& arguments) {
  Inspection inspection = understand(arguments);
  const Volumes volumes = build_volumes(inspection);
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
  auto a = std::make_shared<InspectArguments>();
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
  command->add_option("--erode-grains", a->erode_grains, "every grain recedes by this length");
  command->add_option("--edit-mask", a->edit_mask,
                      "image of the same size: white opens, black closes, grey leaves");
  command->add_option("--reconnect-gap", a->reconnect_gap,
                      "open walls of at most so many pixels between separate pores");
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
