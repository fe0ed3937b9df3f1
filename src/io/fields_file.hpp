// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include "io/fields.hpp"

namespace porefines::io {

/// The HDF5 side of FieldWriter: one file per step, and an index that makes them look like one.
///
///     fields_000000.h5:/<name>       float32 [nz][ny][nx] or [nz][ny][nx][3]
///     fields_000000.h5:/             attributes time_s, cells, origin_m, spacing_m (x y z),
///                                    version, commit, ranks, seed, date
///     fields.h5:/step_000000         external link to /  of fields_000000.h5
///
/// Each function throws RunError on this rank only.

/// Name of the file of a step.
[[nodiscard]] std::string step_file(int step);

/// Writes a whole step file; the name may be a temporary one. Collective.
void write_step_file(const std::string& path, MPI_Comm comm, const GridBlock& grid, Real time,
                     std::span<const ScalarField> scalars, std::span<const VectorField> vectors,
                     const Provenance& provenance);

/// What a step file holds. One rank.
/// @throws RunError  also when the file is of a grid with other `cells`
[[nodiscard]] FieldStep read_step_file(const std::string& folder, const std::string& name,
                                       const Int3& cells);

/// Replaces the index, whole or not at all. One rank.
void write_index(const std::string& folder, const std::vector<FieldStep>& steps,
                 const Provenance& provenance);

}  // namespace porefines::io
