// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstdint>

namespace porefines {

using Real = double;
using Index = std::int64_t;  ///< counts of cells: a grid may hold more than 2^31

/// Integer triple: grid sizes, cell indices, rank coordinates.
using Int3 = std::array<int, 3>;

/// Cartesian vector, SI unless a comment says otherwise.
struct Vec3 {
  Real x = 0;
  Real y = 0;
  Real z = 0;

  Real& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  Real operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }

  Vec3& operator+=(const Vec3& b) { return x += b.x, y += b.y, z += b.z, *this; }
  Vec3& operator-=(const Vec3& b) { return x -= b.x, y -= b.y, z -= b.z, *this; }
  Vec3& operator*=(Real s) { return x *= s, y *= s, z *= s, *this; }

  friend Vec3 operator+(Vec3 a, const Vec3& b) { return a += b; }
  friend Vec3 operator-(Vec3 a, const Vec3& b) { return a -= b; }
  friend Vec3 operator*(Vec3 a, Real s) { return a *= s; }
  friend Vec3 operator*(Real s, Vec3 a) { return a *= s; }
  friend Vec3 operator/(Vec3 a, Real s) { return a *= 1 / s; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

[[nodiscard]] inline Real dot(const Vec3& a, const Vec3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
[[nodiscard]] inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
[[nodiscard]] inline Real norm(const Vec3& a) {
  return std::sqrt(dot(a, a));
}

[[nodiscard]] inline Index product(const Int3& n) {
  return Index{n[0]} * n[1] * n[2];
}

inline constexpr Real darcy = 9.869233e-13;  ///< [m^2]

/// The six faces of the box, in the order x- x+ y- y+ z- z+.
enum class BoxFace { x_low, x_high, y_low, y_high, z_low, z_high };
[[nodiscard]] constexpr int axis_of(BoxFace face) {
  return static_cast<int>(face) / 2;
}
[[nodiscard]] constexpr bool is_high(BoxFace face) {
  return static_cast<int>(face) % 2 == 1;
}
[[nodiscard]] constexpr BoxFace box_face(int axis, bool high) {
  return static_cast<BoxFace>(2 * axis + (high ? 1 : 0));
}

}  // namespace porefines
