// SPDX-License-Identifier: MPL-2.0
#include "sim/steady_flow.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "analysis/flux.hpp"
#include "analysis/permeability.hpp"
#include "core/error.hpp"
#include "core/progress.hpp"
#include "core/signals.hpp"

namespace porefines::sim {
namespace {

using config::DriveKind;

/// One solve with progress, stopped by signals.
class Solving {
 public:
  Solving(const config::Flow& flow, flow::StokesSolver& solver, const par::Communicator& comm,
          int solves)
      : flow_(flow), solver_(solver), comm_(comm), solves_(solves) {
    if (comm.is_root()) {
      progress_ = std::make_unique<Progress>("solve");
    }
  }

  void run(const flow::Drive& drive, SteadyFlow& result) {
    Real first = 0;
    flow::SolveOptions options;
    options.tolerance = flow_.tolerance;
    options.max_cycles = flow_.max_cycles;
    options.progress = [&](int, Real residual) {
      first = first > 0 ? first : residual;
      show(first, residual);
    };
    options.interrupted = [&] {
      result.signal = static_cast<int>(comm_.max(Real{1} * caught_signal()));
      return result.signal != 0;
    };
    const flow::SolveReport report = solver_.solve(drive, options);
    result.solve.cycles += report.cycles;
    result.solve.flux_cycles += report.flux_cycles;
    result.solve.residual = std::max(result.solve.residual, report.residual);
    result.solve.converged = report.converged;
    if (result.signal == 0) {
      require_converged(report);
    }
    ++done_;
  }

 private:
  /// Cycles take off about the same factor each: progress is linear in log(residual).
  void show(Real first, Real residual) {
    if (progress_ && residual > 0 && first > flow_.tolerance) {
      const Real share = std::log(first / residual) / std::log(first / flow_.tolerance);
      best_ = std::max(best_, (done_ + std::clamp(share, 0.0, 1.0)) / solves_);
      progress_->update(best_);
    }
  }

  void require_converged(const flow::SolveReport& report) const {
    if (!std::isfinite(report.residual)) {
      throw RunError(fmt::format(
          "the solve broke down in cycle {}: the residual is not a finite number\n"
          "check viscosity, pressures and cell size; if they are right, please report this case",
          report.cycles));
    }
    if (!report.converged) {
      throw RunError(
          fmt::format("the solve did not converge: residual {:.3g} after {} cycles, wanted {:.3g}\n"
                      "try a larger flow.max_cycles, a looser flow.tolerance, or a smaller "
                      "grid.cell_size where "
                      "grains almost touch",
                      report.residual, report.cycles, flow_.tolerance));
    }
  }

