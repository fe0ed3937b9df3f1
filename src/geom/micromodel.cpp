// SPDX-License-Identifier: MPL-2.0
#include "geom/micromodel.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <numeric>

#include <fmt/format.h>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "geom/clean.hpp"
#include "geom/noise.hpp"
#include "geom/power_cells.hpp"
#include "geom/throat_opening.hpp"

namespace porefines::geom {

namespace {

/// f over the picture, blurred to round the corners.
cv::Mat1f draw_field(const MicromodelSpec& spec) {
  PowerCells cells(spec);
  const Real wide = 0.8 * spec.grain;
  const Real fine = 0.3 * spec.grain;
  const auto make = [&](Real wavelength, std::uint64_t number) {
    return Noise(spec.pixels, spec.periodic, wavelength, 31 * spec.seed + number);
  };
  const std::array<Noise, 4> noise{make(wide, 1), make(wide, 2), make(fine, 3), make(fine, 4)};
  const Real strong = 0.28 * spec.roughness * spec.grain;
  const Real weak = 0.07 * spec.roughness * spec.grain;
  cv::Mat1f f(spec.pixels[1], spec.pixels[0]);
  for (int j = 0; j < spec.pixels[1]; ++j) {
    float* const row = f.ptr<float>(j);
    for (int i = 0; i < spec.pixels[0]; ++i) {
      const Real x = i + 0.5;
      const Real y = j + 0.5;
      row[i] = static_cast<float>(
          cells.border_distance(x + strong * noise[0](x, y) + weak * noise[2](x, y),
                                y + strong * noise[1](x, y) + weak * noise[3](x, y)));
    }
  }
  const int edge = static_cast<int>(std::ceil(0.2 * spec.grain)) + 2;
  cv::Mat1f padded;
  cv::copyMakeBorder(f, padded, edge, edge, edge, edge,
                     spec.periodic ? cv::BORDER_WRAP : cv::BORDER_REFLECT);
  cv::GaussianBlur(padded, padded, {}, 0.065 * spec.grain);
  return padded(cv::Rect(edge, edge, f.cols, f.rows)).clone();
}

/// Grains where f is among its highest values, a share of 1 - porosity.
Voxels cut(const cv::Mat1f& f, Real porosity) {
  std::vector<float> values(f.begin(), f.end());
  const auto rank = static_cast<std::ptrdiff_t>(std::clamp(porosity, 0.0, 1.0) *
                                                static_cast<Real>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  const float level = values[static_cast<std::size_t>(rank)];
  Voxels out = make_voxels({f.cols, f.rows, 1}, 0);
  std::transform(f.begin(), f.end(), out.pore.begin(), [level](float value) {
    return value < level ? std::uint8_t{1} : std::uint8_t{0};
  });
  return out;
}

/// Fill what a disc of diameter `width` cannot reach: crevices that no etching would resolve.
void fill_crevices(Voxels& voxels, Real width, bool periodic) {
  const int r = static_cast<int>(0.5 * width);
  cv::Mat1b disc(2 * r + 1, 2 * r + 1, std::uint8_t{0});
  for (int j = -r; j <= r; ++j) {
    for (int i = -r; i <= r; ++i) {
      disc(j + r, i + r) = i * i + j * j <= 0.25 * width * width ? 1 : 0;
    }
  }
  const cv::Mat1b pore(voxels.n[1], voxels.n[0], voxels.pore.data());
  cv::Mat1b padded;
  const int edge = 2 * r + 2;
  cv::copyMakeBorder(pore, padded, edge, edge, edge, edge,
                     periodic ? cv::BORDER_WRAP : cv::BORDER_REFLECT);
  cv::morphologyEx(padded, padded, cv::MORPH_OPEN, disc);
  const cv::Mat1b inner = padded(cv::Rect(edge, edge, pore.cols, pore.rows));
  std::copy(inner.begin(), inner.end(), voxels.pore.begin());
}

void require_sane(const MicromodelSpec& spec) {
  if (spec.pixels[0] < 16 || spec.pixels[1] < 16 || !(spec.grain >= 6) ||
      spec.grain > std::min(spec.pixels[0], spec.pixels[1]) / 2.0) {
    throw InputError(fmt::format(
        "a micromodel of {} x {} pixels with grains of {:.3g} pixels: grains must be at least 6 "
        "pixels and at most half the picture.",
        spec.pixels[0], spec.pixels[1], spec.grain));
  }
  if (!(spec.porosity >= 0.2 && spec.porosity <= 0.9) || !(spec.throat >= 0) ||
      spec.throat > spec.grain || spec.cemented < 0 || spec.cemented > 0.25) {
    throw InputError(fmt::format(
        "a micromodel needs a porosity within 0.2..0.9 (got {:.3g}), a least throat up to the "
        "grain size (got {:.3g} of {:.3g} pixels) and a cemented share within 0..0.25 (got "
        "{:.3g}).",
        spec.porosity, spec.throat, spec.grain, spec.cemented));
  }
}

/// Fill the pores that do not connect x- and x+. @return porosity left; 0 when none does
Real carrying_share(Voxels& voxels, const std::array<bool, 3>& periodic) {
  const auto parts = find_components(voxels.view(), Phase::pore, periodic, 0);
  if (std::none_of(parts.component.begin(), parts.component.end(),
                   [&](const Component& part) { return percolates(part, periodic[0]); })) {
    return 0;
  }
  keep_percolating(voxels, periodic, 0, "micromodel");
  return static_cast<Real>(std::accumulate(voxels.pore.begin(), voxels.pore.end(), Index{0})) /
         static_cast<Real>(voxels.pore.size());
}

}  // namespace

Voxels make_micromodel(const MicromodelSpec& spec) {
  require_sane(spec);
  const cv::Mat1f f = draw_field(spec);
  const std::array<bool, 3> periodic{spec.periodic, spec.periodic, false};
  const Beyond side = spec.periodic ? Beyond::periodic : Beyond::mirror;
  const auto speck = static_cast<Index>(0.05 * spec.grain * spec.grain);
  Real target = spec.porosity;
  Voxels best;
  Real least = 1;
  for (int round = 0; round < 10 && least > 5e-4; ++round) {
    Voxels voxels = cut(f, target);
    remove_small(voxels, Phase::grain, speck, periodic);
    open_throats(voxels, spec.throat + 1, {side, side, side});
    fill_crevices(voxels, spec.throat, spec.periodic);
    remove_small(voxels, Phase::grain, speck, periodic);
    const Real porosity = carrying_share(voxels, periodic);
    if (std::abs(porosity - spec.porosity) < least) {
      least = std::abs(porosity - spec.porosity);
      best = std::move(voxels);
    }
    target = std::clamp(target + spec.porosity - porosity, target - 0.1, target + 0.1);
  }
  if (least > 2e-3) {
    throw InputError(fmt::format(
        "porosity {:.3g} cannot be met with throats of at least {:.3g} pixels (closest: {:.3g} "
        "away).\nTry narrower throats, larger grains or a larger porosity.",
        spec.porosity, spec.throat, least));
  }
  return best;
}

}  // namespace porefines::geom
