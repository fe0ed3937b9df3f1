// SPDX-License-Identifier: MPL-2.0
#include "io/fields.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/agree.hpp"
#include "io/fields_file.hpp"
#include "io/hdf5_handle.hpp"
#include "io/replace_file.hpp"

namespace porefines::io {
namespace {

std::string hdf5_path(const std::string& folder) {
  return folder + "/fields.h5";
}

bool is_root(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank == 0;
}

/// Runs `act` and turns a failure on any rank into one on all.
template <class Act>
void together(MPI_Comm comm, Act act) {
  std::string failure;
  try {
    act();
  } catch (const std::exception& error) {
    failure = error.what();
  }
  throw_everywhere(comm, failure);
}

void require_plain_name(const std::string& name) {
  const bool plain = !name.empty() && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c < 128 && std::isalnum(c) != 0) || c == '_' || c == '-';
  });
  if (!plain) {
    throw RunError(
        fmt::format("field name '{}': only letters, digits, _ and - are possible", name));
  }
}

void require_size(const std::string& name, std::size_t found, const GridBlock& grid,
                  int components) {
  const auto wanted = static_cast<std::size_t>(product(grid.cells) * components);
  if (found != wanted) {
    throw RunError(fmt::format("field {}: {} values for a block of {} x {} x {} cells, wanted {}",
                               name, found, grid.cells[0], grid.cells[1], grid.cells[2], wanted));
  }
}

void require_block(const GridBlock& grid) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool inside = grid.offset[axis] >= 0 && grid.cells[axis] >= 0 &&
                        grid.offset[axis] + grid.cells[axis] <= grid.global_cells[axis];
    if (!inside || grid.global_cells[axis] < 1 || !(grid.spacing[axis] > 0)) {
      throw RunError(fmt::format(
          "fields: along axis {} a block of {} cells from {} in a grid of {} cells of {} m",
          "xyz"[axis], grid.cells[axis], grid.offset[axis], grid.global_cells[axis],
          grid.spacing[axis]));
    }
  }
}

/// A full disk is better found before a step is half written.
void require_space(const std::string& folder, Real bytes) {
  std::error_code unknown;
  const auto space = std::filesystem::space(folder, unknown);
  if (!unknown && static_cast<Real>(space.available) < bytes) {
    throw RunError(
        fmt::format("{}: the disk is full: {:.1f} MB needed for the next fields, {:.1f} MB "
                    "free; free some space, or write fields less often",
                    folder, bytes / 1e6, static_cast<Real>(space.available) / 1e6));
  }
}

}  // namespace

FieldWriter::FieldWriter(std::string folder, MPI_Comm comm, const GridBlock& grid,
                         Provenance provenance, std::vector<FieldStep> steps, int count)
    : folder_(std::move(folder)),
      comm_(comm),
      grid_(grid),
      provenance_(std::move(provenance)),
      steps_(std::move(steps)),
      count_(count) {}

FieldWriter::FieldWriter(std::string folder, MPI_Comm comm, const GridBlock& grid,
                         Provenance provenance)
    : FieldWriter(std::move(folder), comm, grid, std::move(provenance), {}, 0) {
  silence_hdf5();
  together(comm_, [&] { require_block(grid_); });
  // HDF5 wants identical attributes from all ranks; dates may differ by a second.
  provenance_.date.resize(20, ' ');
  MPI_Bcast(provenance_.date.data(), 20, MPI_CHAR, 0, comm_);
  together(comm_, [&] { create_fields_file(hdf5_path(folder_), comm_, grid_, provenance_); });
  publish();
}

FieldWriter FieldWriter::resume(std::string folder, MPI_Comm comm, const GridBlock& grid,
                                Provenance provenance, Real time) {
  silence_hdf5();
  std::vector<FieldStep> steps;
  int count = -1;
  together(comm, [&] {
    require_block(grid);
    if (is_root(comm) && std::filesystem::exists(hdf5_path(folder))) {
      steps = keep_steps_until(hdf5_path(folder), grid.global_cells, time);
      count = static_cast<int>(steps.size());
    }
  });
  MPI_Bcast(&count, 1, MPI_INT, 0, comm);
  if (count < 0) {
    return {std::move(folder), comm, grid, std::move(provenance)};
  }
  FieldWriter writer(std::move(folder), comm, grid, std::move(provenance), std::move(steps), count);
  writer.publish();
  return writer;
}

void FieldWriter::write(Real time, std::span<const ScalarField> scalars,
                        std::span<const VectorField> vectors) {
  together(comm_, [&] {
    for (const ScalarField& field : scalars) {
      require_plain_name(field.name);
      require_size(field.name, field.values.size(), grid_, 1);
    }
    for (const VectorField& field : vectors) {
      require_plain_name(field.name);
      require_size(field.name, field.values.size(), grid_, 3);
    }
    if (is_root(comm_)) {
      const auto floats = static_cast<Real>(product(grid_.global_cells)) *
                          static_cast<Real>(scalars.size() + 3 * vectors.size());
      require_space(folder_, sizeof(float) * floats);
    }
  });
  const std::string group = step_group(count_);
  together(comm_,
           [&] { append_step(hdf5_path(folder_), comm_, grid_, group, time, scalars, vectors); });
  if (is_root(comm_)) {
    FieldStep step{time, group, {}, {}};
    for (const ScalarField& field : scalars) {
      step.scalars.push_back(field.name);
    }
    for (const VectorField& field : vectors) {
      step.vectors.push_back(field.name);
    }
    steps_.push_back(std::move(step));
  }
  ++count_;
  publish();
}

void FieldWriter::publish() const {
  together(comm_, [&] {
    if (is_root(comm_)) {
      replace_file(folder_ + "/fields.xdmf",
                   xdmf_text(grid_.global_cells, grid_.origin, grid_.spacing, "fields.h5", steps_,
                             provenance_));
    }
  });
}

}  // namespace porefines::io
