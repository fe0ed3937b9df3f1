// SPDX-License-Identifier: MPL-2.0
#include "dem/relax.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace porefines::dem {
namespace {

constexpr Real skin_share = 0.3;  ///< of the mean diameter
constexpr Real vanished = 1e-9;   ///< an overlap of so many mean diameters is none

/// Appends copies of those particles that lie within `reach` of a periodic border, beyond the other.
/// @return  for each ghost the particle it copies and by how much it is moved
std::vector<std::pair<std::uint32_t, Vec3>> add_images(Particles& p, const PackingSpace& space,
                                                       Real reach) {
  std::vector<std::pair<std::uint32_t, Vec3>> images;
  for (std::uint32_t i = 0; i < p.owned; ++i) {
    images.emplace_back(i, Vec3{});
  }
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t so_far = images.size();
    const Real edge = space.high[axis] - space.low[axis];
    for (std::size_t g = 0; space.periodic[axis] && g < so_far; ++g) {
      const auto [origin, shift] = images[g];
      const Real x = p.position[origin][axis];
      for (const Real side : {-1.0, 1.0}) {
        if (side > 0 ? x < space.low[axis] + reach : x > space.high[axis] - reach) {
          Vec3 moved = shift;
          moved[axis] += side * edge;
          images.emplace_back(origin, moved);
        }
      }
    }
  }
  p.resize(images.size());
  for (std::size_t g = p.owned; g < images.size(); ++g) {
    p.position[g] = p.position[images[g].first] + images[g].second;
    p.radius[g] = p.radius[images[g].first];
  }
  return images;
}

}  // namespace

Relaxation::Relaxation(const PackingSpace& space, std::vector<Vec3> position,
                       std::vector<Real> radius)
    : space_(space),
      position_(std::move(position)),
      radius_(std::move(radius)),
      velocity_(position_.size()),
      force_(position_.size()) {
  std::array<bool, 6> solid{};
  for (std::size_t face = 0; face < 6; ++face) {
    solid[face] = !space_.periodic[face / 2];
  }
  walls_.emplace_back(box_faces(space_.low, space_.high, solid));
  if (space_.surfaces != nullptr) {
    walls_.insert(walls_.end(), space_.surfaces->begin(), space_.surfaces->end());
  }
  const auto count = static_cast<Real>(radius_.size());
  mean_diameter_ = 2 * std::accumulate(radius_.begin(), radius_.end(), Real{0}) / count;
  skin_ = skin_share * mean_diameter_;
}

void Relaxation::scale(Real factor) {
  for (Real& radius : radius_) {
    radius *= factor;
  }
  mean_diameter_ *= factor;
  listed_at_.clear();
}

void Relaxation::find_near() {
  Particles p;
  p.owned = position_.size();
  p.resize(p.owned);
  const Box box{space_.low, space_.high, space_.periodic};
  for (std::size_t i = 0; i < p.owned; ++i) {
    position_[i] = box.wrapped(position_[i]);
    p.position[i] = position_[i];
    p.radius[i] = radius_[i];
  }
  const Real largest = *std::max_element(radius_.begin(), radius_.end());
  const auto images = add_images(p, space_, 2 * largest + skin_);
  PairList pairs;
  (void)find_pairs(p, skin_, pairs);
  near_.clear();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const std::uint32_t i = pairs.first[k];
    const auto& [j, image] = images[pairs.second[k]];
    // A pair across a border is listed from both sides: once is enough.
    const bool first_side = i < j || (i == j && (image.x + image.y + image.z) > 0);
    if (pairs.second[k] < p.owned || first_side) {
      near_.push_back({i, j, image});
    }
  }
  listed_at_ = position_;
}

void Relaxation::refresh_near() {
  bool moved = listed_at_.empty();
  const Real allowed = skin_ * skin_ / 4;
  for (std::size_t i = 0; i < position_.size() && !moved; ++i) {
    const Vec3 d = position_[i] - listed_at_[i];
    moved = dot(d, d) > allowed;
  }
  if (moved) {
    find_near();
  }
}

