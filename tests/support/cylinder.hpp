// SPDX-License-Identifier: MPL-2.0
// The thesis's cylinder (references.md A4): 31.5 D x 25 D, its centre 11.5 D from the inlet, slip sides.
#pragma once

#include <optional>

#include "flow/body_forces.hpp"
#include "support/solve.hpp"

namespace porefines::test {

/// Diameter, inlet velocity and density are 1.
class Cylinder {
 public:
  Cylinder(const par::Communicator& comm, int cells, Real reynolds, flow::Scheme scheme,
           flow::TimeScheme time)
      : cells_(cells),
        solver_(comm, even_cut(size(cells), comm.size()), {1.0 / cells, 1.0 / cells, 1.0 / cells},
                boundaries(), 1 / reynolds) {
    solver_.set_surface([](const Vec3& x) { return std::hypot(x.x - 11.5, x.y - 12.5) - 0.5; });
    flow_.emplace(solver_, 1.0, scheme, time, 1.0);
    flow_->set_velocity([](const Vec3&) { return Vec3{1, 0, 0}; });
    drive_.face_value[0] = 1;
    forces_.emplace(
        *flow_, solver_, [](const Vec3&) { return 0; }, 1);
  }
  [[nodiscard]] static Boundaries boundaries() {
    Boundaries b;
    b.kind = {FaceKind::velocity, FaceKind::outflow, FaceKind::slip,
              FaceKind::slip,     FaceKind::slip,    FaceKind::slip};
    return b;
  }
  [[nodiscard]] static Int3 size(int cells) { return {63 * cells / 2, 25 * cells, 1}; }

  /// C_d and C_l = 2 F/(rho D u^2), per unit depth.
  [[nodiscard]] Vec3 coefficients() { return forces_->sum(drive_)[0] * (2.0 * cells_); }

  /// From the rear of the cylinder to where the stream on its axis turns, in diameters.
  [[nodiscard]] Real wake() const {
    const int row = 25 * cells_ / 2;
    Real before = 0;
    for (int plane = 12 * cells_; plane < size(cells_)[0]; ++plane) {
      const auto u = solver_.plane_velocities(0, plane);
      const Real here = (u[row - 1] + u[row]) / 2;  // on the axis of an even number of cells
      if (here > 0 && before < 0) {
        return (plane - here / (here - before)) / cells_ - 12;
      }
      before = here;
    }
    return 0;
  }
  [[nodiscard]] flow::InertialFlow& flow() { return *flow_; }
  [[nodiscard]] const flow::Drive& drive() const { return drive_; }
  [[nodiscard]] flow::StokesSolver& solver() { return solver_; }

 private:
  int cells_;
  flow::StokesSolver solver_;
  std::optional<flow::InertialFlow> flow_;
  flow::Drive drive_;
  std::optional<flow::BodyForces> forces_;
};

}  // namespace porefines::test
