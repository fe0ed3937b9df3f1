// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include "io/fields.hpp"

namespace porefines::io {

/// The HDF5 side of FieldWriter. Layout of the file:
///
///     /                         attributes version, commit, ranks, seed, date, cells, origin_m, spacing_m (x y z)
///     /step_000000              attribute time_s
///     /step_000000/<name>       float32 [nz][ny][nx] or [nz][ny][nx][3]
///
/// Every function opens and closes the file itself and throws RunError on this rank only.

/// Group of a step.
[[nodiscard]] std::string step_group(int step);

/// Makes an empty file. Collective.
void create_fields_file(const std::string& path, MPI_Comm comm, const GridBlock& grid,
                        const Provenance& provenance);

/// Adds one step; a group of that name left by an interrupted write is replaced. Collective.
void append_step(const std::string& path, MPI_Comm comm, const GridBlock& grid,
                 const std::string& group, Real time, std::span<const ScalarField> scalars,
                 std::span<const VectorField> vectors);

/// What the steps up to `time` [s] hold; all later ones are removed from the file. One rank.
/// @throws RunError  also when the file is of a grid with other `cells`
[[nodiscard]] std::vector<FieldStep> keep_steps_until(const std::string& path, const Int3& cells,
                                                      Real time);

}  // namespace porefines::io
