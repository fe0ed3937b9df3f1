// SPDX-License-Identifier: MPL-2.0
#include <filesystem>
#include <iostream>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>
#include <mpi.h>

#include "commands.hpp"
#include "core/error.hpp"
#include "core/units.hpp"
#include "geom/image_write.hpp"
#include "geom/micromodel.hpp"
#include "geom/packing.hpp"
#include "geom/solid.hpp"

namespace porefines {
namespace {

/// Options shared by all media; lengths as the user wrote them.
struct Arguments {
  std::vector<std::string> size;
  std::string pixel_size;
  std::string grain;
  std::string throat;
  Real porosity = 0.45;
  Real spread = -1;
  Real roughness = 0.5;
  Real cemented = 0.05;
  bool periodic = false;
  unsigned long long seed = 1;
  std::string output;
};

Real length_of(const std::string& text, std::string_view name) {
  return text.empty() ? 0 : parse_quantity(text, kind::length, name);
}

/// Sizes along each axis; one value stands for all.
Vec3 box_of(const Arguments& a, int dims) {
  Vec3 size{0, 0, 1};
  for (int axis = 0; axis < dims; ++axis) {
    const auto i = a.size.size() == 1 ? 0 : static_cast<std::size_t>(axis);
    if (i >= a.size.size()) {
      throw InputError(fmt::format("--size needs one length or {} of them", dims));
    }
    size[axis] = length_of(a.size[i], "--size");
    if (!(size[axis] > 0)) {
      throw InputError("--size: every length must be positive");
    }
  }
  return size;
}

void say(const std::string& path, const geom::VoxelView& voxels, Real pixel) {
  const Index pores = std::accumulate(voxels.pore, voxels.pore + product(voxels.n), Index{0});
  std::cout << fmt::format("{}: {} x {} x {} pixels of {:.4g} um, porosity {:.4f}\n", path,
                           voxels.n[0], voxels.n[1], voxels.n[2], 1e6 * pixel,
                           static_cast<Real>(pores) / static_cast<Real>(product(voxels.n)));
  std::cout << fmt::format("next: porefines inspect {} --pixel-size \"{:.6g} um\"\n", path,
                           1e6 * pixel);
}

Int3 pixels_of(const Vec3& size, int dims, Real pixel) {
  if (!(pixel > 0)) {
    throw InputError("an image needs --pixel-size, such as \"2 um\"");
  }
  Int3 n{1, 1, 1};
  for (int axis = 0; axis < dims; ++axis) {
    n[static_cast<std::size_t>(axis)] =
        std::max(static_cast<int>(std::lround(size[axis] / pixel)), 1);
  }
  constexpr Index most = Index{1} << 33;
  if (product(n) > most) {
    throw InputError(
        fmt::format("{} x {} x {} pixels are too many; is --pixel-size right?", n[0], n[1], n[2]));
  }
  return n;
}

void generate_micromodel(const Arguments& a) {
  const Real pixel = length_of(a.pixel_size, "--pixel-size");
  geom::MicromodelSpec spec;
  spec.pixels = pixels_of(box_of(a, 2), 2, pixel);
  spec.porosity = a.porosity;
  spec.grain = length_of(a.grain, "--grain") / pixel;
  spec.throat = length_of(a.throat, "--throat") / pixel;
  spec.spread = a.spread < 0 ? spec.spread : a.spread;
  spec.roughness = a.roughness;
  spec.cemented = a.cemented;
  spec.periodic = a.periodic;
  spec.seed = a.seed;
  const geom::Voxels voxels = geom::make_micromodel(spec);
  geom::write_image(a.output, voxels.view());
  say(a.output, voxels.view(), pixel);
}

template <int dims>
geom::Voxels rasterise(const std::vector<geom::Body>& bodies, const geom::PackSpec& spec,
                       Real pixel) {
  const Int3 n = pixels_of(spec.size, dims, pixel);
  const auto side = spec.periodic ? geom::Beyond::periodic : geom::Beyond::pore;
  const geom::RoundBodies<dims> grains(bodies, {spec.size, {side, side, side}}, spec.periodic,
                                       pixel);
  geom::Voxels voxels = geom::make_voxels(n, 0);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        const Vec3 x = pixel * Vec3{i + 0.5, j + 0.5, k + 0.5};
        voxels.at(i, j, k) = grains.signed_distance(x) > 0 ? 1 : 0;
      }
    }
  }
  return voxels;
}

