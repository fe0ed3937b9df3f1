// SPDX-License-Identifier: MPL-2.0
#include <cerrno>
#include <filesystem>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

#include "core/error.hpp"
#include "io/agree.hpp"
#include "io/checkpoint_file.hpp"
#include "io/free_space.hpp"
#include "io/hdf5_block.hpp"

namespace porefines::io {
namespace {

namespace fs = std::filesystem;

constexpr Index bytes_per_name = 4096;  ///< generous room for what HDF5 adds

bool is_root(MPI_Comm comm) {
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  return rank == 0;
}

/// First rows of the ranks' parts and, last, the number of all rows. Collective.
std::vector<Index> starts_of(Index rows, MPI_Comm comm) {
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  std::vector<Index> starts(static_cast<std::size_t>(ranks) + 1, 0);
  MPI_Allgather(&rows, 1, MPI_INT64_T, starts.data() + 1, 1, MPI_INT64_T, comm);
  for (std::size_t r = 1; r < starts.size(); ++r) {
    starts[r] += starts[r - 1];
  }
  return starts;
}

Index width_of(const Checkpoint::Array& array) {
  return static_cast<Index>(H5Tget_size(native_type(array.type))) * array.columns;
}

void write_rows(hid_t file, const Checkpoint::Array& array, MPI_Comm comm) {
  const std::string doing = "writing " + array.name;
  int rank = 0;
  MPI_Comm_rank(comm, &rank);
  const bool here = array.kind == Checkpoint::Array::Kind::rows || rank == 0;
  const Index mine = here ? static_cast<Index>(array.bytes.size()) / width_of(array) : 0;
  const std::vector<Index> starts = starts_of(mine, comm);
  const hid_t type = native_type(array.type);
  const auto first = static_cast<hsize_t>(starts[static_cast<std::size_t>(rank)]);
  write_together(file, array.name, type, type,
                 row_spaces(static_cast<hsize_t>(starts.back()), first, static_cast<hsize_t>(mine),
                            array.columns, doing),
                 array.bytes.data(), doing);
  if (array.kind == Checkpoint::Array::Kind::rows) {
    Hdf5 dataset(H5Dopen2(file, array.name.c_str(), H5P_DEFAULT), H5Dclose, doing);
    write_attribute(dataset.get(), starts_attribute, starts);
    dataset.finish(doing);
  }
}

void write_file_together(const std::string& path, const Checkpoint& checkpoint,
                         const Provenance& provenance, MPI_Comm comm) {
  const Hdf5 access = parallel_access(comm);
  Hdf5 file(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access.get()), H5Fclose,
            "creating " + path);
  write_attributes(file.get(), provenance);
  int ranks = 1;
  MPI_Comm_size(comm, &ranks);
  const Index writers = ranks;
  write_attribute(file.get(), writers_attribute, std::span<const Index>(&writers, 1));
  for (const Checkpoint::Array& array : checkpoint.arrays()) {
    if (array.kind == Checkpoint::Array::Kind::block) {
      const std::string doing = "writing " + array.name;
      const hid_t type = native_type(array.type);
      write_together(file.get(), array.name, type, type,
                     block_spaces(array.grid, array.columns, doing), array.bytes.data(), doing);
    } else {
      write_rows(file.get(), array, comm);
    }
  }
  file.finish("closing " + path);
}

void sync_to_disk(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDWR | O_CLOEXEC);
  // Some file systems cannot sync (EINVAL); that is no reason to lose the file.
  const bool failed = file < 0 || (::fsync(file) != 0 && errno != EINVAL);
  const int failure = failed ? errno : 0;
  if (file >= 0) {
    ::close(file);
  }
  if (failure != 0) {
    throw RunError(
        fmt::format("{}: cannot sync: {}", path, std::generic_category().message(failure)));
  }
}

/// Under every name is a whole checkpoint at every moment: the newest gets its second name before it
/// loses its first.
void take_place(const std::string& folder, const std::string& part, int keep) {
  for (int age = keep - 1; age > 1; --age) {
    if (fs::exists(checkpoint_path(folder, age - 1))) {
      fs::rename(checkpoint_path(folder, age - 1), checkpoint_path(folder, age));
    }
  }
  const std::string newest = checkpoint_path(folder, 0);
  if (keep > 1 && fs::exists(newest)) {
    fs::remove(checkpoint_path(folder, 1));
    std::error_code no_links;  // on such a file system it moves, and is missing for a moment
    fs::create_hard_link(newest, checkpoint_path(folder, 1), no_links);
    if (no_links) {
      fs::rename(newest, checkpoint_path(folder, 1));
    }
  }
  fs::rename(part, newest);
}

}  // namespace

void write_checkpoint(const std::string& folder, int keep, const Checkpoint& checkpoint,
                      Provenance provenance, MPI_Comm comm) {
  silence_hdf5();
  Index bytes = 0;
  for (const Checkpoint::Array& array : checkpoint.arrays()) {
    const bool whole = array.kind == Checkpoint::Array::Kind::whole;
    bytes += whole && !is_root(comm) ? 0 : static_cast<Index>(array.bytes.size());
  }
  MPI_Allreduce(MPI_IN_PLACE, &bytes, 1, MPI_INT64_T, MPI_SUM, comm);
  bytes += bytes_per_name * (1 + static_cast<Index>(checkpoint.arrays().size()));
  provenance.date.resize(20, ' ');  // HDF5 wants identical attributes from all ranks
  MPI_Bcast(provenance.date.data(), 20, MPI_CHAR, 0, comm);
  const std::string part = checkpoint_path(folder, 0) + ".part";
  together(comm, [&] {
    if (is_root(comm)) {
      require_space(part, bytes, "a checkpoint", "free some space, or lower [checkpoint] keep");
    }
  });
  together(comm, [&] { write_file_together(part, checkpoint, provenance, comm); });
  together(comm, [&] {
    if (is_root(comm)) {
      sync_to_disk(part);
      take_place(folder, part, keep);
    }
  });
}

void remove_checkpoints(const std::string& folder) {
  fs::remove(checkpoint_path(folder, 0) + ".part");
  for (int age = 0; fs::remove(checkpoint_path(folder, age)) || age == 0; ++age) {
  }
}

}  // namespace porefines::io
