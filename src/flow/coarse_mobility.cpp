// SPDX-License-Identifier: MPL-2.0
#include "flow/coarse_mobility.hpp"

#include <algorithm>
#include <cmath>

namespace porefines::flow {

namespace {

/// The fine cells around one coarse face, seen along its normal n and the axes a, b across.
class Surroundings {
 public:
  Surroundings(const Level& fine, const std::array<AxisTransfer, 3>& axis, int component,
               const Int3& coarse_face)
      : fine_(fine),
        n_(component),
        across_{(component + 1) % 3, (component + 2) % 3},
        middle_(std::min(axis[component].ratio * coarse_face[component], fine.block.n[component])),
        first_{axis[across_[0]].ratio * coarse_face[across_[0]],
               axis[across_[1]].ratio * coarse_face[across_[1]]} {
    const AxisTransfer& along = axis[component];
    const int I = coarse_face[component];
    middle_weight_ = along.face_middle[I];
    half_ = {along.face_before[I], along.face_after[I]};
    for (int t = 0; t < 2; ++t) {
      const AxisTransfer& side = axis[across_[t]];
      const int J = coarse_face[across_[t]];
      share_[t] = {side.cell_first[J], side.cell_second[J]};
    }
    area_ =
        width(across_[0], first_[0]) * width(across_[1], first_[1]) / (share_[0][0] * share_[1][0]);
    const Real gradient = gradient_at(n_, middle_);
    const bool at_end = divergence_at(n_, middle_ - 1) == 0 || divergence_at(n_, middle_) == 0;
    distance_ = gradient > 0 ? (at_end ? 2 : 1) / (gradient * middle_weight_) : 0;
  }

  /// Mean of W M over the fine faces in the coarse one's plane.
  [[nodiscard]] Real plane_mean() const {
    Real sum = 0;
    for (int q = 0; q < 2; ++q) {
      for (int p = 0; p < 2; ++p) {
        const Real share = share_[0][p] * share_[1][q];
        Int3 face{};
        face[n_] = middle_;
        face[across_[0]] = first_[0] + p;
        face[across_[1]] = first_[1] + q;
        sum += share > 0 ? share * conductivity(n_, face) : 0;
      }
    }
    return sum;
  }

  [[nodiscard]] FaceNetwork network() const {
    FaceNetwork net;
    for (int side = 0; side < 2; ++side) {
      for (int q = 0; q < 2; ++q) {
        for (int p = 0; p < 2; ++p) {
          add_cell(net, side, p, q);
        }
      }
    }
    return net;
  }

  /// Conductance if every column of cells through the face is open: columns side by side, whose
  /// pressures differ too little to matter across. 0 if one is not.
  [[nodiscard]] Real open_columns() const {
    Real total = 0;
    for (int q = 0; q < 2; ++q) {
      for (int p = 0; p < 2; ++p) {
        Int3 face{};
        face[across_[0]] = first_[0] + p;
        face[across_[1]] = first_[1] + q;
        const Real share = share_[0][p] * share_[1][q];
        if (share == 0) {
          continue;
        }
        Real resistance = 0;
        for (int layer = -1; layer <= 1; ++layer) {
          const Real part = layer == 0 ? middle_weight_ : half_[layer < 0 ? 0 : 1];
          const Real k = part > 0 ? conductivity(n_, with(face, n_, middle_ + layer)) : 1;
          if (k <= 0) {
            return 0;
          }
          resistance += part / k;
        }
        total += share / resistance;
      }
    }
    return total;
  }

 private:
  void add_cell(FaceNetwork& net, int side, int p, int q) const {
    const Real share = share_[0][p] * share_[1][q];
    if (share == 0) {
      return;
    }
    const int c = FaceNetwork::cell(side, p, q);
    Int3 cell{};
    cell[n_] = middle_ - 1 + side;
    cell[across_[0]] = first_[0] + p;
    cell[across_[1]] = first_[1] + q;
    const Real through = conductivity(n_, with(cell, n_, middle_)) * share / middle_weight_;
    if (side == 0) {
      net.middle[c] = through;
    }
    const Real outer = conductivity(n_, with(cell, n_, middle_ - 1 + 2 * side)) * share;
    net.outer[c] = half_[side] > 0 ? outer / half_[side] : FaceNetwork::held * through;
    for (int t = 0; t < 2; ++t) {
      const bool upper = (t == 0 ? p : q) == 1;
      const Real low = lateral(t, cell, cell[across_[t]]);
      const Real high = lateral(t, cell, cell[across_[t]] + 1);
      const bool pair = !upper && share_[t][1] > 0;
      net.across[t][c] = pair ? high : 0;
      net.sideways[c] =
          net.sideways[c] || (upper ? high : low) > 0 || (!upper && !pair && high > 0);
    }
  }

  static Int3 with(Int3 cell, int axis, int index) {
    cell[axis] = index;
    return cell;
  }
  [[nodiscard]] Real divergence_at(int t, int i) const {
    return fine_.axis[t].divergence[i + fine_.axis[t].offset];
  }
  [[nodiscard]] Real gradient_at(int t, int i) const {
    return fine_.axis[t].gradient[i + fine_.axis[t].offset];
  }
  /// 1 on a periodic axis of one cell, which has no divergence: it cancels.
  [[nodiscard]] Real width(int t, int i) const {
    const Real divergence = divergence_at(t, i);
    return divergence > 0 ? 1 / divergence : 1;
  }
  [[nodiscard]] Real conductivity(int component, const Int3& face) const {
    return fine_.weighted_mobility(component, fine_.block.at(face[0], face[1], face[2]));
  }
  /// Through face `index` across the normal. A way across the coarse cell passes two halves of it that
  /// belong to different coarse faces: each counts half of the resistance.
  [[nodiscard]] Real lateral(int t, const Int3& cell, int index) const {
    const int axis = across_[t];
    const int other = across_[1 - t];
    const Real k = conductivity(axis, with(cell, axis, index));
    if (k == 0) {
      return 0;
    }
    return 2 * k * width(n_, cell[n_]) * width(other, cell[other]) * gradient_at(axis, index) *
           distance_ / area_;
  }

  const Level& fine_;
  int n_;
  std::array<int, 2> across_;
  int middle_;                ///< fine face in the plane of the coarse one
  std::array<int, 2> first_;  ///< first fine cell along the axes across
  Real middle_weight_ = 1;
  std::array<Real, 2> half_{};                  ///< shares of the outer layers in the distance
  std::array<std::array<Real, 2>, 2> share_{};  ///< of the fine cells in the coarse face's area
  Real area_ = 1;
  Real distance_ = 0;
};

}  // namespace

FaceNetwork network_of(const Level& fine, const std::array<AxisTransfer, 3>& axis, int component,
                       const Int3& coarse_face) {
  return Surroundings(fine, axis, component, coarse_face).network();
}

float coarse_mobility(const Level& fine, const std::array<AxisTransfer, 3>& axis, int component,
                      const Int3& coarse_face) {
  const Surroundings around(fine, axis, component, coarse_face);
  const Real plane = around.plane_mean();
  if (plane == 0) {
    return 0;
  }
  const Real columns = around.open_columns();
  const Real through = columns > 0 ? columns : effective_conductance(around.network());
  return static_cast<float>(std::sqrt(plane * through));
}

}  // namespace porefines::flow
