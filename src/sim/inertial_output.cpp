// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_output.hpp"

#include <cmath>

#include <fmt/format.h>

#include "analysis/flux.hpp"
#include "analysis/shedding.hpp"
#include "io/read_table.hpp"
#include "sim/prepare.hpp"
#include "sim/results.hpp"
#include "sim/steady_flow.hpp"
#include "sim/tracks.hpp"

namespace porefines::sim {
namespace {

std::string name_of(const InertialRun& run, std::size_t probe) {
  const std::string& name = run.the_case.probe[probe].name;
  return name.empty() ? std::to_string(probe + 1) : name;
}

/// Velocity and pressure in the cell of each probe, four numbers each; zero in grains. Collective.
std::vector<Real> probe_values(InertialRun& run) {
  const auto& probes = run.the_case.probe;
  std::vector<Real> values(4 * probes.size(), 0);
  if (probes.empty()) {
    return values;
  }
  const flow::StokesSolver::CellFields fields = case_fields(run.solver, 1, run.offset);
  const grid::Block& b = run.solver.block();
  for (std::size_t q = 0; q < probes.size(); ++q) {
    Int3 cell{};
    bool mine = true;
    for (int a = 0; a < 3; ++a) {
      const Real x = probes[q].position[a] - run.domain.origin()[a];
      cell[a] = static_cast<int>(std::floor(x / run.domain.spacing[a])) - b.start[a];
      mine = mine && cell[a] >= 0 && cell[a] < b.n[a];
    }
    if (mine) {
      const auto at = static_cast<std::size_t>(cell[0] + b.n[0] * (cell[1] + b.n[1] * cell[2]));
      for (std::size_t a = 0; a < 3; ++a) {
        values[4 * q + a] = fields.velocity[a][at];
      }
      values[4 * q + 3] = fields.pressure[at];
    }
  }
  run.comm.sum(values);
  return values;
}

std::vector<Real> series_values(InertialRun& run) {
  const Vec3 u = run.solver.superficial_velocity();
  std::vector<Real> row{run.flow->time(),
                        u.x,
                        u.y,
                        u.z,
                        analysis::mean(run.solver.plane_fluxes(run.domain.axis)),
                        run.flow->kinetic_energy(),
                        run.state.courant,
                        run.state.step,
                        static_cast<Real>(run.state.cycles)};
  if (run.forces) {
    const std::vector<Vec3> forces = run.forces->sum(run.drive);
    for (int body = 0; body < run.bodies; ++body) {
      const Vec3& f = forces[static_cast<std::size_t>(body)];
      const Coefficients c = coefficients(run, body, f, reference_speed(run, u));
      row.insert(row.end(), {f.x, f.y, f.z, c.drag, c.lift});
    }
  }
  const std::vector<Real> probed = probe_values(run);
  row.insert(row.end(), probed.begin(), probed.end());
  return row;
}

/// [m] from the rear of the only body to where the stream behind it, on the body's axis, turns with
/// the flow again; 0: it never runs backwards. Collective.
Real wake_length(const InertialRun& run) {
  const int a = run.domain.axis;
  const geom::Body& body = run.sample.bodies.front();
  const Vec3 centre = body.centre - run.domain.origin();
  const Vec3& h = run.domain.spacing;
  const int first = a == 0 ? 1 : 0;
  const int second = a == 2 ? 1 : 2;
  const int columns = run.domain.cells[first];
  const Real direction = is_high(flow_to(run.the_case.flow)) ? 1 : -1;
  const bool deep = run.sample.spec.kind == geom::Kind::cylinders;  // along z: any layer
  const auto on_axis = [&](int plane) {
    const std::vector<Real> u = run.solver.plane_velocities(a, plane);
    const auto at = [&](int axis, Real where) {
      return std::clamp(where / h[axis] - 0.5, 0.0, run.domain.cells[axis] - 1.0);
    };
    const Real x = at(first, centre[first]);
    const Real y = deep && second == 2 ? 0 : at(second, centre[second]);
    const int i = std::min(static_cast<int>(x), std::max(columns - 2, 0));
    const int j = static_cast<int>(y);
    const Real share = columns > 1 ? x - i : 0;
    const Real other = run.domain.cells[second] > j + 1 ? y - j : 0;
    const auto value = [&](int p, int q) { return u[static_cast<std::size_t>(q * columns + p)]; };
    const auto row = [&](int q) {
      return (1 - share) * value(i, q) + (share > 0 ? share * value(i + 1, q) : 0);
    };
    return direction * ((1 - other) * row(j) + (other > 0 ? other * row(j + 1) : 0));
  };
  const Real rear = centre[a] + direction * body.radius;
  Real before = 0;
  const int step = direction > 0 ? 1 : -1;
  for (int plane = static_cast<int>(std::round(rear / h[a])) + step;
       plane > 0 && plane < run.domain.cells[a]; plane += step) {
    const Real here = on_axis(plane);
    if (here > 0 && before < 0) {
      const Real where = (plane - step * here / (here - before)) * h[a];
      return std::abs(where - rear);
    }
    if (here > 0 && before == 0 && std::abs(plane * h[a] - rear) > body.radius) {
      return 0;
    }
    before = here;
  }
  return 0;
}

}  // namespace

std::vector<std::string> inertial_columns(const InertialRun& run) {
  std::vector<std::string> names{"time_s",
                                 "mean_velocity_x_m_s",
                                 "mean_velocity_y_m_s",
                                 "mean_velocity_z_m_s",
                                 "flow_rate_m3_s",
                                 "kinetic_energy_j",
                                 "courant",
                                 "time_step_s",
                                 "solver_cycles"};
  for (int body = 1; body <= run.bodies; ++body) {
    for (const std::string part :
         {"force_x_n", "force_y_n", "force_z_n", "drag_coefficient", "lift_coefficient"}) {
      names.push_back(fmt::format("body_{}_{}", body, part));
    }
  }
  for (std::size_t q = 0; q < run.the_case.probe.size(); ++q) {
    for (const std::string part :
         {"velocity_x_m_s", "velocity_y_m_s", "velocity_z_m_s", "pressure_pa"}) {
      names.push_back(fmt::format("probe_{}_{}", name_of(run, q), part));
    }
  }
  return names;
}

InertialSink open_inertial_sink(const std::string& folder, const InertialRun& run,
                                const io::Provenance& provenance, Start start) {
  InertialSink sink{folder, provenance};
  const Real time = run.flow->time();
  on_root(run.comm, [&] {
    sink.series.emplace(open_table(folder + "/series.csv", inertial_columns(run), time, start));
  });
  if (config::find_output(run.the_case, config::OutputKind::fields) != nullptr) {
    sink.fields.emplace(
        open_fields(folder, run.domain, run.solver.block(), provenance, run.comm, start, time));
  }
  return sink;
}

void write_inertial(InertialRun& run, InertialSink& sink, std::span<const float> solid) {
  const Real now = run.flow->time();
  const Real every = sample_interval(run.the_case, config::OutputKind::summary);
  if (now >= static_cast<Real>(run.state.samples) * every * (1 - 1e-12)) {
    const std::vector<Real> row = series_values(run);
    on_root(run.comm, [&] { sink.series->append(row); });
    run.state.samples = static_cast<Index>(std::floor(now / every * (1 + 1e-12))) + 1;
  }
  const config::Output* fields = config::find_output(run.the_case, config::OutputKind::fields);
  const bool last = now >= run.the_case.run.end_time * (1 - 1e-12);
  const bool due = fields != nullptr && fields->every > 0
                       ? now >= static_cast<Real>(run.state.fields_written) * fields->every
                       : last;
  if (sink.fields && due) {
    write_fields(*sink.fields, now, case_fields(run.solver, 1, run.offset), solid);
    ++run.state.fields_written;
  }
}

void add_inertial(Json& json, InertialRun& run, const std::string& folder) {
  const Vec3 u = run.solver.superficial_velocity();
  const Real speed = reference_speed(run, u);
  json.set("regime", "navier-stokes");
  json.set("time_s", run.flow->time());
  json.set("steps", run.state.steps);
  json.set("solver_cycles", run.state.cycles);
  json.set("courant", run.state.courant);
  json.set("kinetic_energy_j", run.flow->kinetic_energy());
  json.set("reference_speed_m_s", speed);
  if (!run.forces) {
    return;
  }
  const std::vector<Vec3> forces = run.forces->sum(run.drive);
  const bool steady = run.the_case.inertia.steady;
  io::TextTable table;
  if (run.comm.is_root() && !steady) {
    table = io::read_table(folder + "/series.csv");
  }
  for (int body = 0; body < run.bodies; ++body) {
    const std::string prefix = fmt::format("body_{}_", body + 1);
    const Vec3& f = forces[static_cast<std::size_t>(body)];
    const Coefficients c = coefficients(run, body, f, speed);
    json.set(prefix + "force_x_n", f.x);
    json.set(prefix + "force_y_n", f.y);
    json.set(prefix + "force_z_n", f.z);
    json.set(prefix + "drag_coefficient", c.drag);
    json.set(prefix + "lift_coefficient", c.lift);
    if (run.comm.is_root() && !steady && std::isfinite(c.drag)) {
      const analysis::Shedding shed = analysis::find_shedding(
          table.numbers("time_s"), table.numbers(prefix + "drag_coefficient"),
          table.numbers(prefix + "lift_coefficient"));
      const Real diameter = 2 * run.sample.bodies[static_cast<std::size_t>(body)].radius;
      json.set(prefix + "mean_drag_coefficient", shed.drag);
      json.set(prefix + "lift_amplitude", shed.lift);
      json.set(prefix + "strouhal", shed.frequency * diameter / speed);
      json.set(prefix + "periods", shed.periods);
    }
  }
  if (run.sample.bodies.size() == 1 && !run.the_case.inertia.lid) {
    const Real wake = wake_length(run);
    json.set("reynolds_body", run.the_case.fluid.density * speed * 2 *
                                  run.sample.bodies.front().radius / run.the_case.fluid.viscosity);
    json.set("wake_length_m", wake);
    json.set("wake_length_over_diameter", wake / (2 * run.sample.bodies.front().radius));
  }
}

}  // namespace porefines::sim
