// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <vector>

#include "flow/face_velocity.hpp"
#include "flow/rigid_spheres.hpp"

namespace porefines::flow {

/// Carriage of momentum beside moving spheres: what Advection makes of a covered face, mended.
///
/// A fluid face P at theta cells from a surface has a covered neighbour N beyond it. Advection takes
/// the sphere's velocity for that of N, so that the slope along the axis comes out as (1 + theta)/2 of the
/// true one, while the face feels all of it in time as the sphere comes nearer: a force
/// rho V.n du/dn (1 - theta)/2 in the first layer of cells around whatever moves over the grid. Here N
/// gets the velocity of the line through the surface S and the fluid face Q behind P instead,
///
///     u_N = u_S - (1 - theta)/(1 + theta) (u_Q - u_S),
///
/// in what is carried, not in the fluxes that carry. Where Q is no fluid face, N keeps its sphere's
/// velocity. The same values are the history of faces that the sphere leaves next.
/// Test: verification/inertial_spheres.
class SphereCarriage {
 public:
  explicit SphereCarriage(const Level& level) : level_(level) {}

  /// The sides between fluid and covered faces, after spheres were placed.
  void place(const RigidSpheres& spheres);

  /// Adds what is missing in A(u, u) to out, and remembers u's part. Local.
  /// @param spheres  their motion is that of u
  void apply(const RigidSpheres& spheres, const FaceVelocity& u, Packed<float>& out);
  /// The same for A(u, z) + A(z, u), the motion of the spheres being that of z.
  void change(const RigidSpheres& spheres, const FaceVelocity& u, const FaceVelocity& z,
              Packed<float>& out) const;
  /// Calls visit(component, place in a field, velocity) for each N, the mean where it has several P.
  void for_extended(const RigidSpheres& spheres, const FaceVelocity& u,
                    const std::function<void(int, std::uint32_t, Real)>& visit) const;

 private:
  struct Side {
    FaceArm face;  ///< of P, its arm to S
    int ball = 0;
    std::int64_t packed = -1;
    std::ptrdiff_t beyond = 0;  ///< from P to N
    std::ptrdiff_t across = 0;  ///< to the face that shares the flux with the first
    std::ptrdiff_t first = 0;   ///< from P to the first face of the flux
    int axis = 0;
    float back = 0;   ///< (1 - theta)/(1 + theta)
    float share = 0;  ///< half of what a flux counts in P's row: +-1/(2 h)
    float miss = 0;   ///< u_N of the line less u_N of the sphere, of the last apply()
  };
  [[nodiscard]] Side side_of(const SphereLink& link, const Int3& index) const;
  [[nodiscard]] float missing(const Side& q, const RigidSpheres& spheres,
                              const FaceVelocity& u) const;
  [[nodiscard]] float flux(const Side& q, const FaceVelocity& u) const;

  const Level& level_;
  std::vector<Side> sides_;
};

}  // namespace porefines::flow
