// SPDX-License-Identifier: MPL-2.0
// Sentences of the coupled loop about the particles: how far, how stiff, in and out, and when it ends.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "sim/coupled_inertia.hpp"
#include "sim/coupled_state.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

/// Share of the largest overlap by which two particles may come nearer in one substep.
constexpr Real approach_share = 0.25;

/// Travel in a step over coupling.travel, at most: what the flow carries at an expected speed may be faster by this.
constexpr Real longest_travel = 1.5;

/// On the moduli of the case, at most. Where particles creep their stiffness is a matter of computing: nothing but
/// overlaps depends on it, and a fine wedged in a crevice presses its walls with many times the drag.
Real hardest_contact(const CoupledRun& run) {
  return config::is_inertial(run.the_case) ? 1 : 1000;
}

/// How much longer than the last the next step may be. Not suddenly longer: forces on what has just been
/// caught settle first. And what is held back by grains, so slow that its travel would allow any step,
/// feels the flow change on its little way: with dU*/dx dt above 1 it swings about its place, above 2
/// ever more. Its velocity then turns round from step to step, by |U* - U|/|U| = |dU*/dx| dt.
Real growth_of_step(const CoupledRun& run, Real last) {
  constexpr Real growth = 2;
  constexpr Real noticed = 1e-3;  // of the travel that is allowed
  constexpr Real slow = 0.25;
  const dem::Particles& p = run.particles.system.particles();
  const dem::Creeping& c = p.creeping;
  const Vec3& h = run.domain.spacing;
  const Real way = run.the_case.coupling.travel * std::min({h.x, h.y, h.z});
  Real answer = 1 / growth;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const Vec3& was = c.mean_velocity[i];
    const Real speed = norm(was);
    const bool crawls = speed * last > noticed * way && speed * last < slow * way;
    if (crawls && !p.is_fixed(i) && dot(was, c.free_velocity[i]) < 0) {
      answer = std::max(answer, norm(c.free_velocity[i] - was) / speed);
    }
  }
  return std::max(1 / run.comm().max(answer), 1 / growth);
}

}  // namespace

Real choose_step(const CoupledRun& run) {
  if (config::is_inertial(run.the_case)) {
    return choose_inertial_step(run);
  }
  const dem::Particles& p = run.particles.system.particles();
  const Vec3& h = run.domain.spacing;
  Real fastest = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    if (!p.is_fixed(i)) {
      fastest = std::max(fastest, norm(p.creeping.free_velocity[i]));
    }
  }
  fastest = run.comm().max(fastest);
  for (const dem::Inlet& inlet : run.particles.inlets) {
    if (inlet.start < run.the_case.run.end_time && run.time() < inlet.stop) {
      fastest = std::max(fastest, inlet.fastest_flow);
    }
  }
  const Real last = run.particles.state.step;
  const Real left = next_sample(run.particles) - run.time();
  const Real way = run.the_case.coupling.travel * std::min({h.x, h.y, h.z});
  Real longest = fastest * left > way ? way / fastest : left;
  longest = last > 0 ? std::min(longest, growth_of_step(run, last) * last) : longest;
  return left / std::max(std::ceil(left / longest - 1e-9), 1.0);  // equal steps to the sample
}

Real move_particles(CoupledRun& run, Real step) {
  if (config::is_inertial(run.the_case)) {
    move_with_inertia(run, step);
    return step;
  }
  DryRun& particles = run.particles;
  const dem::Particles& p = particles.system.particles();
  Real smallest = INFINITY;
  for (std::size_t i = 0; i < p.owned; ++i) {
    smallest = std::min(smallest, p.radius[i]);
  }
  smallest = run.comm().min(smallest);
  if (std::isfinite(smallest)) {
    const Vec3& h = run.domain.spacing;
    const dem::CreepReport report = particles.system.creep(
        step, {approach_share * run.the_case.contact.max_overlap * smallest,
               longest_travel * run.the_case.coupling.travel * std::min({h.x, h.y, h.z})});
    run.state.substeps += report.substeps;
    step = report.elapsed;
  }
  advance_clock(particles.state, {step, 1}, next_sample(particles));
  run.state.fluid_passed += std::abs(run.now.darcy.flow_rate) * step;
  return step;
}

