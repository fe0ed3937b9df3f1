// SPDX-License-Identifier: MPL-2.0
// ten Cate's settling sphere: a quarter of an hour on one core.
#include <fstream>

#include "support/shared_data.hpp"
#include "support/ten_cate.hpp"

namespace porefines::test {

/// Without inertia the slow sphere would fall at 0.936 of u_inf in mid-box (Happel & Bart 1974, square duct: drag
/// 1.386 times Stokes's): below the 0.947 that the experiment reports with it. Its digitised heights give 0.91 to 0.93.
TEST(SettlingValidation, creeping_flow_bounds_the_slow_sphere) {
  for (const int cells : {6, 9}) {
    const Settling& q = slow_settling;
    const Real h = 0.015 / cells;
    const par::Communicator comm;
    const Int3 size{20 * cells / 3, 20 * cells / 3, 32 * cells / 3};
    flow::StokesSolver solver(comm, even_cut(size, comm.size()), {h, h, h}, closed_box(),
                              q.viscosity);
    solver.set_surface([](const Vec3&) { return 1e3; });
    flow::Sphere ball = sphere(1, {0.0501, 0.0501, 0.0801}, 0.0075);
    ball.force = {0, 0, -9.81 * M_PI / 6 * std::pow(0.015, 3) * (1120 - q.density)};
    solver.set_spheres(std::vector{ball});
    EXPECT_TRUE(solver.solve({}, to(1e-6)).converged);
    const Real speed = -solver.sphere_motions().front().velocity.z / q.terminal;
    std::printf("creeping: %.4f of u_inf\n", speed);
    EXPECT_NEAR(speed / 0.936, 1, 0.01);
  }
}

namespace {

struct Digitised {
  std::vector<Real> time, value;
};

Digitised digitised(const std::string& figure) {
  std::ifstream file(shared_file("measurements/ten_cate_2002/tenCate2002-" + figure + ".csv"));
  Digitised points;
  for (Real time = 0, value = 0; file >> time >> value;) {
    points.time.push_back(time);
    points.value.push_back(value);
  }
  return points;
}

/// Value at `time`, linear between points of a curve that starts at (0, first).
Real at(const std::vector<Real>& times, const std::vector<Real>& values, Real first, Real time) {
  Real t0 = 0;
  Real v0 = first;
  for (std::size_t i = 0; i < times.size(); t0 = times[i], v0 = values[i], ++i) {
    if (times[i] >= time && times[i] > t0) {
      return v0 + (values[i] - v0) * (time - t0) / (times[i] - t0);
    }
  }
  return v0;
}

/// Gaps over the diameter from measured speeds [m/s, downwards below 0], by the trapezoidal rule from 8.
Digitised fallen(const Digitised& speeds) {
  Digitised gaps{speeds.time, {}};
  Real t = 0;
  Real w = 0;
  Real gap = 8;
  for (std::size_t i = 0; i < speeds.time.size(); ++i) {
    gap += (w + speeds.value[i]) / 2 * (speeds.time[i] - t) / 0.015;
    t = speeds.time[i];
    w = speeds.value[i];
    gaps.value.push_back(gap);
  }
  return gaps;
}

/// The experiment's two figures of one fall, heights and speeds, do not agree: speeds integrated end up to half a
/// diameter lower. In that band, `scatter` of single points added, the computed fall has to lie.
void expect_within_the_data(const Fall& fall, const std::string& reynolds, Real scatter) {
  const Digitised heights = digitised("fig5a-Re" + reynolds);
  const Digitised sums = fallen(digitised("fig5b-Re" + reynolds));
  if (heights.time.empty()) {
    GTEST_SKIP() << "../shared/data is not beside this checkout";
  }
  Real disagreement = 0;
  Real error = 0;
  std::printf("time [s], gap / d: heights, speeds integrated, computed\n");
  for (std::size_t i = 0; i < heights.time.size(); ++i) {
    const Real time = heights.time[i];
    const Real sum = at(sums.time, sums.value, 8, time);
    const Real gap = (at(fall.time, fall.height, 0.1275, time) - 0.0075) / 0.015;
    std::printf("%.3f %.3f %.3f %.3f\n", time, heights.value[i], sum, gap);
    EXPECT_GT(gap, std::min(sum, heights.value[i]) - scatter) << time;
    EXPECT_LT(gap, std::max(sum, heights.value[i]) + scatter) << time;
    disagreement += std::pow(sum - heights.value[i], 2);
    error += std::pow(gap - (sum + heights.value[i]) / 2, 2);
  }
  std::printf("rms off the mean of both %.3f d; half of their disagreement %.3f d\n",
              std::sqrt(error / heights.time.size()),
              std::sqrt(disagreement / heights.time.size()) / 2);
}

}  // namespace

/// Peak speed over the terminal one, 12 cells per diameter: 0.947 (Re 1.5) and 0.955 (Re 31.9) in the experiment;
/// references.md B7 accepts 5 %, as its two digitised figures differ by 3 to 5 %. Scatter of single points about
/// their own smooth curve: 0.13 d and 0.16 d.
TEST(SettlingValidation, slow_fall) {
  const Fall fall = settle(slow_settling, 12, 0.5);
  std::printf("peak speed %.4f\n", fall.peak);
  EXPECT_NEAR(fall.peak / 0.947, 1, 0.05);
  expect_within_the_data(fall, "1p5", 0.13);
}

TEST(SettlingValidation, fast_fall) {
  const Fall fall = settle(fast_settling, 12, 0.5);
  std::printf("peak speed %.4f\n", fall.peak);
  EXPECT_NEAR(fall.peak / 0.955, 1, 0.03);
  expect_within_the_data(fall, "31p9", 0.16);
}

/// The error does not grow with the cells: 15 per diameter fit the box.
TEST(SettlingValidation, fast_fall_on_finer_cells) {
  const Fall fall = settle(fast_settling, 15, 0.5);
  std::printf("peak speed %.4f\n", fall.peak);
  EXPECT_NEAR(fall.peak / 0.955, 1, 0.03);
  expect_within_the_data(fall, "31p9", 0.16);
}

}  // namespace porefines::test
