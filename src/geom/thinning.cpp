// SPDX-License-Identifier: MPL-2.0
#include "geom/thinning.hpp"

#include <algorithm>

#include "geom/neighbours.hpp"
#include "geom/simple_point.hpp"

namespace porefines::geom {

namespace {

/// Voxels waiting to be tried, the shallowest first; first in, first out within a depth, so that
/// lines stay in the middle.
class Queue {
 public:
  void push(Index v, int square) {
    const auto level = static_cast<std::size_t>(square);
    if (level >= bucket_.size()) {
      bucket_.resize(level + 1);
      head_.resize(level + 1, 0);
    }
    bucket_[level].push_back(v);
    lowest_ = std::min(lowest_, level);
  }

  /// The next voxel; -1 when there is none.
  Index pop() {
    for (; lowest_ < bucket_.size(); ++lowest_) {
      if (head_[lowest_] < bucket_[lowest_].size()) {
        return bucket_[lowest_][head_[lowest_]++];
      }
      bucket_[lowest_].clear();
      head_[lowest_] = 0;
    }
    return -1;
  }

 private:
  std::vector<std::vector<Index>> bucket_;  ///< by squared distance
  std::vector<std::size_t> head_;
  std::size_t lowest_ = 0;
};

/// Pore left around voxel v; outside a face that is not periodic there is none.
Neighbourhood look_around(const Int3& n, const Surroundings& beyond,
                          const std::vector<std::uint8_t>& left, Index v) {
  const Int3 x = position(n, v);
  Neighbourhood around{};
  for (int a = n[2] == 1 ? 9 : 0; a < (n[2] == 1 ? 18 : 27); ++a) {
    const Int3 y{x[0] + a % 3 - 1, x[1] + a / 3 % 3 - 1, x[2] + a / 9 - 1};
    Int3 w{};
    bool inside = true;
    for (std::size_t t = 0; t < 3; ++t) {
      inside = inside && (beyond[t] == Beyond::periodic || (y[t] >= 0 && y[t] < n[t]));
      w[t] = (y[t] + n[t]) % n[t];
    }
    around[static_cast<std::size_t>(a)] =
        inside ? left[static_cast<std::size_t>(voxel_index(n, w[0], w[1], w[2]))] : 0;
  }
  return around;
}

}  // namespace

std::vector<std::uint8_t> thin(const VoxelView& image, const Surroundings& beyond,
                               const std::vector<int>& depth,
                               const std::vector<std::uint8_t>& anchor) {
  const Int3 n = image.n;
  std::vector<std::uint8_t> left(image.pore, image.pore + product(n));
  Queue queue;
  const auto push = [&](Index v) {
    const auto u = static_cast<std::size_t>(v);
    if (left[u] != 0 && anchor[u] == 0) {
      queue.push(v, depth[u]);
    }
  };
  for (Index v = 0; v < product(n); ++v) {
    push(v);
  }
  const std::array<bool, 3> periodic{beyond[0] == Beyond::periodic, beyond[1] == Beyond::periodic,
                                     beyond[2] == Beyond::periodic};
  const Neighbours neighbours(n, periodic, true);
  for (Index v = queue.pop(); v >= 0; v = queue.pop()) {
    const auto u = static_cast<std::size_t>(v);
    if (left[u] != 0 && is_simple(look_around(n, beyond, left, v), n[2] == 1)) {
      left[u] = 0;
      neighbours.visit(v, push);  // what was not simple may be now
    }
  }
  return left;
}

}  // namespace porefines::geom