  const config::Flow& flow_;
  flow::StokesSolver& solver_;
  par::Communicator comm_;
  int solves_;
  int done_ = 0;
  Real best_ = 0;
  std::unique_ptr<Progress> progress_;
};

/// Speed along +axis of the fluid at an opening: into the box at the inlet, out of it at the outlet.
Real along_axis(const config::Opening& opening, bool inlet) {
  return is_high(opening.face) == inlet ? -opening.value : opening.value;
}

}  // namespace

OpeningDrive opening_drive(const config::Flow& flow) {
  const config::Opening& inlet = *flow.inlet;
  const config::Opening& outlet = *flow.outlet;
  const auto at = [](const config::Opening& o) { return static_cast<std::size_t>(o.face); };
  OpeningDrive out;
  out.base_at_inlet = outlet.kind != DriveKind::pressure;
  out.base = out.base_at_inlet ? inlet.value : outlet.value;
  const config::Opening& moved = out.base_at_inlet ? outlet : inlet;
  if (moved.kind == DriveKind::velocity) {
    out.drive.face_value[at(moved)] = along_axis(moved, !out.base_at_inlet);
  } else if (moved.kind == DriveKind::flow_rate) {
    out.drive.face_value[at(inlet)] = 1;
    out.wanted_rate = along_axis(moved, !out.base_at_inlet);
  } else {
    out.drive.face_value[at(inlet)] = inlet.value - outlet.value;
  }
  return out;
}

namespace {

/// Pressures at the two faces of the box, as solved; extrapolated where a velocity is given.
std::array<Real, 2> face_pressures(const Domain& domain, const flow::Drive& drive,
                                   const std::vector<Real>& layers) {
  std::array<Real, 2> p{};
  for (const bool high : {false, true}) {
    const bool given = flow::gives_pressure(domain.boundaries.at(domain.axis, high));
    p[high ? 1 : 0] = given ? drive.face_value[2 * domain.axis + (high ? 1 : 0)]
                            : analysis::face_pressure(layers, high);
  }
  return p;
}

/// Scaled so that the wanted rate flows; pressures so that the base pressure stands where it is given.
void scale_to_case(const config::Flow& flow, const OpeningDrive& wanted,
                   const std::array<Real, 2>& faces, SteadyFlow& result) {
  if (wanted.wanted_rate != 0) {
    result.scale = wanted.wanted_rate / result.flow_rate;
  }
  const BoxFace base = (wanted.base_at_inlet ? flow.inlet : flow.outlet)->face;
  result.offset = wanted.base - result.scale * faces[is_high(base) ? 1 : 0];
  result.flow_rate *= result.scale;
  result.velocity *= result.scale;
  result.pressure_drop *= result.scale;
  result.total_drop *= result.scale;
}

void measure_flux(const Domain& domain, const flow::StokesSolver& solver, SteadyFlow& result) {
  const std::vector<Real> fluxes = solver.plane_fluxes(domain.axis);
  result.flow_rate = analysis::mean(fluxes);
  result.flux_variation = analysis::flux_variation(fluxes);
  result.velocity = solver.superficial_velocity();
}

void solve_openings(const config::Case& the_case, const Domain& domain, flow::StokesSolver& solver,
                    const par::Communicator& comm, SteadyFlow& result) {
  const OpeningDrive wanted = opening_drive(the_case.flow);
  Solving(the_case.flow, solver, comm, 1).run(wanted.drive, result);
  if (result.signal != 0) {
    return;
  }
  measure_flux(domain, solver, result);
  const std::vector<Real> layers = solver.layer_pressures(domain.axis);
  const std::array<Real, 2> faces = face_pressures(domain, wanted.drive, layers);
  const analysis::Window window{domain.reservoir, domain.cells[domain.axis] - domain.reservoir};
  result.pressure_drop = analysis::window_pressure_drop(layers, window, faces[0], faces[1]);
  result.total_drop = faces[0] - faces[1];
  scale_to_case(the_case.flow, wanted, faces, result);
  result.permeability =
      analysis::darcy_permeability({result.flow_rate, domain.area(), domain.length(),
                                    result.pressure_drop, the_case.fluid.viscosity});
}

/// Column j of the tensor: the mean velocity under a unit gradient along j.
Vec3 column(const config::Case& the_case, const flow::StokesSolver& solver, Real gradient) {
  return solver.superficial_velocity() * (the_case.fluid.viscosity / gradient);
}

void solve_periodic(const config::Case& the_case, const Domain& domain, flow::StokesSolver& solver,
                    const par::Communicator& comm, SteadyFlow& result) {
  const config::Flow& flow = the_case.flow;
  Vec3 gradient{flow.pressure_gradient[0], flow.pressure_gradient[1], flow.pressure_gradient[2]};
  gradient[domain.axis] += norm(gradient) > 0 ? 0 : 1;  // [Pa/m] a tensor alone names no drive
  const bool one_axis = norm(gradient) == std::abs(gradient[domain.axis]);
  const auto periodic = std::count(flow.periodic.begin(), flow.periodic.end(), true);
  Solving solving(flow, solver, comm,
                  flow.tensor ? static_cast<int>(periodic) + (one_axis ? 0 : 1) : 1);
  if (flow.tensor) {
    result.tensor.emplace();
    for (int j = 0; j < 3 && result.signal == 0; ++j) {
      if (flow.periodic[j] && !(one_axis && j == domain.axis)) {
        flow::Drive drive;
        drive.force[j] = norm(gradient);
        solving.run(drive, result);
        (*result.tensor)[j] = column(the_case, solver, norm(gradient));
      }
    }
  }
  if (result.signal == 0) {
    solving.run({.force = gradient}, result);
  }
  if (result.signal != 0) {
    return;
  }
  if (result.tensor && one_axis) {
    (*result.tensor)[domain.axis] = column(the_case, solver, gradient[domain.axis]);
  }
  measure_flux(domain, solver, result);
  result.pressure_drop = result.total_drop = gradient[domain.axis] * domain.length();
  result.permeability =
      dot(result.velocity, gradient) * the_case.fluid.viscosity / dot(gradient, gradient);
}

}  // namespace

Real sample_pressure_drop(const Domain& domain, const flow::Drive& drive,
                          const flow::StokesSolver& solver) {
  const std::vector<Real> layers = solver.layer_pressures(domain.axis);
  const std::array<Real, 2> faces = face_pressures(domain, drive, layers);
  const analysis::Window window{domain.reservoir, domain.cells[domain.axis] - domain.reservoir};
  return analysis::window_pressure_drop(layers, window, faces[0], faces[1]);
}

DarcyFlow measure_darcy(const config::Case& the_case, const Domain& domain,
                        const flow::Drive& drive, const flow::StokesSolver& solver) {
  DarcyFlow out;
  const std::vector<Real> fluxes = solver.plane_fluxes(domain.axis);
  out.flow_rate = analysis::mean(fluxes);
  out.flux_variation = analysis::flux_variation(fluxes);
  out.pressure_drop = the_case.flow.inlet ? sample_pressure_drop(domain, drive, solver)
                                          : drive.force[domain.axis] * domain.length();
  out.permeability = analysis::darcy_permeability(
      {out.flow_rate, domain.area(), domain.length(), out.pressure_drop, the_case.fluid.viscosity});
  return out;
}

SteadyFlow solve_steady_flow(const config::Case& the_case, const Domain& domain,
                             flow::StokesSolver& solver, const par::Communicator& comm) {
  SteadyFlow result;
  if (the_case.flow.inlet) {
    solve_openings(the_case, domain, solver, comm, result);
  } else {
    solve_periodic(the_case, domain, solver, comm, result);
  }
  if (result.signal == 0 && !std::isfinite(result.permeability)) {
    throw RunError(
        "the permeability is not a finite number: no fluid flows, or the pressure drop vanishes\n"
        "look at the geometry: porefines run CASE.toml --dry-run draws it");
  }
  return result;
}

}  // namespace porefines::sim
