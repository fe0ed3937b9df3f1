// SPDX-License-Identifier: MPL-2.0
#include "sim/coupled_pictures.hpp"

#include <algorithm>

#include "par/gather.hpp"
#include "sim/dry_results.hpp"
#include "sim/pictures.hpp"

namespace porefines::sim {
namespace {

struct Fine {
  std::uint64_t id;
  Vec3 centre;
  Real radius;
  Real speed;
};

/// Everybody's fines on rank 0, with the fates of the last sample; who came in since then pipes.
std::vector<report::DrawnFine> gather_fines(const CoupledRun& run, const Readings& readings) {
  const dem::Particles& p = run.particles.system.particles();
  std::vector<Fine> mine;
  for (std::size_t i = 0; i < p.owned; ++i) {
    mine.push_back({p.id[i], p.position[i], p.radius[i], norm(p.velocity[i])});
  }
  const std::vector<analysis::Fate>& fates = run.state.readings.clogging.fates;
  std::vector<report::DrawnFine> fines;
  for (const Fine& fine : par::gather(run.comm(), mine)) {
    const auto found = std::lower_bound(readings.ids.begin(), readings.ids.end(), fine.id);
    const auto place = static_cast<std::size_t>(found - readings.ids.begin());
    const bool known = found != readings.ids.end() && *found == fine.id && place < fates.size();
    fines.push_back(
        {fine.centre, fine.radius, fine.speed, known ? fates[place] : analysis::Fate::piping});
  }
  return fines;
}

std::vector<std::array<Vec3, 2>> clogged_chords(const CoupledRun& run, const Readings& readings) {
  std::vector<std::array<Vec3, 2>> chords;
  for (const analysis::Clog& clog : run.state.readings.clogging.clogs) {
    const geom::Throat& throat =
        readings.setup.network.throats[static_cast<std::size_t>(clog.throat)];
    chords.push_back({throat.from, throat.to});
  }
  return chords;
}

}  // namespace

RunCanvas make_canvas(const Domain& domain, const geom::Sample& sample,
                      const flow::StokesSolver::CellFields& clean, std::span<const float> solid,
                      const grid::Block& block, const par::Communicator& comm) {
  RunCanvas canvas;
  canvas.chip = is_chip(sample, domain);
  const std::vector<float> speed = speeds_of(clean);
  canvas.range = {0, comm.max(speed.empty() ? 0.0 : *std::max_element(speed.begin(), speed.end()))};
  if (canvas.chip) {
    const report::SliceValues plane = gather_mid_slice(speed, solid, block, domain, 2, comm);
    on_root(comm, [&] {
      const report::Slice slice = plane.view();
      canvas.range = report::value_range({&slice, 1}, {.quantity = "speed", .unit = "m/s"});
    });
    return canvas;
  }
  for (int axis = 0; axis < 3; ++axis) {
    canvas.rock[axis] = gather_mean_slice(solid, block, domain, axis, comm);
  }
  return canvas;
}

report::Picture paint_run(const CoupledRun& run, const RunCanvas& canvas, const Readings& readings,
                          const MomentFields& fields, std::span<const float> solid,
                          report::FineColour colour) {
  const report::RunStyle style{.title = title_of_moment(run.particles),
                               .colour = colour,
                               .range = canvas.range,
                               .flow_to = flow_to(run.the_case.flow)};
  report::SliceValues plane;
  if (canvas.chip) {
    plane =
        gather_mid_slice(speeds_of(fields()), solid, run.solver.block(), run.domain, 2, run.comm());
  }
  report::RunView view{run.domain.origin(), gather_fines(run, readings), {}};
  report::Picture picture;
  on_root(run.comm(), [&] {
    view.clogged = clogged_chords(run, readings);
    picture = canvas.chip ? report::draw_chip(plane.view(), view, style)
                          : report::draw_projections({canvas.rock[0].view(), canvas.rock[1].view(),
                                                      canvas.rock[2].view()},
                                                     view, style);
  });
  return picture;
}

}  // namespace porefines::sim
