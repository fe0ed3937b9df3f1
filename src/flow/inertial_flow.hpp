// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "flow/advection.hpp"
#include "flow/sphere_carriage.hpp"
#include "flow/stokes.hpp"

namespace porefines::flow {

/// Steps in time.
enum class TimeScheme {
  euler,    ///< backward Euler, first order: the thesis's
  bdf2,     ///< backward differences over three times, second order; its first step is Euler's
  midpoint  ///< implicit midpoint, second order: with linear interpolation it keeps the energy
};

struct StepOptions {
  Real tolerance =
      1e-6;  ///< of the rows' residual as a velocity, relative to the norm of the velocity
  int max_cycles = 100;
  int directions = 3;  ///< search directions kept
  std::function<bool()> interrupted = {};
};

struct StepReport {
  int cycles = 0;
  int evaluations = 0;  ///< of the whole nonlinear residual
  Real residual = 0;
  bool converged = false;
};

/// Unsteady flow with inertia, on the unknowns of a StokesSolver.
///
///     rho W (a0 u + a1 u_old + a2 u_older)/dt + rho A(u, u) - mu lap u + W grad p = W f,   div W u = 0
///
/// with a = (1, -1, 0) for Euler, (3/2, -2, 1/2) for equal steps of BDF2. Midpoint solves for the mean of
/// old and new, a = (2, -2, 0), u_new = 2 u - u_old. All terms stand at the new time (or the middle):
/// no step is too large for stability, the Courant number is a matter of accuracy and of cycles.
///
/// Each step is one nonlinear solve for velocity and pressure together, from the extrapolated last steps
/// (a parabola through three times, a line where spheres uncover cells that have no past):
/// generalised conjugate residuals with the multigrid cycle of the linear rows without A as
/// preconditioner, where the image of a direction holds A(u, z) + A(z, u): Newton's method, its linear
/// systems solved just far enough. Residuals of momentum are divided by the diagonal, so that they
/// count as velocities, as those of continuity do.
///
/// Pressure after a step is that at the time of the rows: of midpoint half a step earlier.
/// Tests: verification/start_up, taylor_green, cavity; mpi/inertial.
class InertialFlow {
 public:
  /// @param solver  with its geometry set; its results are those of the last step from now on
  /// @param speed   [m/s] that is about 1 inside
  /// @param first   from rest, or from what the solver holds: a creeping flow without spheres
  enum class First { rest, solved };
  InertialFlow(StokesSolver& solver, Real density, Scheme scheme, TimeScheme time, Real speed,
               First first = First::rest);

  /// Velocity at t = 0, at face centres [m from the low corner of the grid].
  void set_velocity(const std::function<Vec3(const Vec3&)>& velocity);

  /// Spheres of the next step, at their places of its end, each with the rank whose block holds its
  /// centre; as StokesSolver::set_spheres. Free ones obey m dV/dt = fluid + force, I dw/dt = fluid + torque in
  /// the same solve, with m and I by their density and their motions at the last two times: weight less
  /// buoyancy belongs to the force. Not with midpoint.
  void set_spheres(std::span<const Sphere> owned, std::span<const WallGap> walls = {});
  /// Of the last step, in the order given.
  [[nodiscard]] const std::vector<SphereMotion>& sphere_motions() const { return found_; }

  /// One step [s]. Steps may differ; a changed one costs a set-up of the coarse levels when it moves by
  /// more than a third. Collective.
  StepReport advance(Real step, const Drive& drive, const StepOptions& options);

  /// The steady flow, without regard for how it comes about: Euler steps that grow as they converge.
  /// @return  steps taken; `residual` of the steady rows
  struct SteadyReport {
    int steps = 0;
    int cycles = 0;
    Real residual = 0;
    bool converged = false;
  };
  SteadyReport settle(const Drive& drive, const StepOptions& options, int max_steps);

  /// a0, a1, a2 of a next step [s].
  [[nodiscard]] std::array<Real, 3> time_weights(Real step) const;
  [[nodiscard]] Real time() const { return time_; }
  /// [1/s] largest sum over axes of mean |u|/h in a cell: times a step, its Courant number. Collective.
  [[nodiscard]] Real crossing_rate();
  /// [1/s] fastest |V.n|/gap across narrow gaps whose impact has a Stokes number above 1, by the motions and
  /// places of the last step; gaps and overlaps count with the height of roughness at least.
  [[nodiscard]] Real closing_rate() const { return closing_rate_; }
  /// [J] rho/2 sum W u^2 over all faces, times the volume of a cell. Collective.
  [[nodiscard]] Real kinetic_energy() const;

