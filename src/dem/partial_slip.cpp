// SPDX-License-Identifier: MPL-2.0
#include "dem/partial_slip.hpp"

#include <cmath>

namespace porefines::dem {

namespace {

/// T at the end of a branch that began with stiffness k: 1 - (what is left)^(3/2), from the share
/// x already used up, after a further slide.
Real used_up(Real x, Real slide_by_length) {
  const Real root = std::cbrt(std::clamp(1 - x, 0.0, 1.0));
  const Real left = root * root - 2.0 / 3.0 * slide_by_length;
  return left > 0 ? 1 - left * std::sqrt(left) : 1;
}

void turn_back(ShearBranch& s, Real slide) {
  if (slide < 0 && s.branch != 1) {
    s.branch = 1;
    s.unload = s.shear;
  } else if (slide > 0 && s.branch == 1) {
    s.branch = 2;
    s.reload = s.shear;
  }
}

}  // namespace

bool follow(ShearBranch& s, Real stiffness, Real cap, Real slide, Real change) {
  s.unload += change, s.reload -= change;
  turn_back(s, slide);
  const Real way = s.branch == 1 ? -1 : 1;
  const Real beyond = way * slide - change / stiffness;  // what is left for slip
  if (beyond < 0) {
    s.shear += stiffness * slide;  // the normal force grows faster: nothing slips
  } else if (s.branch == 0) {
    s.shear = cap * used_up((s.shear + change) / cap, stiffness * beyond / cap);
  } else {
    const Real from = s.branch == 1 ? s.unload : s.reload;
    const Real length = 2 * cap;
    const Real x = way * (s.shear + way * change - from) / length;
    s.shear = from + way * length * used_up(x, stiffness * beyond / length);
  }
  s.shear = std::clamp(s.shear, -cap, cap);
  if (s.branch == 2 && s.shear >= s.unload) {
    s.branch = 0;
  }
  if ((s.branch == 1 && s.shear <= -s.unload) || (s.branch == 0 && s.shear < 0)) {
    s = {-s.shear, 0, 0, 0};
    return true;
  }
  return false;
}

Vec3 MindlinDeresiewicz::operator()(const PairMaterial& pair, const ContactState& c,
                                    const NormalResponse& normal, Real dt,
                                    ContactHistory& h) const {
  const Real cap = pair.sliding * std::max(normal.force, 0.0);
  const Vec3 v = c.slip - dot(c.slip, c.normal) * c.normal;
  const Real speed = norm(v);
  Vec3 axis = h.axis - dot(h.axis, c.normal) * c.normal;
  if (norm(axis) < 0.5 && speed > 0) {
    axis = -1 * v;  // the first slip: the force will oppose it
  }
  if (cap == 0 || norm(axis) == 0) {
    h.shear = {}, h.axis = {}, h.branch = 0;
    h.normal_force = std::max(normal.force, 0.0);
    return {};
  }
  axis *= 1 / norm(axis);
  const Vec3 spring = h.shear - dot(h.shear, c.normal) * c.normal;
  ShearBranch s{dot(spring, axis), h.unload, h.reload, h.branch};
  const Vec3 side =
      spring - s.shear * axis - (normal.shear_stiffness * dt) * (v - dot(v, axis) * axis);
  const Real change = cap - pair.sliding * h.normal_force;
  const bool turned =
      follow(s, normal.shear_stiffness, cap, -dt * dot(v, axis), dt > 0 ? change : 0);
  if (turned) {
    axis *= -1;
  }
  h.shear = s.shear * axis + side;
  h.shear *= Mindlin::shrink(h.shear, cap);
  h.unload = s.unload, h.reload = s.reload, h.branch = s.branch;
  h.axis = axis;
  h.contact_radius = normal.contact_radius;
  h.normal_force = dt > 0 ? cap / pair.sliding : h.normal_force;
  const Vec3 force = h.shear - normal.shear_damping * v;
  return Mindlin::shrink(force, cap) * force;
}

}  // namespace porefines::dem
