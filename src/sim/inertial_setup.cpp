// SPDX-License-Identifier: MPL-2.0
#include "sim/inertial_setup.hpp"

#include <algorithm>
#include <cmath>

#include "sim/steady_flow.hpp"

namespace porefines::sim {
namespace {

flow::Scheme scheme_of(const config::Case& the_case, const Domain& domain, Real speed) {
  constexpr Real waves =
      10;  // Reynolds number of a cell above which linear interpolation shows them
  const config::Fluid& fluid = the_case.fluid;
  const Vec3& h = domain.spacing;
  const Real cell = fluid.density * speed * std::max({h.x, h.y, h.z}) / fluid.viscosity;
  switch (the_case.inertia.scheme) {
    case config::AdvectionScheme::linear:
      return flow::Scheme::linear;
    case config::AdvectionScheme::lust:
      return flow::Scheme::lust;
    case config::AdvectionScheme::automatic:
      break;
  }
  return cell > waves ? flow::Scheme::lust : flow::Scheme::linear;
}

}  // namespace

InertialDrive inertial_drive(const config::Case& the_case) {
  const config::Flow& flow = the_case.flow;
  InertialDrive out;
  out.drive.force = {flow.pressure_gradient[0], flow.pressure_gradient[1],
                     flow.pressure_gradient[2]};
  if (flow.inlet) {
    const OpeningDrive opening = opening_drive(flow);
    out.drive.face_value = opening.drive.face_value;
    out.offset = opening.base;
  }
  if (const auto& lid = the_case.inertia.lid) {
    out.drive.lid[static_cast<std::size_t>(lid->face)] = {lid->velocity[0], lid->velocity[1],
                                                          lid->velocity[2]};
  }
  return out;
}

config::Case with_velocities(config::Case the_case, const Domain& domain) {
  for (auto* opening : {&the_case.flow.inlet, &the_case.flow.outlet}) {
    if (*opening && (*opening)->kind == config::DriveKind::flow_rate) {
      (*opening)->kind = config::DriveKind::velocity;
      (*opening)->value /= domain.area();
    }
  }
  return the_case;
}

Push push_of(const Domain& domain, const flow::Drive& drive) {
  Push push;
  push.force = norm(drive.force);
  for (std::size_t face = 0; face < 6; ++face) {
    const flow::FaceKind kind = domain.boundaries.kind[face];
    const Real value = std::abs(drive.face_value[face]);
    if (kind == flow::FaceKind::velocity) {
      push.speed = std::max(push.speed, value);
    } else if (kind == flow::FaceKind::lid) {
      push.speed = std::max(push.speed, norm(drive.lid[face]));
    } else if (flow::gives_pressure(kind)) {
      push.force = std::max(push.force, value / domain.length());
    }
  }
  return push;
}

Real expected_speed(const config::Case& the_case, const Domain& domain, const Push& push) {
  if (push.speed > 0) {
    return push.speed;
  }
  const config::Fluid& fluid = the_case.fluid;
  const Vec3 size = domain.size();
  const Real width = std::min({size.x, size.y, size.z});
  const Real viscous = push.force * width * width / (12 * fluid.viscosity);
  const Real inertial = std::sqrt(push.force * width / fluid.density);
  return std::min(viscous, inertial);
}

std::unique_ptr<flow::InertialFlow> make_inertial_flow(const config::Case& the_case,
                                                       const Domain& domain,
                                                       flow::StokesSolver& solver, Real speed,
                                                       flow::InertialFlow::First first) {
  return std::make_unique<flow::InertialFlow>(
      solver, the_case.fluid.density, scheme_of(the_case, domain, speed),
      static_cast<flow::TimeScheme>(the_case.inertia.time_scheme), speed, first);
}

}  // namespace porefines::sim
