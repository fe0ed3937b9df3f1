// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "flow/gcr.hpp"
#include "flow/rigid_spheres.hpp"

namespace porefines::flow {

/// What makes the fluid move. SI.
struct Drive {
  Vec3 force;  ///< [Pa/m] body force, or minus the mean pressure gradient of a periodic box
  /// [Pa] at pressure faces; [m/s] along +axis at velocity faces; unused elsewhere.
  std::array<Real, 6> face_value{};
  std::array<Vec3, 6> lid{};  ///< [m/s] of moving walls, along them
  friend bool operator==(const Drive&, const Drive&) = default;
};

/// A rigid sphere in the flow. SI.
struct Sphere {
  std::uint64_t id = 0;  ///< unique over all ranks
  Vec3 position;         ///< [m] from the low corner of the grid, in this rank's block
  Real radius = 0;       ///< [m]
  bool held = false;     ///< moves as told; else free, and the solve finds its motion
  Vec3 velocity;         ///< [m/s] of a held one; a guess for a free one
  Vec3 spin;             ///< [rad/s]
  Vec3 force;            ///< [N] on it, from outside the fluid
  Vec3 torque;           ///< [N m]
  // Where there is inertia:
  Real density = 0;  ///< [kg/m^3]
  Vec3 velocity_before =
      {};  ///< [m/s] a step before `velocity`, which is a free one's after its last step
  Vec3 spin_before = {};  ///< [rad/s]
};

/// What the solve found of a sphere.
struct SphereMotion {
  Vec3 velocity;  ///< [m/s]
  Vec3 spin;      ///< [rad/s]
  Vec3 force;     ///< [N] by the fluid
  Vec3 torque;    ///< [N m]
  Vec3 contact;   ///< [N] part of `force`: squeeze of touching neighbours that come nearer
};

/// Steady Stokes flow through a fixed geometry, with rigid spheres in it.
///
///     -mu lap u + grad p = f,   div u = 0
///
/// Set-up (links, mobility, coarse levels) is done once; every drive is then a solve. Without spheres
/// each starts from rest: results do not depend on history. With spheres it starts from the last
/// solve, as they move little between two.
/// SI outside; inside, length = cell along x, viscosity = 1 and a force scale taken from the drive.
class StokesSolver {
 public:
  /// @param spacing    [m] cell sizes
  /// @param viscosity  [Pa s]
  StokesSolver(const par::Communicator& comm, const par::Decomposition& cut, const Vec3& spacing,
               const Boundaries& boundaries, Real viscosity);

  /// [m] signed distance at points in metres, origin at the low corner of the grid.
  void set_surface(const std::function<Real(const Vec3&)>& distance);
  void set_voxels(const IsPore& is_pore);

  /// Largest relative difference of the flux between planes that a solve leaves.
  static constexpr Real flux_tolerance = 1e-6;

  /// Solves for one drive: to options.tolerance, and on until the flux is the same through all planes
  /// to flux_tolerance, or options.tolerance if that is looser (a tight rock passes so little that its flux weighs nothing in the residual).
  /// options.reference is set here. Collective.
  SolveReport solve(const Drive& drive, SolveOptions options);

  /// Spheres of the next solves, each with the rank whose block holds its centre. The grid sees the
  /// radius r + 0.26 h/D, D being the diameter in cells: drag then is right to 0.5 % from D = 4 on
  /// (algorithm.md section 4). Between two of them, and between one and a wall of the list, gaps
  /// below a cell get the lubrication that the grid misses (lubrication.hpp). Collective.
  /// @param walls  gaps [m] to grains and walls near the spheres
  void set_spheres(std::span<const Sphere> owned, std::span<const WallGap> walls = {});
  /// [m] smallest gap that lubrication knows: the height of roughness. Default: a hundredth of the
  /// smaller radius.
  void set_roughness(Real height) { roughness_ = height; }
  /// What the last solve found, in the order given.
  [[nodiscard]] std::vector<SphereMotion> sphere_motions() const;
  /// Orphan cells and pockets of the last placement, on this rank.
  [[nodiscard]] const CoverCount& cover_count() const { return spheres_->cover().count(); }
  /// The last solve, from which the next one starts: with it a run goes on bit for bit.
  struct Memory {
    std::vector<Real> unknowns;
    Real scale = 1;
    std::vector<Sphere> spheres;
  };
  [[nodiscard]] Memory remember() const;
  /// Of a solver with the same grains on as many ranks. Collective.
  void recall(const Memory& memory);

  /// Starts the next solve from rest.
  void forget() { x_.clear(); }
  /// Fluid at rest, as if solved without a drive.
  void rest() { x_.assign(operator_->size(), 0.0); }

