// SPDX-License-Identifier: MPL-2.0
#include "report/picture_colormap.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace porefines::report {
namespace {

/// Lightness, chroma, hue [degrees]: polar OKLab.
struct Lch {
  Real l;
  Real c;
  Real h;
};

Vec3 linear_from_lab(const Vec3& lab) {
  const Real l = std::pow(lab.x + 0.3963377774 * lab.y + 0.2158037573 * lab.z, 3);
  const Real m = std::pow(lab.x - 0.1055613458 * lab.y - 0.0638541728 * lab.z, 3);
  const Real s = std::pow(lab.x - 0.0894841775 * lab.y - 1.2914855480 * lab.z, 3);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
          -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

Vec3 lab_from_linear(const Vec3& rgb) {
  const Real l = std::cbrt(0.4122214708 * rgb.x + 0.5363325363 * rgb.y + 0.0514459929 * rgb.z);
  const Real m = std::cbrt(0.2119034982 * rgb.x + 0.6806995451 * rgb.y + 0.1073969566 * rgb.z);
  const Real s = std::cbrt(0.0883024619 * rgb.x + 0.2817188376 * rgb.y + 0.6299787005 * rgb.z);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

std::uint8_t encode(Real linear) {
  const Real x = std::clamp(linear, 0.0, 1.0);
  const Real gamma = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<std::uint8_t>(std::lround(255 * gamma));
}

Real decode(std::uint8_t byte) {
  const Real x = byte / 255.0;
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

Vec3 lab_of(const Rgb& colour) {
  return lab_from_linear({decode(colour[0]), decode(colour[1]), decode(colour[2])});
}

Vec3 lab_of(const Lch& colour) {
  const Real angle = colour.h * std::numbers::pi / 180;
  return {colour.l, colour.c * std::cos(angle), colour.c * std::sin(angle)};
}

/// Colours that the screen cannot show lose chroma until it can.
Vec3 shown(Lch colour) {
  const auto fits = [](const Vec3& rgb) {
    return std::min({rgb.x, rgb.y, rgb.z}) >= -1e-4 && std::max({rgb.x, rgb.y, rgb.z}) <= 1 + 1e-4;
  };
  while (colour.c > 0 && !fits(linear_from_lab(lab_of(colour)))) {
    colour.c -= 0.001;
  }
  return lab_of(colour);
}

Real mix(Real a, Real b, Real t) {
  return a + (b - a) * t;
}

Lch curve(Colormap map, Real t) {
  switch (map) {
    case Colormap::speed:
      return {mix(0.24, 0.93, t), mix(0.115, 0.165, t) - 0.19 * t * (1 - t), mix(295, 106, t)};
    case Colormap::pressure:
      return {mix(0.96, 0.28, t), 0.11 * std::sin(std::numbers::pi * (0.1 + 0.66 * t)),
              mix(215, 268, t)};
    case Colormap::pale:
      return {mix(0.975, 0.57, t), mix(0.01, 0.13, t), mix(220, 252, t)};
    case Colormap::rock:
      return {mix(0.985, 0.62, t), mix(0.004, 0.035, t), 75};
    case Colormap::diverging:
      break;
  }
  const Real away = std::abs(2 * t - 1);
  return {mix(0.965, 0.43, away), 0.155 * away, t < 0.5 ? 258.0 : 27.0};
}

/// 256 colours at equal distances along the curve.
std::vector<Rgb> tabulate(Colormap map) {
  constexpr int fine = 4000;
  std::vector<Vec3> points(fine + 1);
  std::vector<Real> length(fine + 1, 0);
  for (int i = 0; i <= fine; ++i) {
    points[i] = shown(curve(map, static_cast<Real>(i) / fine));
    length[i] = i == 0 ? 0 : length[i - 1] + norm(points[i] - points[i - 1]);
  }
  std::vector<Rgb> table(256);
  for (int i = 0; i < 256; ++i) {
    const Real wanted = length[fine] * i / 255;
    const auto at = std::min<std::ptrdiff_t>(
        fine, std::lower_bound(length.begin(), length.end(), wanted) - length.begin());
    const Vec3 rgb = linear_from_lab(points[at]);
    table[i] = {encode(rgb.x), encode(rgb.y), encode(rgb.z)};
  }
  return table;
}

}  // namespace

Rgb colour(Colormap map, Real position) {
  static const std::array<std::vector<Rgb>, 5> tables{
      tabulate(Colormap::speed), tabulate(Colormap::pressure), tabulate(Colormap::diverging),
      tabulate(Colormap::pale), tabulate(Colormap::rock)};
  if (std::isnan(position)) {
    return {255, 255, 255};
  }
  const auto entry = static_cast<std::size_t>(std::lround(255 * std::clamp(position, 0.0, 1.0)));
  return tables[static_cast<std::size_t>(map)][entry];
}

Real lightness(const Rgb& colour) {
  return lab_of(colour).x;
}

Real difference(const Rgb& a, const Rgb& b) {
  return norm(lab_of(a) - lab_of(b));
}

}  // namespace porefines::report
