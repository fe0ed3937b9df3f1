// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_results.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/memory.hpp"
#include "core/progress.hpp"
#include "par/gather.hpp"
#include "report/draw_particles.hpp"
#include "sim/particle_setup.hpp"
#include "sim/session.hpp"

namespace porefines::sim {
namespace {

constexpr Real particle_rate = 10e6;      ///< particle-steps a second and rank, about
constexpr Real bytes_per_particle = 2e3;  ///< arrays, lists and their history
constexpr Real base_bytes = 75e6;

/// All particles, coloured by speed, on rank 0.
std::vector<report::Disc> gather_discs(const DryRun& run) {
  const dem::Particles& p = run.system.particles();
  std::vector<report::Disc> mine;
  for (std::size_t i = 0; i < p.owned; ++i) {
    mine.push_back({p.position[i], p.radius[i], norm(p.velocity[i])});
  }
  return par::gather(run.comm, mine);
}

Real waiting(const DryRun& run) {
  Real sum = 0;
  for (const dem::InletState& inlet : run.state.inlets) {
    sum += static_cast<Real>(inlet.waiting);
  }
  return sum;
}

std::string law_of(const config::Contact& contact) {
  return contact.model == config::ContactModel::hertz ? "Hertz-Mindlin" : "linear springs";
}

}  // namespace

std::string title_of_moment(const DryRun& run) {
  const std::string& title = run.the_case.run.title;
  return fmt::format("{}, {:.4g} s", title.empty() ? "Particles" : title, run.state.time);
}

Json summarise_dry(const DryRun& run, const Ending& ending, const io::Provenance& provenance) {
  const Moment now = look(run);
  const Ledger& ledger = run.state.ledger;
  const Real peak = run.comm.sum(static_cast<Real>(peak_memory()));
  Json json;
  json.set("status", ending.status);
  if (!ending.reason.empty()) {
    json.set("reason", ending.reason);
  }
  json.set("title", run.the_case.run.title);
  json.set("time_s", run.state.time);
  json.set("particles_placed", ledger.placed);
  json.set("particles_injected", ledger.placed + ledger.injected);
  json.set("particles_inside", now.totals.particles);
  json.set("particles_out", ledger.out);
  json.set("particles_waiting", waiting(run));
  json.set("max_overlap", now.max_overlap);
  json.set("coordination_number", now.coordination);
  json.set("contacts", now.totals.contacts);
  json.set("wall_contacts", now.totals.wall_contacts);
  json.set("mean_speed_m_s", now.mean_speed);
  json.set("kinetic_j", now.totals.kinetic);
  json.set("rotational_j", now.totals.rotational);
  json.set("elastic_j", now.totals.elastic);
  json.set("energy_j", now.energy);
  json.set("energy_lost_j", now.energy_lost);
  json.set("dissipated_by_damping_j", now.totals.dissipated.normal);
  json.set("dissipated_by_friction_j", now.totals.dissipated.sliding);
  json.set("dissipated_by_rolling_j", now.totals.dissipated.rolling);
  json.set("steps", run.state.steps);
  json.set("time_step_s", run.state.step);
  json.set("ranks", provenance.ranks);
  json.set("wall_time_s", ending.wall_time);
  json.set("peak_memory_bytes", static_cast<Index>(peak));
  for (const auto& [name, value] : io::entries(provenance)) {
    if (name != "ranks") {
      json.set(name, value);
    }
  }
  return json;
}

report::Picture paint_dry(const DryRun& run) {
  std::vector<report::Disc> discs = gather_discs(run);
  report::Picture picture;
  on_root(run.comm, [&] {
    const dem::Settings& settings = run.system.settings();
    const Vec3 size = settings.box.high - settings.box.low;
    const bool thin = 4 * size.z <= std::min(size.x, size.y);
    report::Scene scene{settings.box.low, settings.box.high, {0, thin ? 1 : 2}, [&](const Vec3& x) {
                          return in_wall(settings, x);
                        }};
    const report::PictureStyle style{.title = title_of_moment(run),
                                     .quantity = "speed",
                                     .unit = "m/s",
                                     .colormap = report::Colormap::speed};
    picture = report::draw_particles(std::move(discs), scene, style);
  });
  return picture;
}

void draw_dry(const std::string& path, const DryRun& run, const io::Provenance& provenance) {
  write_moment(path, run, paint_dry(run), provenance);
}

void write_moment(const std::string& path, const DryRun& run, const report::Picture& picture,
                  const io::Provenance& provenance) {
  on_root(run.comm,
          [&] { report::write_picture(path, picture, provenance, title_of_moment(run)); });
}

std::vector<std::string> describe_dry(const DryRun& run, const std::vector<std::string>& remarks) {
  const config::Case& the_case = run.the_case;
  const Vec3 size = run.system.settings().box.high - run.system.settings().box.low;
  const Moment now = look(run);
  const Stretch stretch = choose_stretch(run);
  Real entering = 0;
  for (const dem::Inlet& inlet : run.inlets) {
    entering += particles_entering(inlet, inlet.rate, the_case.run.end_time);
  }
  const Real particles = static_cast<Real>(now.totals.particles) + entering;
  const Real steps = the_case.run.end_time / stretch.step;
  const Real seconds = particles * steps / (particle_rate * run.comm.size());
  std::vector<std::string> lines{fmt::format("box        {:.4g} x {:.4g} x {:.4g} mm, no fluid",
                                             1e3 * size.x, 1e3 * size.y, 1e3 * size.z),
                                 fmt::format("particles  {} at the start, {:.0f} to be injected",
                                             now.totals.particles, entering)};
  for (const std::string& remark : remarks) {
    lines.push_back("           " + remark);
  }
  const config::Triple& g = the_case.gravity;
  lines.push_back(g == config::Triple{}
                      ? "gravity    none"
                      : fmt::format("gravity    ({:g}, {:g}, {:g}) m/s^2", g[0], g[1], g[2]));
  lines.push_back(
      fmt::format("contact    {}, restitution {:g}, lasts {:.3g} s; step {:.3g} s = 1/{} of it",
                  law_of(the_case.contact), the_case.contact.restitution,
                  stretch.step * the_case.contact.steps_per_contact, stretch.step,
                  the_case.contact.steps_per_contact));
  lines.push_back(fmt::format("time       {:.4g} s, about {:.3g} steps as fast as now",
                              the_case.run.end_time, steps));
  lines.push_back(fmt::format("cost       {} of memory, about {}",
                              format_bytes(static_cast<std::int64_t>(
                                  run.comm.size() * base_bytes + bytes_per_particle * particles)),
                              format_duration(seconds)));
  return lines;
}

}  // namespace porefines::sim
