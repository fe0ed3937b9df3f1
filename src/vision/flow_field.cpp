// SPDX-License-Identifier: MPL-2.0
#include "vision/flow_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace porefines::vision {
namespace {

std::size_t index_of(const io::FieldVolume& f, int i, int j, int k) {
  return (static_cast<std::size_t>(k) * static_cast<std::size_t>(f.cells[1]) +
          static_cast<std::size_t>(j)) *
             static_cast<std::size_t>(f.cells[0]) +
         static_cast<std::size_t>(i);
}

/// The two cells around a place along one axis, and the share of the second.
struct Between {
  int first;
  int second;
  Real share;
};

Between between(const io::FieldVolume& f, const Vec3& x, int axis) {
  const int n = f.cells[static_cast<std::size_t>(axis)];
  const Real place = std::clamp((x[axis] - f.origin[axis]) / f.spacing[axis] - 0.5, 0.0, n - 1.0);
  const int first = std::min(static_cast<int>(place), std::max(n - 2, 0));
  return {first, std::min(first + 1, n - 1), place - first};
}

/// Component c at x.
Real value_at(const io::FieldVolume& f, const Vec3& x, int c) {
  const std::array<Between, 3> b{between(f, x, 0), between(f, x, 1), between(f, x, 2)};
  Real sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    Real weight = 1;
    Int3 cell{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const bool second = ((corner >> axis) & 1) != 0;
      weight *= second ? b[axis].share : 1 - b[axis].share;
      cell[axis] = second ? b[axis].second : b[axis].first;
    }
    if (weight > 0) {
      sum +=
          weight *
          f.values[static_cast<std::size_t>(f.components) * index_of(f, cell[0], cell[1], cell[2]) +
                   static_cast<std::size_t>(c)];
    }
  }
  return sum;
}

}  // namespace

Vec3 FlowField::high() const {
  Vec3 out = velocity.origin;
  for (int axis = 0; axis < 3; ++axis) {
    out[axis] += velocity.cells[static_cast<std::size_t>(axis)] * velocity.spacing[axis];
  }
  return out;
}

FlowField read_flow(const std::string& run_dir) {
  return {io::read_last_field(run_dir, "velocity"), io::read_last_field(run_dir, "solid_fraction")};
}

Vec3 velocity_at(const FlowField& field, const Vec3& x) {
  return {value_at(field.velocity, x, 0), value_at(field.velocity, x, 1),
          value_at(field.velocity, x, 2)};
}

Real solid_fraction(const FlowField& field, const Vec3& x) {
  return value_at(field.solid, x, 0);
}

bool is_solid(const FlowField& field, const Vec3& x) {
  const Vec3 low = field.low();
  const Vec3 high = field.high();
  for (int axis = 0; axis < 3; ++axis) {
    if (x[axis] < low[axis] || x[axis] > high[axis]) {
      return true;
    }
  }
  return value_at(field.solid, x, 0) > 0.5;
}

Vec3 follow_flow(const FlowField& field, Vec3 x, Real time) {
  constexpr Real share = 0.2;  // of a cell per step
  constexpr Real slowest = 1e-12;
  const Real cell = std::min(field.velocity.spacing.x, field.velocity.spacing.y);
  while (time > 0) {
    const Vec3 k1 = velocity_at(field, x);
    const Real h = std::min(time, share * cell / std::max(norm(k1), slowest));
    const Vec3 k2 = velocity_at(field, x + 0.5 * h * k1);
    const Vec3 k3 = velocity_at(field, x + 0.5 * h * k2);
    const Vec3 k4 = velocity_at(field, x + h * k3);
    x += h / 6 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
    time -= h;
  }
  return x;
}

cv::Mat grain_picture(const FlowField& field, cv::Size size, Real pixel_size) {
  cv::Mat out(size, CV_8U, cv::Scalar(0));
  const Real z = 0.5 * (field.low().z + field.high().z);
  for (int row = 0; row < size.height; ++row) {
    for (int column = 0; column < size.width; ++column) {
      const Vec3 x{field.low().x + (column + 0.5) * pixel_size,
                   field.low().y + (size.height - 0.5 - row) * pixel_size, z};
      out.at<std::uint8_t>(row, column) = is_solid(field, x) ? 255 : 0;
    }
  }
  return out;
}

Guide guide_of_run(const std::string& run_dir, cv::Size size, Real pixel_size, Real frame_rate) {
  const FlowField field = read_flow(run_dir);
  const int depth = field.velocity.cells[2];
  const Real spread = depth > 3 ? 0.35 : 0.1;
  constexpr Real cell = 4;  // [pixels]
  return known_flow(size, cell, spread, [&](const cv::Point2d& at) {
    Vec3 sum;
    for (int k = 0; k < depth; ++k) {
      const Vec3 x{field.low().x + (at.x + 0.5) * pixel_size,
                   field.low().y + (size.height - 0.5 - at.y) * pixel_size,
                   field.low().z + (k + 0.5) * field.velocity.spacing.z};
      sum += velocity_at(field, x);
    }
    const Real factor = 1 / (depth * pixel_size * frame_rate);
    return cv::Point2d(factor * sum.x, -factor * sum.y);
  });
}

}  // namespace porefines::vision
