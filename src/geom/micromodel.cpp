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
#include "geom/packing.hpp"
#include "geom/random.hpp"
#include "geom/throat_opening.hpp"

namespace porefines::geom {

namespace {

constexpr Real removed_share = 0.07;  // cells without a grain: the larger pore bodies

/// Smooth noise in -1..1: values on a hashed lattice, quintic interpolation (Perlin 2002).
class Noise {
 public:
  Noise(const MicromodelSpec& spec, Real wavelength, std::uint64_t key)
      : key_(hash_key(spec.seed, key)) {
    for (std::size_t a = 0; a < 2; ++a) {
      cells_[a] = std::max(static_cast<int>(std::lround(spec.pixels[a] / wavelength)), 1);
      scale_[a] = cells_[a] / static_cast<Real>(spec.pixels[a]);
    }
    periodic_ = spec.periodic;
  }

  [[nodiscard]] Real operator()(Real x, Real y) const {
    const Real u = x * scale_[0];
    const Real v = y * scale_[1];
    const int i = static_cast<int>(std::floor(u));
    const int j = static_cast<int>(std::floor(v));
    const Real s = ease(u - i);
    const Real t = ease(v - j);
    return (1 - t) * ((1 - s) * at(i, j) + s * at(i + 1, j)) +
           t * ((1 - s) * at(i, j + 1) + s * at(i + 1, j + 1));
  }

 private:
  static std::uint64_t hash_key(std::uint64_t seed, std::uint64_t key) {
    return static_cast<std::uint64_t>(hash_uniform(seed * 31 + key) * 0x1.0p52);
  }
  static Real ease(Real t) { return t * t * t * (t * (6 * t - 15) + 10); }
  [[nodiscard]] Real at(int i, int j) const {
    if (periodic_) {
      i = ((i % cells_[0]) + cells_[0]) % cells_[0];
      j = ((j % cells_[1]) + cells_[1]) % cells_[1];
    }
    const auto place = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(i)) << 32) |
                       static_cast<std::uint32_t>(j);
    return 2 * hash_uniform(key_ ^ place) - 1;
  }
  std::uint64_t key_;
  std::array<int, 2> cells_{};
  std::array<Real, 2> scale_{};
  bool periodic_ = false;
};

/// Cells of the power diagram, findable by position.
class Cells {
 public:
  explicit Cells(const MicromodelSpec& spec) : spec_(spec) {
    const Real share = 1 - spec.porosity;
    const Real grain_area = std::numbers::pi / 4 * spec.grain * spec.grain;
    // one grain takes grain_area / share of the picture; cementing joins about 3 pairs per cell
    const Real cell_area = grain_area / share * (1 - removed_share) * (1 - 3 * spec.cemented);
    constexpr Real packed = 0.7;
    PackSpec pack;
    pack.dims = 2;
    margin_ = spec.periodic ? 0 : 3 * std::sqrt(cell_area);
    pack.size = {spec.pixels[0] + 2 * margin_, spec.pixels[1] + 2 * margin_, 1};
    pack.porosity = 1 - packed;
    pack.diameter =
        std::sqrt(4 / std::numbers::pi * packed * cell_area / (1 + spec.spread * spec.spread));
    pack.spread = spec.spread;
    pack.seed = spec.seed;
    body_ = make_packing(pack);
    size_ = pack.size;
    for (std::size_t a = 0; a < 2; ++a) {
      bins_[a] = std::max(static_cast<int>(size_[static_cast<int>(a)] / std::sqrt(cell_area)), 1);
    }
    bin_.resize(static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(bins_[1]));
    for (std::size_t b = 0; b < body_.size(); ++b) {
      bin_[place(bin_of(body_[b].centre.x, 0), bin_of(body_[b].centre.y, 1))].push_back(
          static_cast<std::int32_t>(b));
    }
    width_ = 0.16 * spec.grain;
  }