void Relaxation::push_from_walls() {
  TouchList touches;
  for (std::size_t i = 0; i < position_.size(); ++i) {
    find_touches(walls_, position_[i], radius_[i], 0, touches);
    for (const Touch& touch : touches.view()) {
      force_[i] -= (touch.share * touch.gap) * touch.normal;
      loads_.largest_overlap = std::max(loads_.largest_overlap, -touch.gap);
      loads_.overlaps -= touch.gap;
      loads_.shares -= touch.gap / (2 * radius_[i]);
      ++loads_.wall_contacts;
    }
  }
}

void Relaxation::find_forces() {
  loads_ = {};
  std::fill(force_.begin(), force_.end(), Vec3{});
  for (const Near& pair : near_) {
    const Vec3 d = position_[pair.second] + pair.image - position_[pair.first];
    const Real reach = radius_[pair.first] + radius_[pair.second];
    const Real square = dot(d, d);
    if (square >= reach * reach) {
      continue;
    }
    const Real distance = std::sqrt(square);
    const Real overlap = reach - distance;
    const Vec3 push = distance > 0 ? (overlap / distance) * d : Vec3{overlap, 0, 0};
    force_[pair.first] -= push;
    force_[pair.second] += push;
    loads_.largest_overlap = std::max(loads_.largest_overlap, overlap);
    loads_.overlaps += overlap;
    loads_.shares += overlap / reach;
    ++loads_.pair_contacts;
  }
  push_from_walls();
  for (const Vec3& force : force_) {
    loads_.largest_force = std::max(loads_.largest_force, dot(force, force));
  }
  loads_.largest_force = std::sqrt(loads_.largest_force);
}

bool Relaxation::minimise(Real balance, Index most) {
  constexpr Real start_mixing = 0.1;
  constexpr Real longest_step = 0.5;  // 2 over the frequency of the stiffest mode is 0.7
  constexpr int patience = 5;
  Real step = 0.1;
  Real mixing = start_mixing;
  int downhill = 0;
  std::fill(velocity_.begin(), velocity_.end(), Vec3{});
  refresh_near();
  find_forces();
  for (Index n = 0; n < most; ++n, ++steps_) {
    const auto contacts = static_cast<Real>(loads_.pair_contacts + loads_.wall_contacts);
    const bool apart = loads_.largest_overlap <= vanished * mean_diameter_;
    if (apart || loads_.largest_force * contacts <= balance * loads_.overlaps) {
      return true;
    }
    // Power before the kick: after it a hot state, too, looks like a descent.
    Real power = 0;
    for (std::size_t i = 0; i < position_.size(); ++i) {
      power += dot(force_[i], velocity_[i]);
    }
    const Real kept = power > 0 ? 1 : 0;
    Real speed = 0;
    Real force = 0;
    for (std::size_t i = 0; i < position_.size(); ++i) {
      velocity_[i] = kept * velocity_[i] + step * force_[i];
      speed += dot(velocity_[i], velocity_[i]);
      force += dot(force_[i], force_[i]);
    }
    const Real along = mixing * std::sqrt(speed / force);
    for (std::size_t i = 0; i < position_.size(); ++i) {
      velocity_[i] = (1 - mixing) * velocity_[i] + along * force_[i];
      position_[i] += step * velocity_[i];
    }
    downhill = power > 0 ? downhill + 1 : 0;
    if (power <= 0) {
      step *= 0.5;
      mixing = start_mixing;
    } else if (downhill > patience) {
      step = std::min(1.1 * step, longest_step);
      mixing *= 0.99;
    }
    refresh_near();
    find_forces();
  }
  return false;
}

Real Relaxation::mean_overlap() const {
  const auto contacts = static_cast<Real>(loads_.pair_contacts + loads_.wall_contacts);
  return contacts > 0 ? loads_.shares / contacts : 0;
}

Real Relaxation::contacts() const {
  return static_cast<Real>(2 * loads_.pair_contacts + loads_.wall_contacts) /
         static_cast<Real>(position_.size());
}

}  // namespace porefines::dem