  /// [m^3/s] volume flux through every plane normal to an axis: faces 0 .. n. On every rank.
  [[nodiscard]] std::vector<Real> plane_fluxes(int axis) const;
  /// [m/s] W u over the faces of one plane normal to an axis, x before y before z. On every rank.
  [[nodiscard]] std::vector<Real> plane_velocities(int axis, int plane) const;
  /// [Pa] mean pressure over the fluid of every layer of cells normal to an axis. On every rank.
  [[nodiscard]] std::vector<Real> layer_pressures(int axis) const;
  /// [m/s] mean velocity over the whole box, grains included (superficial).
  [[nodiscard]] Vec3 superficial_velocity() const;

  /// Cell-centred values of this rank's block, x fastest: velocity [m/s] and pressure [Pa].
  struct CellFields {
    std::array<std::vector<float>, 3> velocity;
    std::vector<float> pressure;
    std::vector<float> fluid;  ///< 1 in active cells
  };
  [[nodiscard]] CellFields cell_fields();

  [[nodiscard]] const grid::Block& block() const { return hierarchy_.finest().block; }
  [[nodiscard]] const Hierarchy& hierarchy() const { return hierarchy_; }
  [[nodiscard]] Hierarchy& hierarchy() { return hierarchy_; }
  [[nodiscard]] Index fluid_cells() const;

  /// What InertialFlow builds on: the same unknowns and rows, and the units that they are in.
  struct Parts {
    const par::Communicator& comm;
    const Boundaries& boundaries;
    Vec3 spacing;    ///< [m]
    Real viscosity;  ///< [Pa s]
    Hierarchy& hierarchy;
    Operator& equations;
    Friction& friction;
    Packed<double>& unknowns;
    Real& scale;  ///< [Pa/m] force that is 1 inside

    /// [m] centre of a face of an axis (component 0, 1, 2) or of a cell (3).
    [[nodiscard]] Vec3 place(int component, const Int3& index) const {
      const Vec3 x = hierarchy.finest().block.centre(component, index);
      return {x.x * spacing.x, x.y * spacing.y, x.z * spacing.z};
    }
    /// [m/s] velocity that is 1 inside.
    [[nodiscard]] Real velocity_unit() const { return scale * spacing.x * spacing.x / viscosity; }
  };
  [[nodiscard]] Parts parts() {
    return {comm_,      boundaries_, spacing_, viscosity_, hierarchy_,
            *operator_, *friction_,  x_,       scale_};
  }
  /// Of the rows, in the units that `scale` sets.
  [[nodiscard]] Packed<float> right_hand_side(const Drive& drive) const;

 private:
  friend class InertialFlow;
  void finish_setup(Friction friction);
  [[nodiscard]] Real force_scale(const Drive& drive) const;
  [[nodiscard]] Packed<double> first_guess(const Drive& drive) const;
  [[nodiscard]] Real reference_norm(const Drive& drive, const Packed<float>& b) const;
  [[nodiscard]] Real length(int axis) const { return spacing_[axis] * block().global[axis]; }
  [[nodiscard]] bool pressure_pair(int axis) const;
  [[nodiscard]] Real flux_variation() const;
  [[nodiscard]] Real sphere_scale() const;
  [[nodiscard]] std::vector<Ball> scaled_spheres() const;
  [[nodiscard]] std::vector<WallGap> scaled_walls() const;
  /// A motion and a force of the rows, in SI.
  [[nodiscard]] SphereMotion in_si(const Six& v, const Six& f) const;
  SolveReport solve_suspension(const Drive& drive, SolveOptions options);
  void place_and_guess(const Drive& drive, Packed<float>& b, bool warm);
  void show_held_to_coarse_levels();
  void lift_spheres();
  void place_given();
  template <typename Visit>
  void for_fluxes(int axis, const Visit& visit) const;
  void fill_vacated(const std::vector<std::uint32_t>& vacated);

  par::Communicator comm_;
  Boundaries boundaries_;
  Vec3 spacing_;
  Real viscosity_;
  Hierarchy hierarchy_;
  std::unique_ptr<Friction> friction_;
  std::unique_ptr<Operator> operator_;
  Packed<double> x_;
  Real scale_ = 1;  ///< [Pa/m] force that is 1 inside
  std::unique_ptr<RigidSpheres> spheres_;
  std::vector<Sphere> given_;  ///< of this rank
  std::vector<WallGap> walls_;
  Real roughness_ = 0;
  std::vector<std::pair<std::uint64_t, Vec3>> held_;  ///< that the coarse levels know, of this rank
  std::vector<Six> contact_on_;                       ///< squeeze of touching neighbours, scaled
  std::vector<Six> drive_on_;  ///< this solve's drive on each held ball, scaled
};

}  // namespace porefines::flow
