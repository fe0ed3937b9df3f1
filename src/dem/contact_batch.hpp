// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <span>

#include "dem/contact_law.hpp"

namespace porefines::dem {

/// Contacts evaluated side by side in vector registers: gather, law, scatter.
inline constexpr int batch_width = 64;

struct alignas(64) ContactBatch {
  using Lane = std::array<Real, batch_width>;
  struct Lane3 {
    Lane x, y, z;
    void set(int k, const Vec3& v) { x[k] = v.x, y[k] = v.y, z[k] = v.z; }
    [[nodiscard]] Vec3 get(int k) const { return {x[k], y[k], z[k]}; }
  };
  // In: what ContactState holds.
  Lane3 normal, slip, spin;
  Lane overlap, radius, mass, inertia;
  std::array<int, batch_width> pair;  ///< row of the material table
  // In and out.
  std::array<Lane, history_size> history;
  // Out.
  Lane3 force, couple;
  Lane pressing;                                    ///< normal part of the force
  Lane spent_normal, spent_sliding, spent_rolling;  ///< when asked for

  [[nodiscard]] Spent spent(int k) const {
    return {spent_normal[k], spent_sliding[k], spent_rolling[k]};
  }
  int count = 0;

  void load_history(int k, const Real* from, int length) {
    for (int h = 0; h < length; ++h) {
      history[h][k] = from[h];
    }
  }
  void store_history(int k, Real* to, int length) const {
    for (int h = 0; h < length; ++h) {
      to[h] = history[h][k];
    }
  }
};

/// The work of one evaluated contact.
template <typename Law>
[[gnu::always_inline]] inline void account(const Law& law, const PairMaterial& material,
                                           const ContactState& c, const ContactForce& f,
                                           const Vec3& shear_change, const Vec3& rolling_change,
                                           Real dt, int k, ContactBatch& b) {
  const Real closing = -dot(c.normal, c.slip) - 0.5 * dt * f.normal / c.mass;
  const Vec3 tangential = f.force - f.normal * c.normal;
  b.spent_normal[k] = (f.normal - law.normal.elastic(material, c)) * closing * dt;
  b.spent_sliding[k] = -dot(tangential - 0.5 * shear_change, c.slip) * dt;
  b.spent_rolling[k] = -dot(f.couple - 0.5 * rolling_change, c.spin) * dt;
}

/// Applies the law to every contact of the batch. Bitwise the same as one at a time.
template <bool accounts, typename Law>
void evaluate(const Law& law, std::span<const PairMaterial> table, Real dt, ContactBatch& b) {
  const PairMaterial* materials = table.data();
  const int lanes = (b.count + 7) / 8 * 8;  // what lies beyond the count is never read
#pragma omp simd
  for (int k = 0; k < lanes; ++k) {
    const ContactState c{b.normal.get(k), b.overlap[k], b.slip.get(k), b.spin.get(k),
                         b.radius[k],     b.mass[k],    b.inertia[k]};
    ContactHistory h;
    h.shear = {b.history[0][k], b.history[1][k], b.history[2][k]};
    h.contact_radius = b.history[3][k];
    h.rolling = {b.history[4][k], b.history[5][k], b.history[6][k]};
    if constexpr (Law::memory > basic_history) {
      h.normal_force = b.history[7][k];
      h.unload = b.history[8][k], h.reload = b.history[9][k];
      h.axis = {b.history[10][k], b.history[11][k], b.history[12][k]};
      h.branch = b.history[13][k];
    }
    const Vec3 shear = h.shear;
    const Vec3 rolling = h.rolling;
    const ContactForce f = law(materials[b.pair[k]], c, dt, h);
    if constexpr (accounts) {
      account(law, materials[b.pair[k]], c, f, h.shear - shear, h.rolling - rolling, dt, k, b);
    }
    b.force.set(k, f.force), b.couple.set(k, f.couple);
    b.pressing[k] = f.normal;
    b.history[0][k] = h.shear.x, b.history[1][k] = h.shear.y, b.history[2][k] = h.shear.z;
    b.history[3][k] = h.contact_radius;
    b.history[4][k] = h.rolling.x, b.history[5][k] = h.rolling.y, b.history[6][k] = h.rolling.z;
    if constexpr (Law::memory > basic_history) {
      b.history[7][k] = h.normal_force;
      b.history[8][k] = h.unload, b.history[9][k] = h.reload;
      b.history[10][k] = h.axis.x, b.history[11][k] = h.axis.y, b.history[12][k] = h.axis.z;
      b.history[13][k] = h.branch;
    }
  }
}

/// The same, with the work of the contacts where it is asked for.
template <typename Law>
void evaluate(const Law& law, std::span<const PairMaterial> table, const Evaluation& evaluation,
              ContactBatch& b) {
  if (evaluation.account) {
    evaluate<true>(law, table, evaluation.dt, b);
  } else {
    evaluate<false>(law, table, evaluation.dt, b);
  }
}

}  // namespace porefines::dem
