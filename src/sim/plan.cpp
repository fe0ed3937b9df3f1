// SPDX-License-Identifier: MPL-2.0
#include "sim/plan.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "analysis/permeability.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/progress.hpp"
#include "flow/gcr.hpp"
#include "flow/smoother.hpp"
#include "grid/block.hpp"

namespace porefines::sim {
namespace {

constexpr Real base_bytes = 28e6;    ///< MPI, libraries, code
constexpr Real packed_bytes = 131;   ///< per cell in an active line: Krylov vectors, their places
constexpr Real voxel_bytes = 1;      ///< per voxel of an image, as long as it is held
constexpr Real distance_bytes = 28;  ///< per voxel while distances are found, before the solve
constexpr Real result_bytes = 4;     ///< per cell: share of solid
constexpr Real float_bytes = 4;
constexpr Real setup_fields = 18;   ///< of the finest level before the coarse ones are made
constexpr Real finest_fields = 21;  ///< per cell of the finest level during the solve
constexpr Real lent_fields = 4;     ///< of these more where several ranks share the solve
constexpr Real coarse_fields = 19;

constexpr Real opened_lines =
    1.06;  ///< lines without a pore voxel where a smooth surface opens faces

/// Cells in the lines of a row, per cell.
Real padding(int cells) {
  const Real lines = std::ceil((cells + 3.0) / grid::line_width);
  return lines * grid::line_width / cells;
}

/// Cells in memory of all ranks, ghosts and padding too, of one grid.
Real stored_cells(const par::Decomposition& cut, const std::array<bool, 3>& periodic) {
  Real cells = 0;
  for (int rank = 0; rank < product(cut.ranks); ++rank) {
    cells += static_cast<Real>(grid::make_block(cut, rank, periodic, flow::sweep_depth).size);
  }
  return cells;
}

/// Bytes of the fields of all coarse levels of all ranks. Small levels are whole on every rank.
Real coarse_bytes(par::Decomposition cut, const std::array<bool, 3>& periodic) {
  const auto ranks = static_cast<Real>(product(cut.ranks));
  Real cells = 0;
  while (product(cut.cells) > 1) {
    cut = cut.coarsened();
    if (product(cut.cells) > flow::Hierarchy::replicate_below) {
      cells += stored_cells(cut, periodic);
    } else {
      const par::Decomposition whole{
          cut.cells, {1, 1, 1}, {{{0, cut.cells[0]}, {0, cut.cells[1]}, {0, cut.cells[2]}}}};
      cells += ranks * stored_cells(whole, periodic);
    }
  }
  return cells * coarse_fields * float_bytes;
}

/// Volume of flow through the sample per second, guessed [m/s].
Real guess_velocity(const config::Case& the_case, const Domain& domain, Real permeability) {
  const config::Flow& flow = the_case.flow;
  if (!flow.inlet) {
    return permeability * std::abs(flow.pressure_gradient[domain.axis]) / the_case.fluid.viscosity;
  }
  for (const auto& opening : {flow.inlet, flow.outlet}) {
    if (opening->kind == config::DriveKind::flow_rate) {
      return std::abs(opening->value) / domain.area();
    }
    if (opening->kind == config::DriveKind::velocity) {
      return std::abs(opening->value);
    }
  }
  const Real drop = std::abs(flow.inlet->value - flow.outlet->value);
  return permeability * drop / domain.length() / the_case.fluid.viscosity;
}

/// [bytes/s] of all ranks at once: a triad over more memory than the caches hold.
Real measure_bandwidth(const par::Communicator& comm) {
  constexpr std::size_t count = 2 << 20;
  std::vector<float> a(count, 1), b(count, 2), c(count, 3);
  const auto start = std::chrono::steady_clock::now();
  constexpr int repeats = 4;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    for (std::size_t i = 0; i < count; ++i) {
      a[i] = b[i] + static_cast<float>(repeat) * c[i];
    }
    std::swap(a, b);
  }
  const std::chrono::duration<Real> taken = std::chrono::steady_clock::now() - start;
  const Real kept_alive = a[count / 2] > 1e30F ? 1 : 0;
  return comm.size() * 16.0 * count * repeats / (comm.max(taken.count()) + kept_alive);
}

std::string lengths(const Vec3& size) {
  return fmt::format("{:.4g} x {:.4g} x {:.4g} um", size.x * 1e6, size.y * 1e6, size.z * 1e6);
}

}  // namespace

Real estimate_memory(const geom::Sample& sample, const Domain& domain, const Probe& probe,
                     const par::Decomposition& cut) {
  const Index ranks = product(cut.ranks);
  const std::array<bool, 3> periodic = domain.boundaries.periodic();
  const auto cells = static_cast<Real>(product(domain.cells));
  const Real voxels =
      sample.spec.kind == geom::Kind::image ? static_cast<Real>(product(sample.voxels.n)) : 0;
  const Real stored = stored_cells(cut, periodic);
  const Real lines = cells * probe.active_share * padding(domain.cells[0]) * opened_lines;
  const Real fields = finest_fields + (ranks > 1 ? lent_fields : 0);
  const Real solve = fields * float_bytes * stored + coarse_bytes(cut, periodic) +
                     packed_bytes * lines + result_bytes * cells;
  const Real set_up = setup_fields * float_bytes * stored + distance_bytes * voxels;
  return static_cast<Real>(ranks) * base_bytes + voxel_bytes * voxels + std::max(solve, set_up);
}

