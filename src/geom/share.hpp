// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <memory>
#include <string>

#include <mpi.h>

#include "geom/voxels.hpp"

namespace porefines::geom {

/// A binary volume that all ranks can read: one copy per node where shared memory is available
/// (POSIX shm), else one per rank. Copies of this struct share the memory.
struct SharedVoxels {
  Int3 n{0, 0, 0};
  std::shared_ptr<const std::uint8_t> pore = nullptr;
  std::shared_ptr<const std::uint8_t> share = nullptr;  ///< null where Voxels::share is empty

  [[nodiscard]] VoxelView view() const { return {n, pore.get(), share.get()}; }
};

/// Give the volume of rank 0 to all ranks. Collective; `mine` is ignored elsewhere.
/// Letting go of the result is not collective.
[[nodiscard]] SharedVoxels share(Voxels mine, MPI_Comm communicator);

/// Broadcast of any length (MPI counts are int). Collective.
void broadcast_bytes(void* data, std::size_t bytes, MPI_Comm communicator);

/// Throws InputError(text of rank 0) on every rank when it is not empty. Collective.
void throw_everywhere(const std::string& text, MPI_Comm communicator);

}  // namespace porefines::geom
