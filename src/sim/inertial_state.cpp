// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_state.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "core/error.hpp"
#include "sim/inertial_setup.hpp"

namespace porefines::sim {
namespace {

constexpr std::size_t most_bodies = 16;

/// The body whose surface is nearest, periodic axes considered.
int nearest_body(const InertialRun& run, const Vec3& x) {
  int best = 0;
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t q = 0; q < run.sample.bodies.size(); ++q) {
    Vec3 d = x + run.domain.origin() - run.sample.bodies[q].centre;
    for (int a = 0; a < 3; ++a) {
      const Real period = run.domain.sample_size[a];
      d[a] -= run.the_case.flow.periodic[a] ? period * std::round(d[a] / period) : 0;
    }
    d.z = run.sample.spec.kind == geom::Kind::cylinders ? 0 : d.z;
    const Real distance = norm(d) - run.sample.bodies[q].radius;
    if (distance < least) {
      least = distance;
      best = static_cast<int>(q);
    }
  }
  return best;
}

/// Sideways waves along the flow, four in the box; the first step makes them fit its walls.
void disturb(InertialRun& run, Real speed) {
  constexpr Real waves = 4;
  const int axis = run.domain.axis;
  const Real k = 2 * std::numbers::pi * waves / run.domain.size()[axis];
  if (speed > 0) {
    run.flow->set_velocity([&](const Vec3& x) {
      Vec3 u;
      u[(axis + 1) % 3] = speed * std::sin(k * x[axis]);
      return u;
    });
  }
}

}  // namespace

InertialRun make_inertial_run(const config::Case& the_case, const geom::Sample& sample,
                              const Domain& domain, flow::StokesSolver& solver,
                              const par::Communicator& comm) {
  InertialRun run{the_case, sample, domain, comm, solver};
  const InertialDrive wanted = inertial_drive(the_case);
  run.drive = wanted.drive;
  run.offset = wanted.offset;
  const Push push = push_of(domain, run.drive);
  run.speed = push.speed;
  const Real speed = expected_speed(the_case, domain, push);
  run.flow = make_inertial_flow(the_case, domain, solver, speed);
  disturb(run, speed * the_case.inertia.disturbance);
  if (sample.spec.kind != geom::Kind::empty) {
    const std::size_t told_apart = sample.bodies.size();
    run.bodies = told_apart <= most_bodies ? std::max(1, static_cast<int>(told_apart)) : 1;
    run.forces = std::make_unique<flow::BodyForces>(
        *run.flow, solver, [&](const Vec3& x) { return run.bodies > 1 ? nearest_body(run, x) : 0; },
        run.bodies);
  }
  return run;
}

Real choose_step(const InertialRun& run) {
  constexpr Real growth = 1.1;
  constexpr Real first = 0.2;  // of a cell
  const config::Inertia& asked = run.the_case.inertia;
  const Vec3& h = run.domain.spacing;
  const Real cell = std::min({h.x, h.y, h.z});
  const Real left = run.the_case.run.end_time - run.flow->time();
  Real step = 0;
  if (run.state.steps == 0) {
    const Push push = push_of(run.domain, run.drive);
    const Real by_speed = push.speed > 0 ? first * asked.courant * cell / push.speed : left;
    const Real fall = std::sqrt(2 * first * cell * run.the_case.fluid.density / push.force);
    step = std::min(by_speed, push.force > 0 ? fall : left);
  } else {
    constexpr Real slack = 0.95;  // the flow may speed up in the step
    const Real wanted = run.state.step * slack * asked.courant /
                        std::max(run.state.courant, std::numeric_limits<Real>::min());
    const bool keep =
        wanted <= growth * run.state.step && run.state.courant <= asked.courant * (1 + 1e-12);
    step = keep ? run.state.step : std::min(wanted, growth * run.state.step);
  }
  if (asked.time_step > 0) {
    step = std::min(step, asked.time_step);
  }
  const Real steps = std::ceil(left / step * (1 - 1e-9));
  return steps <= 20 ? left / steps : step;
}

void advance(InertialRun& run, Real step) {
  flow::StepOptions options;
  options.tolerance = run.the_case.flow.tolerance;
  options.max_cycles = run.the_case.flow.max_cycles;
  const flow::StepReport report = run.flow->advance(step, run.drive, options);
  if (!report.converged) {
    throw RunError(fmt::format(
        "the flow did not converge at {:.6g} s: residual {:.3g} after {} cycles, wanted {:.3g}\n"
        "try a smaller flow.courant, scheme = \"lust\", or a smaller grid.cell_size",
        run.flow->time(), report.residual, report.cycles, options.tolerance));
  }
  ++run.state.steps;
  run.state.cycles += report.cycles;
  run.state.step = step;
  run.state.courant = run.flow->crossing_rate() * step;
}

Real reference_speed(const InertialRun& run, const Vec3& mean_velocity) {
  return run.speed > 0 ? run.speed : std::abs(mean_velocity[run.domain.axis]);
}

Coefficients coefficients(const InertialRun& run, int body, const Vec3& force, Real speed) {
  constexpr Real none = std::numeric_limits<Real>::quiet_NaN();
  const auto& bodies = run.sample.bodies;
  if (bodies.size() != static_cast<std::size_t>(run.bodies) || speed == 0) {
    return {none, none};
  }
  const Real r = bodies[static_cast<std::size_t>(body)].radius;
  const bool sphere = run.sample.spec.kind == geom::Kind::spheres;
  const Real area = sphere ? std::numbers::pi * r * r : 2 * r * run.domain.size().z;
  const Real unit = run.the_case.fluid.density * area * speed * speed / 2;
  const int axis = run.domain.axis;
  return {force[axis] / unit, force[(axis + 1) % 3] / unit};
}

}  // namespace porefines::sim
