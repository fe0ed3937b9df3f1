// SPDX-License-Identifier: MPL-2.0
#include "sim/grains.hpp"

#include <algorithm>
#include <cmath>

#include "geom/components.hpp"
#include "geom/rasterise.hpp"

namespace porefines::sim {
namespace {

constexpr int margin = 8;       ///< cells around a block at which the solver may ask
constexpr Real band_cells = 4;  ///< distances matter within two cells of the surface

bool is_staircase(const config::Case& the_case) {
  return the_case.geometry.kind == config::GeometryKind::image &&
         the_case.geometry.surface == config::Surface::voxel;
}

/// Calls visit(cell, centre relative to the sample's corner, inside the sample?) for every cell.
template <typename Visit>
void for_cells(const Domain& domain, const grid::Block& block, const Visit& visit) {
  const Vec3 corner = domain.origin();
  std::size_t at = 0;
  for (int k = 0; k < block.n[2]; ++k) {
    for (int j = 0; j < block.n[1]; ++j) {
      for (int i = 0; i < block.n[0]; ++i, ++at) {
        const Int3 cell{block.start[0] + i, block.start[1] + j, block.start[2] + k};
        const int along = cell[domain.axis];
        const Vec3 centre =
            corner + Vec3{(cell[0] + 0.5) * domain.spacing.x, (cell[1] + 0.5) * domain.spacing.y,
                          (cell[2] + 0.5) * domain.spacing.z};
        visit(at, centre,
              along >= domain.reservoir && along < domain.cells[domain.axis] - domain.reservoir);
      }
    }
  }
}

bool pore_voxel(const geom::Sample& sample, const Domain& domain, Int3 cell) {
  cell[domain.axis] -= domain.reservoir;
  return geom::is_pore(sample.voxels.view(), sample.box.beyond, cell[0], cell[1], cell[2]);
}

/// Pore voxels in components that run through the sample.
Index connected_pores(const geom::Sample& sample, const geom::VoxelView& voxels) {
  const geom::Surroundings& beyond = sample.box.beyond;
  const auto periodic = [&](int a) { return beyond[a] == geom::Beyond::periodic; };
  const int axis = sample.spec.flow_axis;
  const geom::Components parts = geom::find_components(
      voxels, geom::Phase::pore, {periodic(0), periodic(1), periodic(2)}, axis);
  Index connected = 0;
  for (const geom::Component& part : parts.component) {
    connected += geom::percolates(part, periodic(axis)) ? part.voxels : 0;
  }
  return connected;
}

/// Share of the pores between listed grains that carries flow, from an image of about a million voxels
/// or of the cells, whichever is coarser. Collective.
Real connected_share(const geom::Sample& sample, const Domain& domain,
                     const par::Communicator& comm) {
  constexpr Real most_voxels = 1e6;
  const bool along_cylinders =
      sample.spec.kind == geom::Kind::cylinders && sample.spec.flow_axis == 2;
  Real share = 0;
  if (comm.is_root() && !along_cylinders && sample.spec.kind != geom::Kind::empty) {
    const geom::Voxels image =
        geom::rasterise(sample, std::max(domain.spacing.x, geom::pixel_for(sample, most_voxels)));
    const auto pores = std::count(image.pore.begin(), image.pore.end(), 1);
    share = static_cast<Real>(connected_pores(sample, image.view())) /
            static_cast<Real>(std::max<std::ptrdiff_t>(pores, 1));
  } else if (comm.is_root()) {
    share = 1;
  }
  return comm.sum(share);
}

}  // namespace

geom::Solid local_solid(const config::Case& the_case, const geom::Sample& sample,
                        const Domain& domain, const par::Decomposition& cut, int rank) {
  if (is_staircase(the_case)) {
    return geom::Empty{};
  }
  const Vec3 corner = domain.origin();
  const Int3 start = cut.start(rank);
  const Int3 extent = cut.extent(rank);
  Vec3 low;
  Vec3 high;
  Real largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    low[axis] = corner[axis] + (start[axis] - margin) * domain.spacing[axis];
    high[axis] = corner[axis] + (start[axis] + extent[axis] + margin) * domain.spacing[axis];
    largest = std::max(largest, domain.spacing[axis]);
  }
  return geom::make_solid(sample, low, high, band_cells * largest);
}

void link_grains(flow::StokesSolver& solver, const config::Case& the_case,
                 const geom::Sample& sample, const geom::Solid& solid, const Domain& domain) {
  if (is_staircase(the_case)) {
    solver.set_voxels([&](int i, int j, int k) { return pore_voxel(sample, domain, {i, j, k}); });
    return;
  }
  const Vec3 corner = domain.origin();
  solver.set_surface([&](const Vec3& x) { return geom::signed_distance(solid, x + corner); });
}

std::vector<float> solid_fraction(const config::Case& the_case, const geom::Sample& sample,
                                  const geom::Solid& solid, const Domain& domain,
                                  const grid::Block& block) {
  std::vector<float> fraction(static_cast<std::size_t>(block.cells()));
  const Real cell = std::cbrt(domain.spacing.x * domain.spacing.y * domain.spacing.z);
  const bool staircase = is_staircase(the_case);
  for_cells(domain, block, [&](std::size_t at, const Vec3& centre, bool) {
    if (staircase) {
      const auto voxel = [&](int a) {
        return static_cast<int>(std::floor(centre[a] / domain.spacing[a])) +
               (a == domain.axis ? domain.reservoir : 0);
      };
      fraction[at] = pore_voxel(sample, domain, {voxel(0), voxel(1), voxel(2)}) ? 0.0F : 1.0F;
    } else {
      const Real s = geom::signed_distance(solid, centre);
      fraction[at] = static_cast<float>(std::clamp(0.5 - s / cell, 0.0, 1.0));
    }
  });
  return fraction;
}

Porosity measure_porosity(const geom::Sample& sample, const Domain& domain,
                          const grid::Block& block, const std::vector<float>& solid_fraction,
                          const par::Communicator& comm) {
  if (sample.spec.kind == geom::Kind::image) {
    const auto voxels = static_cast<Real>(product(sample.voxels.n));
    const bool kept_all = !sample.spec.only_percolating;
    const Index connected = kept_all && !(sample.voxels.n[2] == 1 && sample.spec.flow_axis == 2)
                                ? connected_pores(sample, sample.voxels.view())
                                : sample.kept_pores;
    return {static_cast<Real>(sample.found_pores) / voxels, static_cast<Real>(connected) / voxels};
  }
  Real grains = 0;
  Real cells = 0;
  for_cells(domain, block, [&](std::size_t at, const Vec3&, bool inside) {
    grains += inside ? solid_fraction[at] : 0;
    cells += inside;
  });
  const Real porosity = 1 - comm.sum(grains) / comm.sum(cells);
  return {porosity, porosity * connected_share(sample, domain, comm)};
}

}  // namespace porefines::sim