void stiffen_contacts(CoupledRun& run) {
  constexpr Real deeper = 1.05;
  CoupledState& state = run.state;
  const Real bound = run.the_case.contact.max_overlap;
  const Real overlap = run.particles.system.largest_overlap();
  // Each time nearer to the bound, and only for a new record: what friction holds wedged in stays where
  // it is, and would be pressed ever harder.
  const Real near = bound * (1 - 0.5 * std::pow(0.7, static_cast<Real>(state.stiffened)));
  const Real most = hardest_contact(run);
  if (state.stiffness < most && overlap > std::max(near, deeper * state.deepest)) {
    const Real wanted = std::clamp(std::pow(overlap / bound, 1.5), 2.0, 8.0);
    const Real factor = std::min(wanted, most / state.stiffness);
    run.particles.system.soften(factor);
    state.stiffness *= factor;
    state.deepest = overlap;
    ++state.stiffened;
  }
}

void require_bearable(const CoupledRun& run) {
  constexpr Real bearable = 10;
  if (run.state.stiffness >= hardest_contact(run)) {
    require_healthy(run.particles);
    return;
  }
  const Real overlap = run.particles.system.largest_overlap();
  const Real most = run.the_case.contact.max_overlap;
  if (overlap > bearable * most) {
    throw RunError(fmt::format(
        "two particles, or one and a wall, overlap by {:.3g} of a radius at {:.6g} s, although "
        "contacts stiffen towards [contact] max_overlap = {:.3g}\ntry a smaller coupling.travel "
        "(now "
        "{:.3g} cells)",
        overlap, run.time(), most, run.the_case.coupling.travel));
  }
}

namespace {

Real particle_volume(const CoupledRun& run) {
  const dem::Particles& p = run.particles.system.particles();
  Real volume = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    volume += dem::sphere_volume(p.radius[i]);
  }
  return run.comm().sum(volume);
}

}  // namespace

std::string pass_openings(CoupledRun& run, Real step) {
  const Real before = particle_volume(run);
  std::string left = take_out(run.particles);
  const Real between = particle_volume(run);
  inject_due(run.particles, run.time() - step, run.time());
  run.state.volume_out += before - between;
  run.state.volume_in += particle_volume(run) - between;
  run.particles.state.ledger.require_balance(
      run.comm().sum(static_cast<Index>(run.particles.system.particles().owned)), run.time());
  return left;
}

std::string limit_reached(const CoupledRun& run) {
  constexpr Real clogged =
      1e-4;  // of the clean permeability: what seeps through the pores of a clog
  const config::Run& limits = run.the_case.run;
  const Real ratio = run.permeability_ratio();
  if (limits.max_pore_volumes > 0 && run.pore_volumes() >= limits.max_pore_volumes) {
    return fmt::format("{:.4g} pore volumes have passed", run.pore_volumes());
  }
  if (ratio < clogged) {
    return "full clog: k/k0 fell below 1e-4";
  }
  if (ratio < limits.min_permeability_ratio) {
    return fmt::format("k/k0 = {:.4g} fell below min_permeability_ratio", ratio);
  }
  if (limits.max_clogged_throats > 0 && run.state.clogged_throats >= limits.max_clogged_throats) {
    return fmt::format("{} clogged, as many as max_clogged_throats",
                       run.state.clogged_throats == 1
                           ? std::string("a throat is")
                           : fmt::format("{} throats are", run.state.clogged_throats));
  }
  if (run.the_case.flow.max_pressure > 0 &&
      run.now.darcy.pressure_drop > run.the_case.flow.max_pressure) {
    return fmt::format("the pump needs {:.4g} Pa, more than max_pressure",
                       run.now.darcy.pressure_drop);
  }
  return "";
}

}  // namespace porefines::sim
