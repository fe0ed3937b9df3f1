// SPDX-License-Identifier: MPL-2.0
// A case in the words of LIGGGHTS.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "interop/export_case.hpp"
#include "par/communicator.hpp"
#include "sim/beds.hpp"

namespace porefines::interop {
namespace {

/// Share of the time that a Rayleigh wave takes around half a sphere.
constexpr Real step_share = 0.1;

struct DemCase {
  const config::Case& the_case;
  Vec3 size;
  bool grains = false;
  std::vector<std::vector<dem::Body>> lists = {};  ///< of each species; empty: none
};

std::array<bool, 3> periodic_axes(const config::Case& c) {
  return config::is_dry(c) ? c.box.periodic : c.flow.periodic;
}

/// Smallest and largest diameter [m] of a species: of its list, if it has one.
std::array<Real, 2> diameters_of(const DemCase& dem, std::size_t species) {
  const config::Sizes& sizes = dem.the_case.particles[species].diameter;
  if (dem.lists[species].empty()) {
    return {sizes.smallest > 0 ? sizes.smallest : sizes.mean, std::max(sizes.mean, sizes.largest)};
  }
  std::array<Real, 2> range{INFINITY, 0};
  for (const dem::Body& body : dem.lists[species]) {
    range = {std::min(range[0], 2 * body.radius), std::max(range[1], 2 * body.radius)};
  }
  return range;
}

/// Rayleigh's criterion over all species; pi r sqrt(rho/G) / (0.1631 nu + 0.8766).
Real time_step(const DemCase& dem) {
  Real least = INFINITY;
  for (std::size_t k = 0; k < dem.the_case.particles.size(); ++k) {
    const config::Particles& p = dem.the_case.particles[k];
    const Real shear = p.young / (2 * (1 + p.poisson));
    least = std::min(least, std::numbers::pi * diameters_of(dem, k)[0] / 2 *
                                std::sqrt(p.density / shear) / (0.1631 * p.poisson + 0.8766));
  }
  return step_share * least;
}

/// Atom types: one per species, the last one is the walls.
std::string materials(const config::Case& c) {
  const std::size_t types = c.particles.size() + 1;
  std::string young;
  std::string poisson;
  std::string restitution;
  std::string friction;
  for (std::size_t i = 0; i < types; ++i) {
    const bool wall = i + 1 == types;
    const config::Particles& p = c.particles[wall ? 0 : i];
    young +=
        fmt::format(" {:.9g}", wall && c.contact.wall_young > 0 ? c.contact.wall_young : p.young);
    poisson += fmt::format(" {:.9g}",
                           wall && c.contact.wall_young > 0 ? c.contact.wall_poisson : p.poisson);
    for (std::size_t j = 0; j < types; ++j) {
      const bool at_wall = wall || j + 1 == types;
      restitution += fmt::format(" {:.9g}", c.contact.restitution);
      friction +=
          fmt::format(" {:.9g}", at_wall ? c.contact.friction_wall : c.contact.friction_particle);
    }
  }
  return fmt::format(
      "fix m1 all property/global youngsModulus peratomtype{}\n"
      "fix m2 all property/global poissonsRatio peratomtype{}\n"
      "fix m3 all property/global coefficientRestitution peratomtypepair {}{}\n"
      "fix m4 all property/global coefficientFriction peratomtypepair {}{}\n",
      young, poisson, types, restitution, types, friction);
}

std::string walls(const DemCase& dem) {
  const config::Case& c = dem.the_case;
  const std::size_t type = c.particles.size() + 1;
  const auto periodic = periodic_axes(c);
  std::string text;
  for (std::size_t face = 0; face < 6; ++face) {
    const bool open = config::is_dry(c) ? c.box.open[face]
                                        : static_cast<std::size_t>(c.flow.outlet->face) == face;
    if (periodic[face / 2] || open) {
      continue;
    }
    const char axis = "xyz"[face / 2];
    text += fmt::format(
        "fix wall_{} all wall/gran model hertz tangential history "
        "primitive type {} "
        "{}plane {:.9g}\n",
        face, type, axis, face % 2 == 0 ? 0 : dem.size[static_cast<int>(face / 2)]);
  }
  if (dem.grains) {
    text += fmt::format(
        "fix grains all mesh/surface file grains.stl type {0} "
        "precision 1e-12 curvature 1e-5\n"
        "fix wall_grains all wall/gran model hertz tangential "
        "history mesh n_meshes 1 meshes grains\n",
        type);
  }
  return text;
}

/// Spheres of a list as create_atoms and set; the others by insert/pack.
std::string particles(const DemCase& dem) {
  std::string text;
  int atom = 0;
  for (std::size_t k = 0; k < dem.the_case.particles.size(); ++k) {
    const config::Particles& p = dem.the_case.particles[k];
    const std::size_t type = k + 1;
    for (const dem::Body& body : dem.lists[k]) {
      ++atom;
      text += fmt::format(
          "create_atoms {0} single {1:.12g} {2:.12g} {3:.12g} units box\n"
          "set atom {4} diameter {5:.12g} density {6:.9g} vx {7:.9g} vy "
          "{8:.9g} vz {9:.9g}\n",
          type, body.position.x, body.position.y, body.position.z, atom, 2 * body.radius, p.density,
          body.velocity.x + p.velocity[0], body.velocity.y + p.velocity[1],
          body.velocity.z + p.velocity[2]);
    }
    if (p.count > 0 || p.fill > 0) {
      const config::Region all{{0, 0, 0}, {dem.size.x, dem.size.y, dem.size.z}};
      const config::Region& r = p.region ? *p.region : all;
      const std::string radius = p.diameter.law == config::SizeLaw::mono
                                     ? fmt::format("constant {:.9g}", p.diameter.mean / 2)
                                     : fmt::format("gaussian number {:.9g} {:.9g}",
                                                   p.diameter.mean / 2, p.diameter.deviation / 2);
      text += fmt::format(
          "fix shape_{0} all particletemplate/sphere {1} atom_type {0} density "
          "constant {2:.9g} radius {3}\n"
          "fix sizes_{0} all particledistribution/discrete 32452867 1 "
          "shape_{0} 1.0\n"
          "region start_{0} block {4:.9g} {5:.9g} {6:.9g} {7:.9g} {8:.9g} "
          "{9:.9g} units box\n"
          "fix fill_{0} all insert/pack seed 86028121 distributiontemplate "
          "sizes_{0} insert_every once "
          "overlapcheck yes all_in yes {10} region start_{0}\n",
          type, 15485863 + 2 * k, p.density, radius, r.low[0], r.high[0], r.low[1], r.high[1],
          r.low[2], r.high[2],
          p.count > 0 ? fmt::format("particles_in_region {}", p.count)
                      : fmt::format("volumefraction_region {:.9g}", p.fill));
    }
  }
  return text;
}

std::string head(const DemCase& dem) {
  const config::Case& c = dem.the_case;
  const auto periodic = periodic_axes(c);
  Real largest = 0;
  for (std::size_t k = 0; k < c.particles.size(); ++k) {
    largest = std::max(largest, diameters_of(dem, k)[1]);
  }
  std::string text = fmt::format(
      "# {} for LIGGGHTS: liggghts -in in.porefines\n"
      "# The fluid and what is injected with it are not LIGGGHTS's part.\n"
      "atom_style granular\natom_modify map array\nboundary {} {} {}\nnewton "
      "off\n"
      "communicate single vel yes\nunits si\n"
      "region box block 0 {:.9g} 0 {:.9g} 0 {:.9g} units box\ncreate_box {} "
      "box\n"
      "neighbor {:.9g} bin\nneigh_modify delay 0\n",
      c.path, periodic[0] ? "p" : "f", periodic[1] ? "p" : "f", periodic[2] ? "p" : "f", dem.size.x,
      dem.size.y, dem.size.z, c.particles.size() + 1, 0.2 * largest);
  return text;
}

std::string tail(const DemCase& dem) {
  const config::Case& c = dem.the_case;
  const Vec3 g{c.gravity[0], c.gravity[1], c.gravity[2]};
  const Real strength = std::sqrt(dot(g, g));
  const Real step = time_step(dem);
  std::string text;
  if (strength > 0) {
    text += fmt::format("fix g all gravity {:.9g} vector {:.9g} {:.9g} {:.9g}\n", strength,
                        g.x / strength, g.y / strength, g.z / strength);
  }
  const auto steps = static_cast<Index>(std::ceil(c.run.end_time / step));
  return text + fmt::format(
                    "fix move all nve/sphere\ncompute mean_z all reduce ave z\n"
                    "thermo {}\nthermo_style custom step atoms ke c_mean_z\n"
                    "thermo_modify lost ignore norm no\ntimestep {:.9g}\nrun {}\n"
                    "write_restart end.restart\n",
                    std::max<Index>(1, steps / 20), step, steps);
}

void check(const config::Case& c) {
  if (c.particles.empty()) {
    throw InputError(fmt::format("{}: has no [[particles]]: LIGGGHTS has nothing to do", c.path));
  }
  if (!c.surface.empty()) {
    throw InputError(
        fmt::format("{}: [[surface]] cannot be exported to LIGGGHTS\ntake it out, and add "
                    "the wall to in.porefines by hand",
                    c.path));
  }
  if (!(c.run.end_time > 0)) {
    throw InputError(fmt::format("{}: needs run.end_time", c.path));
  }
}

}  // namespace

void export_liggghts(const config::Case& the_case, const std::string& folder) {
  check(the_case);
  const geom::Sample sample =
      geom::build_sample(sim::geometry_spec(the_case), par::Communicator::self().handle());
  const auto triangles = grain_triangles(the_case, sample, 0.1 * sample.box.size.z);
  DemCase dem{the_case, sample.box.size, !triangles.empty()};
  for (const config::Particles& p : the_case.particles) {
    dem.lists.push_back(p.source.empty() ? std::vector<dem::Body>{}
                                         : sim::read_spheres(p.source, p.diameter.mean));
  }
  make_folder(folder);
  if (dem.grains) {
    write_text_stl(folder + "/grains.stl", triangles);
  }
  write_file(folder + "/in.porefines", head(dem) + materials(the_case) +
                                           "pair_style gran model hertz tangential history\n"
                                           "pair_coeff * *\n" +
                                           walls(dem) + particles(dem) + tail(dem));
}

}  // namespace porefines::interop
