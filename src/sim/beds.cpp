// SPDX-License-Identifier: MPL-2.0
#include "sim/beds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <mpi.h>

#include "core/error.hpp"
#include "dem/packing.hpp"
#include "sim/particle_setup.hpp"

namespace porefines::sim {
namespace {

std::string place(const Vec3& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x.x, x.y, x.z);
}

dem::PackingSpace space_of(const config::Particles& species, std::size_t index,
                           const config::Case& the_case, const dem::Settings& settings) {
  const dem::Box& box = settings.box;
  dem::PackingSpace space{box.low, box.high, box.periodic, &settings.walls,
                          the_case.run.random_seed + 1000003 * index};
  if (!species.region) {
    return space;
  }
  for (int axis = 0; axis < 3; ++axis) {
    space.low[axis] = species.region->low[axis];
    space.high[axis] = species.region->high[axis];
    const bool whole = space.low[axis] == box.low[axis] && space.high[axis] == box.high[axis];
    space.periodic[axis] = box.periodic[axis] && whole;
    if (space.low[axis] < box.low[axis] || space.high[axis] > box.high[axis]) {
      throw InputError(
          fmt::format("[[particles]] {}: region: {:.6g} m to {:.6g} m along {} is not within the "
                      "box, {:.6g} m to "
                      "{:.6g} m",
                      species.name, space.low[axis], space.high[axis], "xyz"[axis], box.low[axis],
                      box.high[axis]));
    }
  }
  return space;
}

/// Diameters of this many particles, or of as many as take a volume.
std::vector<Real> draw_radii(const config::Particles& species, std::size_t index,
                             std::uint64_t seed, Real volume) {
  constexpr std::uint64_t start = 1ULL << 62;  // apart from those of inlets
  const dem::Sizes sizes = dem_sizes(species.diameter);
  std::vector<Real> radius;
  Real taken = 0;
  for (std::uint64_t k = 0;; ++k) {
    Draws draws(seed, Stream::size, start | static_cast<std::uint64_t>(index) << 40 | k);
    const Real r = dem::draw_diameter(sizes, draws) / 2;
    const Real v = dem::sphere_volume(r);
    if (species.count > 0 ? static_cast<long long>(k) == species.count : taken + v / 2 > volume) {
      return radius;
    }
    taken += v;
    radius.push_back(r);
  }
}

/// Species that are placed at random in the same region, in one go: they must not overlap.
struct Group {
  std::vector<std::size_t> species;  ///< places in the case
};

bool is_placed(const config::Particles& species) {
  return species.count > 0 || species.fill > 0 || species.filling == config::Filling::dense;
}

std::vector<Group> groups_of(const config::Case& the_case) {
  std::vector<Group> groups;
  const auto& all = the_case.particles;
  for (std::size_t s = 0; s < all.size(); ++s) {
    const auto same = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
      const config::Particles& first = all[group.species.front()];
      return first.region == all[s].region && first.filling == all[s].filling;
    });
    if (!is_placed(all[s])) {
      continue;
    }
    (same == groups.end() ? groups.emplace_back() : *same).species.push_back(s);
  }
  return groups;
}

/// Radii of all of a group, those of one species after the other; `count` says how many of each.
std::vector<Real> draw_group(const config::Case& the_case, const Group& group, Real volume,
                             std::vector<std::size_t>& count) {
  std::vector<Real> radius;
  for (const std::size_t s : group.species) {
    const config::Particles& species = the_case.particles[s];
    const bool dense = species.filling == config::Filling::dense;
    const Real left =
        dense ? dem::close_packing * volume - dem::sphere_volume(radius) : species.fill * volume;
    const std::vector<Real> drawn = draw_radii(species, s, the_case.run.random_seed, left);
    if (drawn.empty()) {
      throw InputError(
          fmt::format("[[particles]] {}: there is no room for a single particle", species.name));
    }
    count.push_back(drawn.size());
    radius.insert(radius.end(), drawn.begin(), drawn.end());
  }
  return radius;
}

void require_near_size(const std::string& name, const dem::Packing& packing,
                       const dem::PackingSpace& space) {
  constexpr Real most = 0.1;
  if (std::abs(packing.scale - 1) > most) {
    throw InputError(fmt::format(
        "[[particles]] {}: {} of them packed densely take {:.3g} times their region, {:.3g} m^3\n"
        "leave out count and the region is filled, or change one of the two",
        name, packing.radius.size(), std::pow(packing.scale, -3), space.volume()));
  }
}

