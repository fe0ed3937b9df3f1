// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <vector>

#include "grid/block.hpp"
#include "par/communicator.hpp"
#include "par/decomposition.hpp"

namespace porefines::grid {

/// Fills the ghosts of a block from its neighbours (or from itself, where periodic and not cut).
///
/// Axis after axis, so that edges and corners are filled too; one message per neighbour and axis,
/// all fields together. Ghosts beyond a non-periodic boundary are left alone: they hold zeros.
class Halo {
 public:
  Halo(const par::Communicator& comm, const par::Decomposition& decomposition, const Block& block,
       const std::array<bool, 3>& periodic);

  /// Fills `depth` ghost layers on low sides and depth + 1 on high sides of every field.
  /// Collective over neighbours; depth must not exceed the block's ghosts.
  void exchange(std::span<float* const> fields, int depth);

  [[nodiscard]] Index messages() const { return messages_; }
  [[nodiscard]] Index bytes() const { return bytes_; }

 private:
  void exchange_axis(std::span<float* const> fields, int axis, int depth);
  void wrap_axis(std::span<float* const> fields, int axis, int depth);

  MPI_Comm comm_;
  Block block_;
  std::array<int, 3> low_{};  ///< neighbour ranks; MPI_PROC_NULL at a boundary
  std::array<int, 3> high_{};
  std::array<bool, 3> wraps_{};  ///< periodic and not cut: a copy within the block
  std::array<std::vector<float>, 4> buffer_;
  Index messages_ = 0;
  Index bytes_ = 0;
};

}  // namespace porefines::grid