  /// What a run goes on from, bit for bit on as many ranks: of this rank's cells, x fastest, the velocity
  /// on their low faces, that on their high ones where they end the box, and the pressure.
  static constexpr int columns = 7;
  struct Memory {
    std::vector<Real> now, old, older;  ///< older: empty where no guess needs it
    Real time = 0;
    Real step = 0;     ///< of the last step
    Real before = 0;   ///< of the one before
    Real built = 0;    ///< weight that the coarse levels stand for
    Real closing = 0;  ///< closing_rate()
    int states = 0;    ///< known
  };
  [[nodiscard]] Memory remember() const;
  /// @param spheres  of the last step, where they were. Collective.
  void recall(const Memory& memory, std::span<const Sphere> spheres = {});

  [[nodiscard]] const FaceVelocity& velocity() const { return u_; }
  [[nodiscard]] const Advection& advection() const { return advection_; }
  /// rho V h / mu of the velocity unit: what A is multiplied by in the rows.
  [[nodiscard]] Real inertia() const { return inertia_; }
  /// Wall friction without the weight of time, as the grains' links make it.
  [[nodiscard]] const Floats3& friction() const { return base_; }
  /// Loads the present velocity for velocity(). Collective.
  void show_velocity(const Drive& drive);

 private:
  struct Direction {
    Packed<float> z, q;
    Real square = 0;
  };
  [[nodiscard]] std::vector<Ball> heavy_balls(const std::array<Real, 3>& a, Real ratio) const;
  void lift_spheres();
  void put_back_spheres();
  void place_spheres(const std::array<Real, 3>& a, Real ratio);
  void find_motions();
  void find_closing_rate();
  void show_covered(FaceVelocity& u) const;
  void extend_history();
  [[nodiscard]] RigidSpheres* spheres() const { return parts_.equations.spheres(); }
  void weigh_inlets();
  void set_weight(Real weight);
  void find_guess(Real step);
  [[nodiscard]] bool bends_guess() const { return states_ > 2 && !solver_.spheres_; }
  void level_pressure();
  void show_drive(const Drive& drive);
  void drop_directions(std::size_t most);
  void find_residual(const Packed<float>& b, bool exactly);
  void add_past();
  [[nodiscard]] bool floats_do(Real tolerance) const;
  void search(bool stalled, Real size);
  void add_carriage(Direction& direction);
  Real descend(std::size_t most);
  StepReport solve(const Packed<float>& b, const StepOptions& options);
  /// Of a packed vector as a velocity: momentum counted by its diagonal.
  template <typename T>
  [[nodiscard]] Real row_norm(const Packed<T>& rows) const;
  [[nodiscard]] Real row_factor() const;
  [[nodiscard]] std::array<Real, 6> inlet_values(const Drive& drive) const;
  [[nodiscard]] Real velocity_unit() const;
  [[nodiscard]] Real velocity_norm() const;
  [[nodiscard]] Real change() const;
  [[nodiscard]] std::vector<Real> of_cells(const Packed<double>& x) const;
  void from_cells(const std::vector<Real>& cells, Packed<double>& x) const;
  template <typename Visit>
  void for_columns(const Visit& visit) const;

  StokesSolver& solver_;
  StokesSolver::Parts parts_;
  Real density_;
  TimeScheme scheme_in_time_;
  Real inertia_ = 0;
  Floats3 base_;          ///< friction without the time term
  Floats3 base_inverse_;  ///< 1/d without it
  Real weight_ = -1;      ///< of u in the rows: a0 rho h^2/(mu dt)
  Real built_ = 0;        ///< the same, for which the coarse levels were made
  Advection advection_;
  SphereCarriage beside_;
  FaceVelocity u_;
  FaceVelocity z_;
  std::array<Real, 6> inlet_{};
  Packed<double> old_, older_;    ///< one and two steps ago
  std::array<double, 2> past_{};  ///< -a1/a0, -a2/a0: what the rows draw u to by the time term
  Packed<double> r_;
  Packed<double>
      time_weight_;  ///< of u in each row: what friction holds above its base without spheres
  std::vector<SphereMotion> found_;
  std::vector<std::uint32_t> vacated_;
  Packed<double> image_;
  Packed<float> part_;
  Packed<float> carried_;
  std::deque<Direction> kept_;
  std::vector<Direction> spare_;  ///< memory of former directions
  Packed<float> drive_rows_;      ///< right-hand side of the last drive
  std::optional<Drive> drive_;
  Packed<float> rows_;  ///< right-hand side of the step
  Real time_ = 0;
  Real last_step_ = 0;
  Real step_before_ = 0;
  Real closing_rate_ = 0;
  int states_ = 1;  ///< known times, the present one included
};

}  // namespace porefines::flow
