// SPDX-License-Identifier: MPL-2.0
#include "geom/power_cells.hpp"

#include <algorithm>
#include <limits>
#include <numbers>

#include "geom/packing.hpp"
#include "geom/random.hpp"

namespace porefines::geom {

namespace {

constexpr Real removed_share = 0.07;  // cells without a grain

}  // namespace

PowerCells::PowerCells(const MicromodelSpec& spec) : spec_(spec) {
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

Real PowerCells::border_distance(Real x, Real y) {
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

/// The cells in the 5x5 bins around a point.
void PowerCells::gather(Real x, Real y) {
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

}  // namespace porefines::geom
