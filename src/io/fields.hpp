// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include "core/types.hpp"
#include "io/provenance.hpp"
#include "io/xdmf.hpp"

namespace porefines::io {

/// The part of a uniform grid that one rank writes. Blocks of all ranks tile the grid.
struct GridBlock {
  Int3 global_cells{1, 1, 1};  ///< nx, ny, nz of the whole grid; the same on every rank
  Vec3 origin;                 ///< [m] low corner of the whole grid; the same on every rank
  Vec3 spacing{1, 1, 1};       ///< [m] edges of a cell; the same on every rank
  Int3 offset{0, 0, 0};        ///< global index of this rank's first cell
  Int3 cells{1, 1, 1};         ///< this rank's cells; a zero: it has none
};

/// Cell-centred values in SI of this rank's block: x fastest, then y, z; no ghosts.
struct ScalarField {
  std::string name;               ///< letters, digits, _ and -; say the unit in docs, not here
  std::span<const float> values;  ///< nx * ny * nz of the block
};

/// As ScalarField, the three components of a cell side by side.
struct VectorField {
  std::string name;
  std::span<const float> values;  ///< 3 * nx * ny * nz of the block
};

/// Writes time steps of fields: `<folder>/fields.xdmf`, one `fields_NNNNNN.h5` per step, and
/// `fields.h5`, which links to all steps as groups `step_NNNNNN`.
///
/// The XDMF file opens in ParaView and with VTK's XDMF readers. Values are float32, uncompressed:
/// shuffle and deflate halve them but cost twenty times the write (measured on two cores).
/// Every file is written under another name and then renamed, so other programs may read at any
/// time, and neither an interrupted run nor a full disk harms an earlier step.
class FieldWriter {
 public:
  /// Starts a new series; the step files of an earlier one in the folder are removed. Collective over `comm`, which must outlive
  /// the writer. The provenance of rank 0 is written.
  /// @throws RunError  on every rank, when the folder cannot be written
  FieldWriter(std::string folder, MPI_Comm comm, const GridBlock& grid, Provenance provenance);

  /// Continues an earlier run: steps later than `time` [s] are removed, the next write follows the
  /// last one kept. Collective.
  /// @throws RunError  on every rank, when the files there are of another grid or unreadable
  [[nodiscard]] static FieldWriter resume(std::string folder, MPI_Comm comm, const GridBlock& grid,
                                          Provenance provenance, Real time);

  /// Appends one step. Collective: the same time and names in the same order on every rank.
  ///
  /// One collective write per field; every rank writes its own block.
  /// @param time  [s]
  /// @throws RunError  on every rank, on wrong sizes or names, a full disk (found before
  ///                   anything is written), or an HDF5 error with its reason
  void write(Real time, std::span<const ScalarField> scalars, std::span<const VectorField> vectors);

  [[nodiscard]] int steps() const { return count_; }

 private:
  FieldWriter(std::string folder, MPI_Comm comm, const GridBlock& grid, Provenance provenance,
              std::vector<FieldStep> steps, int count);
  void share_date();
  void publish() const;

  std::string folder_;
  MPI_Comm comm_;
  GridBlock grid_;
  Provenance provenance_;
  std::vector<FieldStep> steps_;  ///< on rank 0 only
  int count_ = 0;
};

}  // namespace porefines::io
