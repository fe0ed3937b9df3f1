// SPDX-License-Identifier: MPL-2.0
#include "geom/round_bodies.hpp"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::geom {

Real fold(Real x, Real size, Beyond beyond) {
  switch (beyond) {
    case Beyond::periodic:
      return x - size * std::floor(x / size);
    case Beyond::mirror: {
      const Real y = x - 2 * size * std::floor(x / (2 * size));
      return y < size ? y : 2 * size - y;
    }
    case Beyond::pore:
      break;
  }
  return x;
}

namespace {

/// The bodies and those of their periodic images that come within `margin` of the box.
template <int dims>
std::vector<Body> with_images(const std::vector<Body>& bodies, const SampleBox& box, Real margin,
                              std::vector<std::int32_t>& which) {
  std::vector<Body> all = bodies;
  for (int axis = 0; axis < dims; ++axis) {
    if (box.beyond[static_cast<std::size_t>(axis)] != Beyond::periodic) {
      continue;
    }
    const Real size = box.size[axis];
    std::vector<Body> next;
    std::vector<std::int32_t> next_which;
    for (std::size_t b = 0; b < all.size(); ++b) {
      const Body& body = all[b];
      const Real reach = body.radius + margin;
      const Real c = body.centre[axis];
      const int lowest = static_cast<int>(std::ceil((-reach - c) / size));
      const int highest = static_cast<int>(std::floor((size + reach - c) / size));
      for (int shift = lowest; shift <= highest; ++shift) {
        next.push_back(body);
        next.back().centre[axis] = c + shift * size;
        next_which.push_back(which[b]);
      }
    }
    all = std::move(next);
    which = std::move(next_which);
  }
  return all;
}

}  // namespace

template <int dims>
RoundBodies<dims>::RoundBodies(const std::vector<Body>& bodies, const SampleBox& box,
                               bool periodic_images, Real band)
    : box_(box), band_(band), body_(bodies), which_(bodies.size()) {
  std::iota(which_.begin(), which_.end(), 0);
  if (periodic_images) {
    body_ = with_images<dims>(bodies, box, band, which_);
  }
  if (!(band > 0)) {
    throw InputError(fmt::format("distance band of {:.3g} m: it must be positive.", band));
  }
  Real largest = 0;
  Real sum = 0;
  for (const Body& body : body_) {
    largest = std::max(largest, body.radius);
    sum += body.radius;
  }
  const Real mean = body_.empty() ? 0 : sum / static_cast<Real>(body_.size());
  const Real margin = band + 2 * largest;
  Real volume = 1;
  for (int axis = 0; axis < dims; ++axis) {
    volume *= box.size[axis] + 2 * margin;
  }
  const auto most_cells = static_cast<Real>(std::max<std::size_t>(4 * body_.size(), 64));
  cell_ = std::max(mean + band, std::pow(volume / most_cells, 1.0 / dims));
  low_ = Vec3{-margin, -margin, dims == 3 ? -margin : 0};
  for (int axis = 0; axis < dims; ++axis) {
    n_[static_cast<std::size_t>(axis)] =
        1 + static_cast<int>((box.size[axis] + 2 * margin) / cell_);
  }
  first_.assign(static_cast<std::size_t>(product(n_)) + 1, 0);
  for (const Body& body : body_) {
    for_each_cell(body, [&](std::size_t cell) { ++first_[cell + 1]; });
  }
  for (std::size_t cell = 1; cell < first_.size(); ++cell) {
    first_[cell] += first_[cell - 1];
  }
  list_.resize(static_cast<std::size_t>(first_.back()));
  std::vector<Index> next(first_.begin(), first_.end() - 1);
  for (std::size_t b = 0; b < body_.size(); ++b) {
    for_each_cell(body_[b], [&](std::size_t cell) {
      list_[static_cast<std::size_t>(next[cell]++)] = static_cast<std::int32_t>(b);
    });
  }
}

template <int dims>
int RoundBodies<dims>::cell_of(Real x, int axis) const {
  const Real at = (x - low_[axis]) / cell_;
  return at < 0 ? -1 : static_cast<int>(std::min<Real>(at, n_[static_cast<std::size_t>(axis)]));
}

template <int dims>
template <class Visit>
void RoundBodies<dims>::for_each_cell(const Body& body, const Visit& visit) const {
  Int3 low{0, 0, 0};
  Int3 high{0, 0, 0};
  for (int axis = 0; axis < dims; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    low[a] = std::max(cell_of(body.centre[axis] - body.radius - band_, axis), 0);
    high[a] = std::min(cell_of(body.centre[axis] + body.radius + band_, axis), n_[a] - 1);
  }
  for (int k = low[2]; k <= high[2]; ++k) {
    for (int j = low[1]; j <= high[1]; ++j) {
      for (int i = low[0]; i <= high[0]; ++i) {
        visit(static_cast<std::size_t>(i + Index{n_[0]} * (j + Index{n_[1]} * k)));
      }
    }
  }
}

template <int dims>
Real RoundBodies<dims>::signed_distance(const Vec3& x) const {
  Vec3 y = x;
  Int3 cell{0, 0, 0};
  for (int axis = 0; axis < dims; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    y[axis] = fold(x[axis], box_.size[axis], box_.beyond[a]);
    cell[a] = cell_of(y[axis], axis);
    if (cell[a] < 0 || cell[a] >= n_[a]) {
      return band_;
    }
  }
  const auto place =
      static_cast<std::size_t>(cell[0] + Index{n_[0]} * (cell[1] + Index{n_[1]} * cell[2]));
  Real s = band_;
  for (Index entry = first_[place]; entry < first_[place + 1]; ++entry) {
    const Body& body = body_[static_cast<std::size_t>(list_[static_cast<std::size_t>(entry)])];
    Vec3 d = y - body.centre;
    if constexpr (dims == 2) {
      d.z = 0;
    }
    s = std::min(s, norm(d) - body.radius);
  }
  return std::max(s, -band_);
}

template class RoundBodies<2>;
template class RoundBodies<3>;

}  // namespace porefines::geom
