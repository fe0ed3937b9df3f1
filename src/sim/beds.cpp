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
    const Real v = dem::sphere_volume({r});
    if (species.count > 0 ? static_cast<long long>(k) == species.count : taken + v / 2 > volume) {
      return radius;
    }
    taken += v;
    radius.push_back(r);
  }
}

void require_near_size(const config::Particles& species, const dem::Packing& packing,
                       const dem::PackingSpace& space) {
  constexpr Real most = 0.1;
  if (std::abs(packing.scale - 1) > most) {
    throw InputError(
        fmt::format("[[particles]] {}: {} of them packed densely take {:.3g} of the region's "
                    "volume, {:.3g} m^3\n"
                    "leave out count and the region is filled, or change one of the two",
                    species.name, packing.radius.size(),
                    1 / (packing.scale * packing.scale * packing.scale), space.volume()));
  }
}

dem::Packing place_species(const config::Particles& species, std::size_t index,
                           const config::Case& the_case, const dem::Settings& settings) {
  const dem::PackingSpace space = space_of(species, index, the_case, settings);
  const bool dense = species.filling == config::Filling::dense;
  const Real share = dense ? dem::close_packing : species.fill;
  const std::vector<Real> radius =
      draw_radii(species, index, the_case.run.random_seed, share * space.volume());
  if (radius.empty()) {
    throw InputError(fmt::format("[[particles]] {}: fill = {:.3g} is less than one particle",
                                 species.name, species.fill));
  }
  if (!dense) {
    return dem::place_loose(space, radius);
  }
  dem::Packing packing = dem::pack_dense(space, radius);
  require_near_size(species, packing, space);
  return packing;
}

std::vector<dem::Body> bodies_of(const config::Particles& species, std::size_t index,
                                 const config::Case& the_case, const dem::Settings& settings,
                                 Bed& bed) {
  if (!species.source.empty()) {
    return read_spheres(species.source, species.diameter.mean);
  }
  const bool placed =
      species.count > 0 || species.fill > 0 || species.filling == config::Filling::dense;
  if (!placed) {
    return {};
  }
  const dem::Packing packing = place_species(species, index, the_case, settings);
  if (packing.scale != 1) {
    bed.remarks.push_back(
        fmt::format("{}: {} packed densely, diameters x {:.4f}, mean overlap {:.2g} d",
                    species.name, packing.radius.size(), packing.scale, packing.mean_overlap));
  }
  std::vector<dem::Body> bodies;
  for (std::size_t k = 0; k < packing.position.size(); ++k) {
    dem::Body body;
    body.position = settings.box.wrapped(packing.position[k]);
    body.velocity = {species.velocity[0], species.velocity[1], species.velocity[2]};
    body.radius = packing.radius[k];
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace

Bed make_bed(const config::Case& the_case, const dem::Settings& settings) {
  Bed bed;
  for (std::size_t s = 0; s < the_case.particles.size(); ++s) {
    const config::Particles& species = the_case.particles[s];
    for (dem::Body body : bodies_of(species, s, the_case, settings, bed)) {
      body.id = bed.bodies.size();
      body.density = species.density;
      body.species = static_cast<std::uint16_t>(s);
      body.flags = species.fixed ? dem::flag::fixed : 0;
      for (int axis = 0; axis < 3; ++axis) {
        const Real x = body.position[axis];
        if (!settings.box.periodic[axis] &&
            (x < settings.box.low[axis] || x > settings.box.high[axis])) {
          throw InputError(
              fmt::format("[[particles]] {}: particle {} at {} is outside the box, {:.6g} m to "
                          "{:.6g} m along {}",
                          species.name, body.id, place(body.position), settings.box.low[axis],
                          settings.box.high[axis], "xyz"[axis]));
        }
      }
      bed.bodies.push_back(body);
      bed.force.push_back({species.force[0], species.force[1], species.force[2]});
    }
  }
  return bed;
}

void find_contacts(dem::System& system) {
  system.advance(0, 1);
}

void require_apart(dem::System& system, Real most, const par::Communicator& comm) {
  find_contacts(system);
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