  /// f at a point of the picture [pixels]; negative in cells without a grain.
  [[nodiscard]] Real border_distance(Real x, Real y) {
    gather(x + margin_, y + margin_);
    const auto home = std::min_element(
        near_.begin(), near_.end(), [](const Near& a, const Near& b) { return a.power < b.power; });
    if (hash_uniform(key(home->cell, -1)) < removed_share) {
      return -width_;
    }
    Real f = std::numeric_limits<Real>::max();
    for (const Near& other : near_) {
      if (other.cell == home->cell) {
        continue;
      }
      const Real apart = norm(Vec3{other.dx - home->dx, other.dy - home->dy, 0});
      const Real border = (other.power - home->power) / (2 * apart);
      if (border > f + width_) {
        continue;
      }
      const std::uint64_t pair =
          key(std::min(other.cell, home->cell), std::max(other.cell, home->cell));
      if (hash_uniform(pair) >= spec_.cemented) {
        f = std::min(f, border - width_ * (hash_uniform(pair + 1) - 0.5));
      }
    }
    return std::min(f, spec_.grain);
  }

 private:
  struct Near {
    std::int32_t cell;
    Real dx, dy;  ///< from the point to the centre
    Real power;   ///< |x - c|^2 - r^2
  };

  /// The cells in the 5x5 bins around a point.
  void gather(Real x, Real y) {
    near_.clear();
    const int ci = bin_of(x, 0);
    const int cj = bin_of(y, 1);
    const int ri = std::min(2, (bins_[0] - 1) / 2);
    const int rj = std::min(2, (bins_[1] - 1) / 2);
    for (int j = cj - rj; j <= cj + rj; ++j) {
      for (int i = ci - ri; i <= ci + ri; ++i) {
        const int wi = (i + bins_[0]) % bins_[0];
        const int wj = (j + bins_[1]) % bins_[1];
        for (const std::int32_t b : bin_[place(wi, wj)]) {
          const Body& body = body_[static_cast<std::size_t>(b)];
          Real dx = body.centre.x - x;
          Real dy = body.centre.y - y;
          dx -= size_.x * std::round(dx / size_.x);
          dy -= size_.y * std::round(dy / size_.y);
          near_.push_back({b, dx, dy, dx * dx + dy * dy - body.radius * body.radius});
        }
      }
    }
  }

  [[nodiscard]] int bin_of(Real x, int axis) const {
    const auto a = static_cast<std::size_t>(axis);
    const int i = static_cast<int>(std::floor(x / size_[axis] * bins_[a]));
    return ((i % bins_[a]) + bins_[a]) % bins_[a];
  }
  [[nodiscard]] std::size_t place(int i, int j) const {
    return static_cast<std::size_t>(i) +
           static_cast<std::size_t>(bins_[0]) * static_cast<std::size_t>(j);
  }
  [[nodiscard]] std::uint64_t key(std::int32_t a, std::int32_t b) const {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 33) +
           (static_cast<std::uint64_t>(static_cast<std::uint32_t>(b)) << 1) +
           spec_.seed * 0x5851F42DULL;
  }

  const MicromodelSpec& spec_;
  Real margin_ = 0;  ///< [pixels] cells reach this far beyond the picture
  Real width_ = 0;   ///< [pixels] spread of the channel widths
  Vec3 size_;
  std::vector<Body> body_;
  std::array<int, 2> bins_{};
  std::vector<std::vector<std::int32_t>> bin_;
  std::vector<Near> near_;
};

/// f over the picture, blurred to round the corners.
cv::Mat1f draw_field(const MicromodelSpec& spec) {
  Cells cells(spec);
  const Real wide = 0.8 * spec.grain;
  const Real fine = 0.3 * spec.grain;
  const std::array<Noise, 4> noise{Noise(spec, wide, 1), Noise(spec, wide, 2), Noise(spec, fine, 3),
                                   Noise(spec, fine, 4)};
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