Plan make_plan(const config::Case& the_case, const geom::Sample& sample, const Domain& domain,
               const Probe& probe, const par::Decomposition& cut) {
  Plan plan;
  plan.cells = product(domain.cells);
  plan.active_cells =
      static_cast<Index>(std::llround(probe.active_share * static_cast<Real>(plan.cells)));
  plan.memory = estimate_memory(sample, domain, probe, cut);
  const flow::SolveOptions solve;
  plan.memory_most = plan.memory + direction_bytes * (solve.most_directions - solve.directions) *
                                       static_cast<Real>(plan.active_cells);
  const Real surface = std::max(probe.specific_surface, 1 / domain.length());
  plan.permeability = std::pow(probe.porosity, 3) / (5 * surface * surface);
  plan.velocity = guess_velocity(the_case, domain, plan.permeability);
  if (probe.porosity > 0) {
    plan.reynolds = the_case.fluid.density * plan.velocity / probe.porosity *
                    analysis::equivalent_pore_diameter(plan.permeability, probe.porosity) /
                    the_case.fluid.viscosity;
  }
  return plan;
}

void estimate_seconds(const config::Case& the_case, Plan& plan, const par::Communicator& comm) {
  constexpr Real setup_bytes = 20e3;   // moved per cell for links, mobility, coarse grids
  constexpr Real cycle_bytes = 2.5e3;  // and per active cell in a cycle
  constexpr Real fixed = 0.5;          // [s] start, pictures
  const Real bandwidth = measure_bandwidth(comm);
  const Real cycles = -2 * std::log10(the_case.flow.tolerance);
  const auto& periodic = the_case.flow.periodic;
  const auto solves = the_case.flow.tensor ? std::count(periodic.begin(), periodic.end(), true) : 1;
  plan.cycle_seconds = cycle_bytes * static_cast<Real>(plan.active_cells) / bandwidth;
  plan.seconds = fixed + setup_bytes * static_cast<Real>(plan.cells) / bandwidth +
                 cycles * static_cast<Real>(solves) * plan.cycle_seconds;
}

void require_memory(const config::Case& the_case, const Plan& plan, const Domain& domain,
                    const par::Communicator& comm) {
  MPI_Comm node = MPI_COMM_NULL;
  MPI_Comm_split_type(comm.handle(), MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
  int ranks_here = 1;
  MPI_Comm_size(node, &ranks_here);
  MPI_Comm_free(&node);
  const auto available = static_cast<Real>(available_memory());
  const Real wanted = plan.memory * ranks_here / comm.size();
  const Real excess = comm.max(wanted / std::max<Real>(available, 1));
  if (excess <= 1) {
    return;
  }
  const Real coarser = std::cbrt(excess) * 1.02;
  const std::string advice =
      the_case.grid.cell_size > 0
          ? fmt::format("cell_size = \"{:.3g} um\"", the_case.grid.cell_size * coarser * 1e6)
          : fmt::format("cells = [{}, {}, {}]",
                        std::max(1, static_cast<int>(domain.sample_cells()[0] / coarser)),
                        std::max(1, static_cast<int>(domain.sample_cells()[1] / coarser)),
                        std::max(1, static_cast<int>(domain.sample_cells()[2] / coarser)));
  throw InputError(fmt::format(
      "[grid] {} x {} x {} cells need about {}, {:.3g} times what this machine has free\n"
      "this would fit: {}; or use more machines, or a crop of the image",
      domain.cells[0], domain.cells[1], domain.cells[2],
      format_bytes(static_cast<std::int64_t>(plan.memory)), excess, advice));
}

std::vector<std::string> describe(const config::Case& the_case, const geom::Sample& sample,
                                  const Domain& domain, const Probe& probe, const Plan& plan) {
  std::vector<std::string> lines;
  lines.push_back(
      fmt::format("sample     {}, porosity {:.4f}", lengths(domain.sample_size), probe.porosity));
  if (!sample.bodies.empty()) {
    Real radius = 0;
    for (const geom::Body& body : sample.bodies) {
      radius += body.radius / static_cast<Real>(sample.bodies.size());
    }
    lines.push_back(fmt::format("grains     {}, mean diameter {:.4g} um, {:.1f} cells",
                                sample.bodies.size(), 2e6 * radius, 2 * radius / domain.spacing.x));
  }
  lines.push_back(fmt::format("grid       {} x {} x {} = {} cells of {}", domain.cells[0],
                              domain.cells[1], domain.cells[2], plan.cells,
                              lengths(domain.spacing)));
  if (domain.reservoir > 0) {
    lines.push_back(fmt::format("reservoirs {} cells of open fluid before and after the sample",
                                domain.reservoir));
  }
  if (const Real d = the_case.analysis.fine_diameter; d > 0) {
    lines.push_back(fmt::format("fines      {:.4g} um, D/d of a cell: {:.2f} cells per diameter",
                                d * 1e6, d / domain.spacing.x));
  }
  lines.push_back(
      fmt::format("expected   k about {:.2g} darcy, Darcy velocity {:.2g} m/s, Re {:.1g} "
                  "(guess from porosity and surface)",
                  plan.permeability / darcy, plan.velocity, plan.reynolds));
  lines.push_back(fmt::format("cost       {} of memory ({} if the solve is a hard one){}",
                              format_bytes(static_cast<std::int64_t>(plan.memory)),
                              format_bytes(static_cast<std::int64_t>(plan.memory_most)),
                              plan.seconds > 0 ? ", about " + format_duration(plan.seconds) : ""));
  return lines;
}

}  // namespace porefines::sim
