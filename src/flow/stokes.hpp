// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <vector>

#include "flow/gcr.hpp"

namespace porefines::flow {

/// What makes the fluid move. SI.
struct Drive {
  Vec3 force;  ///< [Pa/m] body force, or minus the mean pressure gradient of a periodic box
  /// [Pa] at pressure faces; [m/s] along +axis at velocity faces; unused elsewhere.
  std::array<Real, 6> face_value{};
};

/// Steady Stokes flow through a fixed geometry.
///
///     -mu lap u + grad p = f,   div u = 0
///
/// Set-up (links, mobility, coarse levels) is done once; every drive is then a solve. The first
/// solve starts from rest, later ones too: results do not depend on history.
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
  /// to flux_tolerance (a tight rock passes so little that its flux weighs nothing in the residual).
  /// options.reference is set here. Collective.
  SolveReport solve(const Drive& drive, SolveOptions options);

  /// [m^3/s] volume flux through every plane normal to an axis: faces 0 .. n. On every rank.
  [[nodiscard]] std::vector<Real> plane_fluxes(int axis) const;
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

 private:
  void finish_setup(Friction friction);
  [[nodiscard]] Real force_scale(const Drive& drive) const;
  [[nodiscard]] Packed<float> right_hand_side(const Drive& drive) const;
  [[nodiscard]] Packed<double> first_guess(const Drive& drive) const;
  [[nodiscard]] Real reference_norm(const Drive& drive, const Packed<float>& b) const;
  [[nodiscard]] Real length(int axis) const { return spacing_[axis] * block().global[axis]; }
  [[nodiscard]] bool pressure_pair(int axis) const;
  [[nodiscard]] Real flux_variation() const;

  par::Communicator comm_;
  Boundaries boundaries_;
  Vec3 spacing_;
  Real viscosity_;
  Hierarchy hierarchy_;
  std::unique_ptr<Friction> friction_;
  std::unique_ptr<Operator> operator_;
  Packed<double> x_;
  Real scale_ = 1;  ///< [Pa/m] force that is 1 inside
};

}  // namespace porefines::flow
