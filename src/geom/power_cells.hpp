// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geom/micromodel.hpp"
#include "geom/round_bodies.hpp"

namespace porefines::geom {

/// Power diagram of random centres with lognormal sizes: the cells from which grains are cut.
///
/// A share of the cells holds no grain (the larger pore bodies); a share of the neighbours is
/// cemented, so that their common border is no channel.
class PowerCells {
 public:
  /// The specification must outlive the cells.
  explicit PowerCells(const MicromodelSpec& spec);

  /// f at a point of the picture [pixels] (formula at make_micromodel); negative in cells without
  /// a grain.
  [[nodiscard]] Real border_distance(Real x, Real y);

 private:
  struct Near {
    std::int32_t cell;
    Real dx, dy;  ///< from the point to the centre
    Real power;   ///< |x - c|^2 - r^2
  };

  void gather(Real x, Real y);
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

}  // namespace porefines::geom
