// SPDX-License-Identifier: MPL-2.0
// What a case says about particles; part of case.hpp.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/types.hpp"

namespace porefines::config {

using Triple = std::array<Real, 3>;

enum class SizeLaw { mono, normal, lognormal, table };

/// Diameters of a species [m].
struct Sizes {
  SizeLaw law = SizeLaw::mono;
  Real mean = 0;
  Real deviation = 0;  ///< normal, lognormal: standard deviation
  Real smallest = 0;   ///< normal, lognormal: cut there
  Real largest = 0;
  std::vector<Real> diameters;  ///< table
  std::vector<Real> shares;     ///< table: one per diameter, their sum is 1
  bool by_volume = false;       ///< the law holds for the volume of particles, not their number
  friend bool operator==(const Sizes&, const Sizes&) = default;
};

/// A box with faces along the axes [m]; coordinates as everywhere: 0 is the corner of the sample.
struct Region {
  Triple low{};
  Triple high{};
  friend bool operator==(const Region&, const Region&) = default;
};

enum class Filling { loose, dense };

/// [[particles]]: a species, and where its particles are at the start.
struct Particles {
  std::string name = "particles";
  Sizes diameter;
  Real density = 1050;  ///< [kg/m^3] polystyrene
  Real young = 30e6;    ///< [Pa] softened
  Real poisson = 0.33;
  std::string source;   ///< absolute path of a list; empty: none
  bool fixed = false;   ///< held where they are
  Triple force{};       ///< [N] on each, besides gravity
  Triple velocity{};    ///< [m/s] at the start
  long long count = 0;  ///< placed at the start; 0: see fill
  Real fill = 0;        ///< share of the region's volume; 0: none
  Filling filling = Filling::loose;
  std::optional<Region> region;  ///< absent: the whole box
  friend bool operator==(const Particles&, const Particles&) = default;
};

enum class ContactModel { hertz, linear };
enum class RollingModel { none, constant_torque, spring_dashpot };

/// What moves particles; automatic: by the Stokes number.
enum class Integrator { automatic, newton_euler, overdamped };

/// [contact]
struct Contact {
  ContactModel model = ContactModel::hertz;
  Real restitution = 0.5;
  Real friction_particle = 0.3;  ///< particle on particle
  Real friction_wall = 0.3;      ///< particle on wall or grain
  RollingModel rolling = RollingModel::none;
  Real rolling_friction = 0;
  Real wall_young = 0;    ///< [Pa] of walls and grains; 0: that of the particle
  Real wall_poisson = 0;  ///< read with wall_young
  Real stiffness = 0;     ///< [N/m] linear: of the normal spring; 0: from young and speed
  Integrator integrator = Integrator::automatic;
  int steps_per_contact = 30;
  Real max_overlap = 0.01;  ///< of a radius
  Real top_speed = 0;       ///< [m/s] expected, for the step; 0: found from the case
  friend bool operator==(const Contact&, const Contact&) = default;
};

enum class Concentration { volume_fraction, mass_fraction, rate };

/// [injection]: particles that enter through a face of the box.
struct Injection {
  std::string species;  ///< name of a [[particles]]
  BoxFace face = BoxFace::x_low;
  Concentration kind = Concentration::volume_fraction;
  Real value = 0;                ///< of 1, or [1/s]
  Real start = 0;                ///< [s]
  Real stop = 0;                 ///< [s]; 0: the end of the run
  Real pulse_period = 0;         ///< [s]; 0: continuous
  Real pulse_duration = 0;       ///< [s] of each period, from its beginning
  Real velocity = 0;             ///< [m/s] inwards, without a flow
  Real flow_rate = 0;            ///< [m^3/s] of suspension, without a flow; 0: velocity x area
  std::optional<Region> region;  ///< part of the face; absent: all of it
  friend bool operator==(const Injection&, const Injection&) = default;
};

/// [box]: the faces, where no flow defines them.
struct Box {
  std::array<bool, 3> periodic{};
  std::array<bool, 6> open{};    ///< particles that cross leave
  std::array<bool, 6> smooth{};  ///< walls without friction
  friend bool operator==(const Box&, const Box&) = default;
};

enum class ShapeKind { plane, cylinder, sphere, mesh };

/// [[surface]]: a wall inside the box.
struct Shape {
  std::string name;
  ShapeKind kind = ShapeKind::plane;
  Triple point{};          ///< [m] on the plane, on the axis, the centre; where a mesh is put
  Triple normal{0, 0, 1};  ///< plane: into the side of the particles
  Triple axis{0, 0, 1};    ///< cylinder
  Real radius = 0;         ///< [m] cylinder, sphere
  bool inside = false;     ///< cylinder, sphere: particles are inside
  std::string source;      ///< mesh: absolute path of an STL file
  Real unit = 1;           ///< [m] mesh: of the numbers in the file
  Triple velocity{};       ///< [m/s] of the surface
  friend bool operator==(const Shape&, const Shape&) = default;
};

enum class OutputKind { fields, pictures, tracks, summary, movie };
inline constexpr std::size_t output_kinds = 5;

/// [[output]]
struct Output {
  OutputKind kind = OutputKind::fields;
  Real every = 0;       ///< [s]; 0: a hundredth of the run
  bool forces = false;  ///< tracks: forces and torques too
  int frame_rate = 15;  ///< movie: frames a second
  friend bool operator==(const Output&, const Output&) = default;
};

}  // namespace porefines::config
