// SPDX-License-Identifier: MPL-2.0
#include "geom/blur.hpp"

#include <numeric>

#include "geom/voxels.hpp"

namespace porefines::geom {

std::vector<int> gaussian_weights(Real sigma) {
  const int r = static_cast<int>(std::ceil(4 * sigma));
  const int width = 2 * r + 1;
  std::vector<Real> exact(static_cast<std::size_t>(width));
  for (int k = -r; k <= r; ++k) {
    exact[static_cast<std::size_t>(k + r)] = std::exp(-0.5 * (k / sigma) * (k / sigma));
  }
  const Real sum = std::accumulate(exact.begin(), exact.end(), Real{0});
  std::vector<int> weights;
  weights.reserve(exact.size());
  for (const Real value : exact) {
    weights.push_back(static_cast<int>(std::lround(blur_one * value / sum)));
  }
  weights[static_cast<std::size_t>(r)] +=
      blur_one - std::accumulate(weights.begin(), weights.end(), 0);
  return weights;
}

namespace {

/// out[x] = sum_k w_k in[x + k * stride], over rows of `count` values; `scale` brings the sum
/// back to 0..blur_one.
template <class Value>
void blur_row(const Value* in, Index stride, int count, const std::vector<int>& weights, int shift,
              std::vector<std::int32_t>& sum, std::uint16_t* out) {
  std::fill(sum.begin(), sum.end(), shift > 0 ? 1 << (shift - 1) : 0);
  for (std::size_t k = 0; k < weights.size(); ++k) {
    const Value* shifted = in + static_cast<Index>(k) * stride;
    const int w = weights[k];
    for (int x = 0; x < count; ++x) {
      sum[static_cast<std::size_t>(x)] += w * static_cast<std::int32_t>(shifted[x]);
    }
  }
  for (int x = 0; x < count; ++x) {
    out[x] = static_cast<std::uint16_t>(sum[static_cast<std::size_t>(x)] >> shift);
  }
}

/// One pass along `axis`; n shrinks by 2r there.
template <class Value>
std::vector<std::uint16_t> pass(const std::vector<Value>& in, Int3& n, int axis,
                                const std::vector<int>& weights, int shift) {
  Int3 m = n;
  m[axis] -= static_cast<int>(weights.size()) - 1;
  const std::array<Index, 3> stride{1, n[0], Index{n[0]} * n[1]};
  std::vector<std::uint16_t> out(static_cast<std::size_t>(product(m)));
  std::vector<std::int32_t> sum(static_cast<std::size_t>(m[0]));
  for (int k = 0; k < m[2]; ++k) {
    for (int j = 0; j < m[1]; ++j) {
      blur_row(&in[static_cast<std::size_t>(j * stride[1] + k * stride[2])], stride[axis], m[0],
               weights, shift, sum,
               &out[static_cast<std::size_t>(Index{m[0]} * (j + Index{m[1]} * k))]);
    }
  }
  n = m;
  return out;
}

}  // namespace

std::vector<std::uint16_t> blur(const std::vector<std::uint8_t>& share, Int3& n,
                                const std::vector<int>& weights) {
  constexpr int shift = 15;
  const bool flat = n[2] == 1;
  constexpr int full = 7;
  static_assert(1 << full == full_share);
  auto phi = pass(share, n, 0, weights, full);
  phi = pass(phi, n, 1, weights, shift);
  return flat ? phi : pass(phi, n, 2, weights, shift);
}

}  // namespace porefines::geom
