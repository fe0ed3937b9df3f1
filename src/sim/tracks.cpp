// SPDX-License-Identifier: MPL-2.0
#include "sim/tracks.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include <fmt/format.h>

#include "par/gather.hpp"

namespace porefines::sim {
namespace {

constexpr std::size_t width = 18;  ///< numbers per particle: id, x, v, w, d, retained?, F, T

void pack(const dem::Particles& p, std::size_t i, std::vector<Real>& out) {
  const bool held = (p.flags[i] & (dem::flag::fixed | dem::flag::retained)) != 0;
  out.push_back(static_cast<Real>(p.id[i]));  // exact up to 2^53
  for (const Vec3& v : {p.position[i], p.velocity[i], p.angular_velocity[i]}) {
    out.insert(out.end(), {v.x, v.y, v.z});
  }
  out.push_back(2 * p.radius[i]);
  out.push_back(held ? 1 : 0);
  for (const Vec3& v : {p.force[i], p.torque[i]}) {
    out.insert(out.end(), {v.x, v.y, v.z});
  }
}

/// All ranks' numbers on rank 0, sorted by id.
std::vector<Real> gather_sorted(const par::Communicator& comm, const std::vector<Real>& mine) {
  const std::vector<Real> all = par::gather(comm, mine);
  std::vector<std::size_t> order(all.size() / width);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return all[width * a] < all[width * b]; });
  std::vector<Real> sorted;
  sorted.reserve(all.size());
  for (const std::size_t k : order) {
    sorted.insert(sorted.end(), all.begin() + static_cast<std::ptrdiff_t>(width * k),
                  all.begin() + static_cast<std::ptrdiff_t>(width * (k + 1)));
  }
  return sorted;
}

std::string rows_of(const DryRun& run, const std::vector<Real>& numbers, bool out) {
  const config::Output* tracks = config::find_output(run.the_case, config::OutputKind::tracks);
  std::string text;
  for (std::size_t at = 0; tracks != nullptr && at < numbers.size(); at += width) {
    const Real* n = numbers.data() + at;
    auto end = std::back_inserter(text);
    fmt::format_to(end, "{},{}", run.state.time, static_cast<std::uint64_t>(n[0]));
    for (int c = 1; c <= 10; ++c) {
      fmt::format_to(end, ",{}", n[c]);
    }
    text += out ? ",out" : n[11] > 0 ? ",retained" : ",mobile";
    for (int c = 12; tracks->forces && c < 18; ++c) {
      fmt::format_to(end, ",{}", n[c]);
    }
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<std::string> track_columns(bool forces) {
  std::vector<std::string> names{"time_s",   "id",         "x_m",   "y_m",      "z_m",
                                 "u_m_s",    "v_m_s",      "w_m_s", "wx_rad_s", "wy_rad_s",
                                 "wz_rad_s", "diameter_m", "state"};
  if (forces) {
    names.insert(names.end(), {"fx_n", "fy_n", "fz_n", "tx_nm", "ty_nm", "tz_nm"});
  }
  return names;
}

std::string track_rows(const DryRun& run) {
  std::vector<Real> mine;
  for (std::size_t i = 0; i < run.system.particles().owned; ++i) {
    pack(run.system.particles(), i, mine);
  }
  return rows_of(run, gather_sorted(run.comm, mine), false);
}

std::string out_rows(const DryRun& run, const std::function<bool(std::size_t)>& leaves) {
  std::vector<Real> mine;
  for (std::size_t i = 0; i < run.system.particles().owned; ++i) {
    if (leaves(i)) {
      pack(run.system.particles(), i, mine);
    }
  }
  return rows_of(run, gather_sorted(run.comm, mine), true);
}

std::vector<std::string> series_columns() {
  return {"time_s",         "particles_inside", "particles_injected", "particles_out",
          "mean_speed_m_s", "mean_x_m",         "mean_y_m",           "mean_z_m",
          "sigma_x_m",      "sigma_y_m",        "sigma_z_m",          "kinetic_j",
          "rotational_j",   "elastic_j",        "energy_j",           "energy_lost_j",
          "dissipated_j",   "contacts",         "wall_contacts",      "coordination_number",
          "max_overlap",    "time_step_s"};
}

std::vector<Real> series_row(const DryRun& run, const Moment& now) {
  const Ledger& ledger = run.state.ledger;
  return {run.state.time,
          static_cast<Real>(now.totals.particles),
          static_cast<Real>(ledger.placed + ledger.injected),
          static_cast<Real>(ledger.out),
          now.mean_speed,
          now.mean.x,
          now.mean.y,
          now.mean.z,
          now.sigma.x,
          now.sigma.y,
          now.sigma.z,
          now.totals.kinetic,
          now.totals.rotational,
          now.totals.elastic,
          now.energy,
          now.energy_lost,
          now.dissipated,
          static_cast<Real>(now.totals.contacts),
          static_cast<Real>(now.totals.wall_contacts),
          now.coordination,
          now.max_overlap,
          run.state.step};
}

io::SeriesWriter open_table(const std::string& path, const std::vector<std::string>& names,
                            Real time, Start start) {
  return start == Start::resumed ? io::SeriesWriter::resume(path, names, time)
                                 : io::SeriesWriter(path, names);
}

bool falls_due(DryRun& run, config::OutputKind kind) {
  Index& written = run.state.written_of(kind);
  const Real due = static_cast<Real>(written) * sample_interval(run.the_case, kind);
  const bool now = is_sampled(run.the_case, kind) && run.state.time >= due * (1 - 1e-12);
  written += now ? 1 : 0;
  return now;
}

bool is_sampled(const config::Case& the_case, config::OutputKind kind) {
  const config::Output* output = config::find_output(the_case, kind);
  using enum config::OutputKind;
  return kind == summary ||
         (output != nullptr && (kind == tracks || kind == movie || output->every > 0));
}

Real sample_interval(const config::Case& the_case, config::OutputKind kind) {
  constexpr Real samples = 100;
  const config::Output* output = config::find_output(the_case, kind);
  return output != nullptr && output->every > 0 ? output->every : the_case.run.end_time / samples;
}

}  // namespace porefines::sim