/// The particles of a group, appended to those of their species.
void place_group(const config::Case& the_case, const dem::Settings& settings, const Group& group,
                 std::vector<std::vector<dem::Body>>& bodies, Bed& bed) {
  const std::size_t first = group.species.front();
  const config::Particles& leader = the_case.particles[first];
  const dem::PackingSpace space = space_of(leader, first, the_case, settings);
  std::vector<std::size_t> count;
  const std::vector<Real> radius = draw_group(the_case, group, space.volume(), count);
  const bool dense = leader.filling == config::Filling::dense;
  const dem::Packing packing =
      dense ? dem::pack_dense(space, radius) : dem::place_loose(space, radius);
  if (dense) {
    require_near_size(leader.name, packing, space);
    bed.remarks.push_back(
        fmt::format("{}: {} packed densely, diameters x {:.4f}, mean overlap {:.2g} d", leader.name,
                    radius.size(), packing.scale, packing.mean_overlap));
  }
  std::size_t k = 0;
  for (std::size_t g = 0; g < group.species.size(); ++g) {
    const config::Triple& v = the_case.particles[group.species[g]].velocity;
    for (const std::size_t end = k + count[g]; k < end; ++k) {
      dem::Body body;
      body.position = settings.box.wrapped(packing.position[k]);
      body.velocity = {v[0], v[1], v[2]};
      body.radius = packing.radius[k];
      bodies[group.species[g]].push_back(body);
    }
  }
}

void require_inside(const dem::Body& body, const dem::Box& box, const std::string& name) {
  for (int axis = 0; axis < 3; ++axis) {
    const Real x = body.position[axis];
    if (!box.periodic[axis] && (x < box.low[axis] || x > box.high[axis])) {
      throw InputError(fmt::format(
          "[[particles]] {}: particle {} at {} is outside the box, {:.6g} m to {:.6g} m along {}",
          name, body.id, place(body.position), box.low[axis], box.high[axis], "xyz"[axis]));
    }
  }
}

}  // namespace

Bed make_bed(const config::Case& the_case, const dem::Settings& settings) {
  Bed bed;
  std::vector<std::vector<dem::Body>> bodies(the_case.particles.size());
  for (const Group& group : groups_of(the_case)) {
    place_group(the_case, settings, group, bodies, bed);
  }
  for (std::size_t s = 0; s < bodies.size(); ++s) {
    const config::Particles& species = the_case.particles[s];
    if (!species.source.empty()) {
      bodies[s] = read_spheres(species.source, species.diameter.mean);
    }
    for (dem::Body& body : bodies[s]) {
      body.id = bed.bodies.size();
      body.density = species.density;
      body.species = static_cast<std::uint16_t>(s);
      body.flags = species.fixed ? dem::flag::fixed : 0;
      require_inside(body, settings.box, species.name);
      bed.bodies.push_back(body);
    }
  }
  return bed;
}

void require_apart(const dem::System& system, Real most, const par::Communicator& comm) {
  if (system.largest_overlap() <= most && comm.sum(system.wall_trouble().inside) == 0) {
    return;
  }
  dem::ContactRecord worst;
  for (const dem::ContactRecord& contact : system.contacts()) {
    worst = contact.overlap > worst.overlap ? contact : worst;
  }
  struct {
    double overlap;
    int rank;
  } mine{worst.overlap, comm.rank()}, first{};
  MPI_Allreduce(&mine, &first, 1, MPI_DOUBLE_INT, MPI_MAXLOC, comm.handle());
  Vec3 where;
  const dem::Particles& p = system.particles();
  for (std::size_t i = 0; i < p.owned; ++i) {
    where = p.id[i] == worst.first ? p.position[i] : where;
  }
  struct Report {
    std::uint64_t first, second;
    Vec3 where;
    bool wall;
  } report{worst.first, worst.second, where, worst.wall};
  MPI_Bcast(&report, sizeof report, MPI_BYTE, first.rank, comm.handle());
  throw InputError(fmt::format(
      "[[particles]]: at the start particle {} overlaps {} by {:.3g} m, near {}\n"
      "move or shrink it; up to {:.3g} of a radius is allowed, see [contact] max_overlap",
      report.first, report.wall ? "a wall" : fmt::format("particle {}", report.second),
      first.overlap, place(report.where), most));
}

}  // namespace porefines::sim
