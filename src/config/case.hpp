// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "config/case_particles.hpp"
#include "core/types.hpp"

namespace porefines::config {

/// [run]: what belongs to the run as a whole.
struct Run {
  std::string title;
  std::string reference;
  std::string output_dir = "out";  ///< relative to the working directory
  unsigned long long random_seed = 1;
  Real end_time = 0;                ///< [s] simulated
  Real max_wall = 0;                ///< [s] of wall time; 0: no limit
  Real max_pore_volumes = 0;        ///< injected, after which the run ends; 0: no limit
  int max_clogged_throats = 0;      ///< at which the run ends; 0: no limit
  Real min_permeability_ratio = 0;  ///< k/k0 below which the run ends; 0: no limit
  friend bool operator==(const Run&, const Run&) = default;
};

/// [checkpoint]: from which a run can go on.
struct Checkpoint {
  Real every = 900;  ///< [s] of wall time
  int keep = 2;      ///< how many, the newest included
  friend bool operator==(const Checkpoint&, const Checkpoint&) = default;
};

enum class GeometryKind { image, spheres, cylinders, empty };
enum class Keep { all, percolating };  ///< which pores stay open
enum class Surface { smooth, voxel };  ///< sub-pixel surface, or the pixel staircase itself

/// [geometry]: where the grains are. Lengths in m.
struct Geometry {
  GeometryKind kind = GeometryKind::image;
  std::string source;            ///< absolute path; the file gives it relative to its own folder
  Real pixel_size = 0;           ///< [m] image
  int pore_value = 255;          ///< binary image: which value is pore
  std::optional<int> threshold;  ///< grey image: grey level, pore is >= threshold
  bool otsu = false;             ///< threshold = "otsu"
  bool pore_is_bright = true;    ///< with a threshold: bright = pore
  Int3 raw_size{0, 0, 0};        ///< raw volumes: voxels along x, y, z
  Real depth = 0;                ///< [m] extrusion of a 2D image along z
  std::array<Real, 3> size{};    ///< [m] spheres, cylinders, empty: the box
  Real list_unit = 1;            ///< [m] unit of the numbers in a list
  bool periodic_images = true;   ///< grains reaching over a periodic face continue there
  Surface surface = Surface::smooth;
  Real smooth = -1;               ///< [m] radius of the smoothing; negative: one pixel
  Keep keep = Keep::percolating;  ///< drop pores that do not connect inlet and outlet
  int remove_grains_below = 0;    ///< [pixels] noise and islands: grains smaller than this vanish
  int fill_pores_below = 0;       ///< [pixels] pores smaller than this are filled
  Real simplify = 0.5;            ///< [pixels] tolerance of the simplified outlines
  Real erode_grains = 0;          ///< [m] grains recede by this much
  std::string edit_mask;          ///< absolute path; opens white pixels, closes black ones
  int reconnect_gap = 0;          ///< [pixels] thinner walls between separate pores open
  Real minimum_throat = 0;        ///< [m] narrower throats are reopened to this width
  /// Image: {first, past-last} voxel, y upwards; z is 0, 0 for a 2D image; all zero: everything.
  std::array<Int3, 2> crop{};
  friend bool operator==(const Geometry&, const Geometry&) = default;
};

/// [grid]
struct Grid {
  Real cell_size = 0;                 ///< [m]; 0 when `cells` is given
  Int3 cells{0, 0, 0};                ///< 0 when `cell_size` is given
  std::optional<Int3> decomposition;  ///< ranks along x, y, z; absent: chosen
  friend bool operator==(const Grid&, const Grid&) = default;
};

/// [fluid]
struct Fluid {
  Real density = 998.2;       ///< [kg/m^3]
  Real viscosity = 1.002e-3;  ///< [Pa s]
  friend bool operator==(const Fluid&, const Fluid&) = default;
};

enum class DriveKind { pressure, flow_rate, velocity };

/// An inlet or outlet: one box face with a pressure, a flow rate or a uniform velocity.
struct Opening {
  BoxFace face = BoxFace::x_low;
  DriveKind kind = DriveKind::pressure;
  Real value = 0;  ///< [Pa], [m^3/s] or [m/s]
  friend bool operator==(const Opening&, const Opening&) = default;
};

enum class Regime { stokes, none, navier_stokes };

/// [flow]
struct Flow {
  Regime regime = Regime::stokes;
  std::array<bool, 3> periodic{};
  std::array<Real, 3> pressure_gradient{};  ///< [Pa/m] periodic drive: the force is along +gradient
  std::optional<Opening> inlet;
  std::optional<Opening> outlet;
  std::array<bool, 6> slip{};   ///< indexed by BoxFace
  std::array<bool, 6> walls{};  ///< no-slip; the reader adds every face that is nothing else
  Real reservoir = -1;          ///< [m] open fluid before and after the sample; negative: automatic
  bool tensor = false;          ///< full permeability tensor (periodic only)
  Real tolerance = 1e-6;        ///< relative residual of the solve
  int max_cycles = 200;
  Real max_pressure = 0;  ///< [Pa] drop at which a pump with a given rate gives up; 0: no limit
  friend bool operator==(const Flow&, const Flow&) = default;
};

/// [[drive]]: what drives the flow is multiplied by a factor from some time on.
struct DriveChange {
  Real from = -1;   ///< [s]
  Real factor = 1;  ///< on the drive of the case, not on the one before; below 0: backwards
  friend bool operator==(const DriveChange&, const DriveChange&) = default;
};

enum class AdvectionScheme { automatic, linear, lust };
enum class TimeScheme { euler, bdf2, midpoint };

/// A no-slip face of the box that moves in its own plane.
struct Lid {
  BoxFace face = BoxFace::y_high;
  Triple velocity{};  ///< [m/s]
  friend bool operator==(const Lid&, const Lid&) = default;
};

/// What [flow] says with regime = "navier-stokes".
struct Inertia {
  bool steady = false;
  AdvectionScheme scheme = AdvectionScheme::automatic;
  TimeScheme time_scheme = TimeScheme::bdf2;
  Real courant = 0.9;
  Real time_step = 0;    ///< [s] largest; 0: the Courant number decides
  Real disturbance = 0;  ///< of the expected speed, sideways at the start
  std::optional<Lid> lid;
  friend bool operator==(const Inertia&, const Inertia&) = default;
};

/// [[probe]]: a place whose velocity and pressure go into series.csv.
struct ProbePoint {
  std::string name;
  Triple position{};  ///< [m]
  friend bool operator==(const ProbePoint&, const ProbePoint&) = default;
};

enum class CouplingMethod {
  one_solve,  ///< "implicit"
  projected   ///< "explicit", the thesis's
};

/// [coupling]: particles in a flow.
struct Coupling {
  CouplingMethod method = CouplingMethod::one_solve;
  Real tolerance = 1e-4;  ///< relative residual of the solves after the first
  Real travel = 0.5;      ///< [cells] that the fastest particle may move in a step
  Real roughness = 0;     ///< [m] smallest gap that lubrication knows; 0: a hundredth of the radius
  friend bool operator==(const Coupling&, const Coupling&) = default;
};

/// [clogging]: when fines count as retained and throats as clogged; see theory-clogging.md.
struct Clogging {
  Real stop_share = 0.01;     ///< of the mean speed in the pores, below which a fine rests
  Real hold_time = 0;         ///< [s] of rest until it is retained; 0: from its diameter
  Real release_travel = 0.5;  ///< diameters
  Real contact_gap = 0.05;    ///< diameters
  Real reach = 2;             ///< diameters around a throat
  Real sieve_share = 0.9;     ///< of a throat's width
  int profile_bins = 50;      ///< of retention.csv along the flow
  friend bool operator==(const Clogging&, const Clogging&) = default;
};

/// [analysis]: derived geometry numbers.
struct Analysis {
  Real fine_diameter = 0;  ///< [m] for o/d and D/d; 0: not asked
  friend bool operator==(const Analysis&, const Analysis&) = default;
};

/// A whole case in SI, defaults filled.
struct Case {
  std::string path;  ///< the case file as the user named it
  Run run;
  Geometry geometry;
  Grid grid;
  Fluid fluid;
  Flow flow;
  Inertia inertia;
  std::vector<DriveChange> drive;
  std::vector<ProbePoint> probe;
  Coupling coupling;
  Clogging clogging;
  Analysis analysis;
  Triple gravity{};  ///< [m/s^2]
  Box box;
  Contact contact;
  std::vector<Particles> particles;
  std::vector<Injection> injection;
  std::vector<Shape> surface;
  Checkpoint checkpoint;
  std::vector<Output> output{{OutputKind::fields}, {OutputKind::pictures}};
  friend bool operator==(const Case&, const Case&) = default;
};

/// Particles in a flow.
[[nodiscard]] inline bool is_coupled(const Case& subject) {
  return subject.flow.regime != Regime::none && !subject.particles.empty();
}

/// A fluid with inertia.
[[nodiscard]] inline bool is_inertial(const Case& subject) {
  return subject.flow.regime == Regime::navier_stokes;
}

/// Creeping fines in one solve with their fluid: a velocity at an opening is kept as a rate, by its pressure. Given as it is, it would
/// leave a plug no way out, and the solver neither.
[[nodiscard]] inline bool pumps_velocities(const Case& subject) {
  return is_coupled(subject) && !is_inertial(subject) &&
         subject.coupling.method == CouplingMethod::one_solve;
}

/// Particles without a fluid.
[[nodiscard]] inline bool is_dry(const Case& subject) {
  return subject.flow.regime == Regime::none;
}

/// The first [[output]] of this kind, or null.
[[nodiscard]] inline const Output* find_output(const Case& subject, OutputKind kind) {
  for (const Output& output : subject.output) {
    if (output.kind == kind) {
      return &output;
    }
  }
  return nullptr;
}

}  // namespace porefines::config