template <int dims>
void generate_packing(const Arguments& a) {
  geom::PackSpec spec;
  spec.dims = dims;
  spec.size = box_of(a, dims);
  spec.periodic = a.periodic;
  spec.porosity = a.porosity;
  spec.diameter = length_of(a.grain, "--grain");
  spec.spread = a.spread < 0 ? 0 : a.spread;
  spec.gap = length_of(a.throat, "--throat");
  spec.seed = a.seed;
  const auto bodies = geom::make_packing(spec);
  const std::string ending = std::filesystem::path(a.output).extension().string();
  if (ending == ".txt" || ending == ".csv") {
    geom::write_bodies(a.output, bodies, spec);
    std::cout << fmt::format("{}: {} {}, porosity {:.4f}\n", a.output, bodies.size(),
                             dims == 2 ? "discs" : "spheres", spec.porosity);
    return;
  }
  const Real pixel = length_of(a.pixel_size, "--pixel-size");
  const geom::Voxels voxels = rasterise<dims>(bodies, spec, pixel);
  geom::write_image(a.output, voxels.view());
  say(a.output, voxels.view(), pixel);
}

using Work = void (*)(const Arguments&);

/// One medium as a sub-command with the shared options.
CLI::App* add_medium(CLI::App& parent, const std::string& name, const std::string& text,
                     const std::shared_ptr<Arguments>& a, Work work, int& exit_code) {
  auto* command = parent.add_subcommand(name, text);
  command->add_option("--size", a->size, "box: \"6.7 mm\" \"5 mm\" (and a third length in 3D)")
      ->required();
  command->add_option("--pixel-size", a->pixel_size, "edge of one pixel of an image");
  command->add_option("--porosity", a->porosity, "0..1 (0.45)");
  command->add_option("--grain", a->grain, "mean grain diameter, such as \"150 um\"")->required();
  command->add_option("--spread", a->spread, "standard deviation / mean of the grain sizes");
  command->add_option("--throat", a->throat, "least throat width: gap between grains");
  command->add_flag("--periodic", a->periodic, "opposite faces fit together");
  command->add_option("--seed", a->seed, "another seed, another medium (1)");
  command->add_option("-o,--output", a->output, "the file to write")->required();
  command->callback([a, work, &exit_code] {
    int rank = 0;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    if (rank == 0) {
      work(*a);
    }
    exit_code = exit_code::done;
  });
  return command;
}

}  // namespace

void add_generate(CLI::App& app, int& exit_code) {
  auto* command = app.add_subcommand("generate", "Make synthetic media");
  command->require_subcommand(1);
  command->footer(
      "Examples:\n"
      "  porefines generate micromodel --size \"6.7 mm\" \"5 mm\" --pixel-size \"4 um\" "
      "--porosity 0.503 --grain \"200 um\" --throat \"20 um\" -o chip.png\n"
      "  porefines generate discs --size \"2 mm\" \"1 mm\" --grain \"80 um\" --throat \"15 um\" "
      "--porosity 0.5 -o discs.txt\n"
      "  porefines generate pack --size \"1 mm\" --grain \"100 um\" --porosity 0.42 --periodic "
      "-o pack.txt");
  const auto medium = [&](const std::string& name, const std::string& text, Work work) {
    const auto a = std::make_shared<Arguments>();
    return std::pair{a, add_medium(*command, name, text, a, work, exit_code)};
  };
  const auto [a, micromodel] =
      medium("micromodel", "Irregular grains like a cut through sandstone (PNG or TIFF)",
             generate_micromodel);
  micromodel->add_option("--roughness", a->roughness, "0 polygons .. 1 convex-concave (0.5)");
  micromodel->add_option("--cemented", a->cemented, "share of neighbours grown together (0.05)");
  medium("discs", "Discs at random (list .txt, PNG or TIFF)", generate_packing<2>);
  medium("pack", "Spheres at random (list .txt or TIFF stack)", generate_packing<3>);
}

}  // namespace porefines
