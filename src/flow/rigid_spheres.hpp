// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <vector>

#include "flow/lubrication.hpp"
#include "flow/operator.hpp"
#include "flow/sphere_cover.hpp"
#include "flow/sphere_set.hpp"

namespace porefines::flow {

/// Rigid spheres inside the Stokes solve (algorithm.md section 4).
///
/// Faces inside a sphere move with it, u = U + omega x arm; faces beside it get links e/theta to its
/// surface. With r.V the motion of a face, k the links' frictions and g.V the flux out of a cell that
/// a sphere's covered faces make:
///
///     momentum:    A u - sum k r.V + W grad p = f
///     continuity:  div W u + sum g.V = 0
///     sphere:      sum k r (r.V - u) - sum g p + 2 mu Vol (0, omega) + lubrication + m V = F
///
/// m, the mass over the time step, is 0 in a creeping flow. The Laplacian of the momentum rows stands for the traction mu du/dn; that of the full stress has
/// mu (grad u)^T n besides, which is -mu omega x n on a rigid surface: no force, but the torque
/// -2 mu Vol omega, a third of 8 pi mu a^3 omega.
/// But for it the third row is the transpose of what the first two hold of V: force and torque come from the
/// same numbers. In memory covered faces hold u = 0, so that the smoother runs over them unchanged;
/// what spheres do to the fluid sits in the right-hand sides f and g.
///
/// In packed vectors each owned sphere has eight numbers (two unused) behind the fluid's: its motion V
/// among the unknowns, its row times 1/L among residuals, where N = sum r r^T = L L^T over its covered
/// faces: a sphere's residual then counts like that of the faces it covers.
/// Tests: verification/sphere_mobility, mpi/flow_spheres, unit/rigid_spheres.
class RigidSpheres {
 public:
  RigidSpheres(const par::Communicator& comm, Operator& op, Friction& friction, const Vec3& spacing,
               const Boundaries& boundaries);

  /// New places: covers faces and cuts links, and gives back the former ones. Collective.
  /// @param walls      gaps near owned balls, in fine cells
  /// @param roughness  smallest gap, in fine cells; 0: a hundredth of the smaller radius
  /// @param inertia    what impact() is a Stokes number by; where it is above 1, a touch is dry
  void place(std::span<const Ball> owned, std::span<const WallGap> walls, Real roughness = 0,
             Real inertia = 0);
  /// The grid without spheres again.
  void lift() { cover_.lift(); }

  [[nodiscard]] const SphereSet& set() const { return set_; }
  [[nodiscard]] const SphereCover& cover() const { return cover_; }
  /// m V.n/(6 pi a_r^2) across a gap, m being the reduced mass over the time step.
  [[nodiscard]] Real impact(const Lubrication& gap) const;
  [[nodiscard]] Real closing_speed(const Lubrication& gap) const;  ///< |V.n|
  /// Narrow gaps that this rank counts.
  [[nodiscard]] const std::vector<Lubrication>& gaps() const { return gaps_; }
  [[nodiscard]] std::size_t tail() const { return 8 * ((set_.owned() + 1) / 2 * 2); }
  [[nodiscard]] static std::size_t tail_of(std::size_t ball) { return 8 * ball; }

  // In packed vectors.
  /// Motion of every held ball from its owner's tail; collective, as all that follow.
  template <typename T>
  void load_motion(const T* tail);
  template <typename T>
  void store_motion(T* tail) const;
  /// Adds what spheres do to the fluid's rows and makes their own.
  template <typename T>
  void apply(T* fluid, T* tail);
  /// F -> F/L of an owned ball's row; zero where it is held.
  void scale_force(std::size_t ball, Six& force) const;
  /// Rows of the owned balls in a right-hand side whose fluid part is there: their force and the drive on
  /// them, see take_drive().
  void put_forces(Packed<float>& b, const std::vector<Six>& drive) const;
  /// Takes out what a right-hand side holds on covered faces and cells.
  /// @return sum r b over covered faces: the drive on each held ball
  [[nodiscard]] std::vector<Six> take_drive(Packed<float>& b);

  // In a multigrid cycle.
  template <typename T>
  void load_force(const T* tail, Real scale);
  void rest();         ///< V = 0
  void show_motion();  ///< adds what the present V does to f and g
  /// Solves the spheres' rows with the fluid as it is, and pushes the pressure of their cells. Spheres
  /// that lubrication binds together are solved together: one by one they would follow each other
  /// in hundreds of cycles (a chain of eight touching ones stalled the solve).
  void update();
  /// Residuals of the spheres' rows spread over the faces they cover, for the coarse level.
  void spread_residual();
  /// V += the rigid motion nearest to what the coarse level put on covered faces.
  void take_correction();

  /// Calls visit(face, velocity) for the covered faces that this rank owns.
  template <typename Visit>
  void for_covered(const Visit& visit) const {
    for (std::size_t b = 0; b < set_.size(); ++b) {
      for (const RigidFace& q : cuts()[b].faces) {
        if (q.face.owned) {
          visit(q, q.face.of(motion_[b]));
        }
      }
    }
  }
  /// The same for all that this rank knows: visit(component, place in a field, velocity).
  template <typename Visit>
  void for_all_covered(const Visit& visit) const {
    for (std::size_t b = 0; b < set_.size(); ++b) {
      for (const RigidFace& q : cuts()[b].faces) {
        visit(q.face.component, q.face.at, q.face.of(motion_[b]));
      }
    }
  }
  /// u on covered faces: their motion, or zero.
  void write_faces(bool moving);

  [[nodiscard]] const std::vector<Six>& motion() const { return motion_; }
  /// Force of the fluid on each held ball after apply(), per volume of a cell; without the drive.
  [[nodiscard]] const std::vector<Six>& rows() const { return row_; }
  /// Of touching neighbours on each held ball, by add_contact(), per volume of a cell.
  [[nodiscard]] std::vector<Six> contact_forces();

 private:
  [[nodiscard]] const std::vector<SphereCut>& cuts() const { return cover_.cuts(); }
  void find_blocks();
  void find_rows();
  [[nodiscard]] Six pull(std::size_t ball) const;
  [[nodiscard]] std::vector<Six> solve_together(std::vector<Six> rest);
  [[nodiscard]] std::vector<Six> times_matrix(const std::vector<Six>& v);
  [[nodiscard]] Real dot_owned(const std::vector<Six>& a, const std::vector<Six>& b) const;
  void add_motion(std::size_t ball, const Six& change);
  void show_motion(std::size_t ball, const Six& change);
  void push_cell(std::uint32_t at, Real flux);

  par::Communicator comm_;
  Operator& op_;
  Level& level_;
  SphereCover cover_;
  SphereSet set_;
  std::vector<Lubrication> gaps_;  ///< that this rank counts
  std::vector<SixBySix> lower_;    ///< L
  std::vector<SixBySix> spread_;   ///< N^-1; zero for held balls, as the next
  std::vector<SixBySix> inverse_;  ///< of the diagonal block
  std::vector<SixBySix> alone_;    ///< the diagonal block without lubrication
  bool bound_ = false;             ///< are there gaps between two balls, on any rank?
  std::vector<Six> motion_;
  std::vector<Six> force_;
  std::vector<Six> row_;
};

}  // namespace porefines::flow
