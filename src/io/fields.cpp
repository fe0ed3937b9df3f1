// SPDX-License-Identifier: MPL-2.0
#include "io/fields.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

#include <fmt/format.h>

#include "core/error.hpp"
#include "io/agree.hpp"
#include "io/fields_file.hpp"
#include "io/free_space.hpp"
#include "io/hdf5_handle.hpp"
#include "io/replace_file.hpp"

namespace porefines::io {
namespace {

constexpr Index header_bytes = 65536;  ///< generous room for what HDF5 adds to the values

bool is_root(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank == 0;
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

void remove_steps_from(const std::string& folder, int first) {
  for (int step = first; std::filesystem::remove(folder + "/" + step_file(step)); ++step) {
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
  together(comm_, [&] {
    require_block(grid_);
    if (is_root(comm_)) {
      remove_steps_from(folder_, 0);
    }
  });
  share_date();
  publish();
}

FieldWriter FieldWriter::resume(std::string folder, MPI_Comm comm, const GridBlock& grid,
                                Provenance provenance, Real time) {
  silence_hdf5();
  std::vector<FieldStep> steps;
  together(comm, [&] {
    require_block(grid);
    const auto next = [&] { return step_file(static_cast<int>(steps.size())); };
    while (is_root(comm) && std::filesystem::exists(folder + "/" + next())) {
      FieldStep step = read_step_file(folder, next(), grid.global_cells);
      if (!(step.time <= time)) {
        break;
      }
      steps.push_back(std::move(step));
    }
    if (is_root(comm)) {
      remove_steps_from(folder, static_cast<int>(steps.size()));
    }
  });
  int count = static_cast<int>(steps.size());
  MPI_Bcast(&count, 1, MPI_INT, 0, comm);
  FieldWriter writer(std::move(folder), comm, grid, std::move(provenance), std::move(steps), count);
  writer.share_date();
  writer.publish();
  return writer;
}

void FieldWriter::write(Real time, std::span<const ScalarField> scalars,
                        std::span<const VectorField> vectors) {
  const std::string name = step_file(count_);
  const std::string path = folder_ + "/" + name;
  const std::string part = path + ".part";
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
      const Index floats =
          product(grid_.global_cells) * static_cast<Index>(scalars.size() + 3 * vectors.size());
      require_space(part, header_bytes + 4 * floats, "fields",
                    "free some space, or write fields less often");
    }
  });
  together(comm_,
           [&] { write_step_file(part, comm_, grid_, time, scalars, vectors, provenance_); });
  if (is_root(comm_)) {
    FieldStep step{time, name, {}, {}};
    for (const ScalarField& field : scalars) {
      step.scalars.push_back(field.name);
    }
    for (const VectorField& field : vectors) {
      step.vectors.push_back(field.name);
    }
    steps_.push_back(std::move(step));
  }
  together(comm_, [&] {
    if (is_root(comm_)) {
      std::filesystem::rename(part, path);
    }
  });
  ++count_;
  publish();
}

/// HDF5 wants identical attributes from all ranks; dates may differ by a second.
void FieldWriter::share_date() {
  provenance_.date.resize(20, ' ');
  MPI_Bcast(provenance_.date.data(), 20, MPI_CHAR, 0, comm_);
}

void FieldWriter::publish() const {
  together(comm_, [&] {
    if (is_root(comm_)) {
      write_index(folder_, steps_, provenance_);
      replace_file(folder_ + "/fields.xdmf",
                   xdmf_text(grid_.global_cells, grid_.origin, grid_.spacing, steps_, provenance_));
    }
  });
}

}  // namespace porefines::io
