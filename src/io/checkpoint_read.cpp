// SPDX-License-Identifier: MPL-2.0
#include <array>

#include "core/error.hpp"
#include "io/checkpoint_file.hpp"
#include "io/hdf5_block.hpp"

namespace porefines::io {

struct CheckpointReader::File {
  Hdf5 file;
};

namespace {

Hdf5 open_dataset(hid_t file, const std::string& name, const std::string& path) {
  return {H5Dopen2(file, name.c_str(), H5P_DEFAULT), H5Dclose,
          fmt::format("reading {} of {}", name, path)};
}

Hdf5 space_of(const Hdf5& dataset, const std::string& doing) {
  return {H5Dget_space(dataset.get()), H5Sclose, doing};
}

/// Rows [first, last) of this rank.
struct Share {
  hsize_t first = 0;
  hsize_t last = 0;
};

Share share_of(const Hdf5& dataset, int writers, int rank, int ranks) {
  std::vector<Index> starts(static_cast<std::size_t>(writers) + 1);
  read_attribute(dataset.get(), starts_attribute, H5T_NATIVE_INT64, starts.data());
  const auto start_of = [&](Index r) {
    return static_cast<hsize_t>(starts[static_cast<std::size_t>(r * writers / ranks)]);
  };
  return {start_of(rank), start_of(rank + 1)};
}

void require_type(const Hdf5& dataset, Stored type, const std::string& doing) {
  const Hdf5 found(H5Dget_type(dataset.get()), H5Tclose, doing);
  if (H5Tequal(found.get(), native_type(type)) <= 0) {
    throw RunError(doing + ": it holds numbers of another type");
  }
}

void read_selection(const Hdf5& dataset, Stored type, const BlockSpaces& spaces, void* values,
                    const std::string& doing) {
  require_type(dataset, type, doing);
  if (H5Sget_simple_extent_npoints(spaces.file.get()) == 0) {
    return;
  }
  require_hdf5(H5Dread(dataset.get(), native_type(type), spaces.memory.get(), spaces.file.get(),
                       H5P_DEFAULT, values),
               doing);
}

}  // namespace

CheckpointReader::CheckpointReader(const std::string& folder, int rank, int ranks)
    : rank_(rank), ranks_(ranks) {
  silence_hdf5();
  hid_t file = -1;
  for (int age = 0; age < 10 && file < 0; ++age) {
    path_ = checkpoint_path(folder, age);
    file = H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  }
  if (file < 0) {
    throw InputError(fmt::format(
        "{}: there is no checkpoint that can be read\n"
        "name the folder of the earlier run with -o, or start from the beginning without --restart",
        checkpoint_path(folder, 0)));
  }
  file_ = std::make_unique<File>(File{{file, H5Fclose, path_}});
  Index writers = 0;
  read_attribute(file, writers_attribute, H5T_NATIVE_INT64, &writers);
  writers_ = static_cast<int>(writers);
}

CheckpointReader::~CheckpointReader() = default;

bool CheckpointReader::has(const std::string& name) const {
  return H5Lexists(file_->file.get(), name.c_str(), H5P_DEFAULT) > 0;
}

std::size_t CheckpointReader::count_rows(const std::string& name, int columns) const {
  const Hdf5 dataset = open_dataset(file_->file.get(), name, path_);
  const Share share = share_of(dataset, writers_, rank_, ranks_);
  return (share.last - share.first) * static_cast<std::size_t>(columns);
}

std::size_t CheckpointReader::count_whole(const std::string& name) const {
  const Hdf5 dataset = open_dataset(file_->file.get(), name, path_);
  const Hdf5 space = space_of(dataset, name);
  return static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.get()));
}

void CheckpointReader::read_rows(const std::string& name, Stored type, int columns,
                                 void* values) const {
  const std::string doing = fmt::format("reading {} of {}", name, path_);
  const Hdf5 dataset = open_dataset(file_->file.get(), name, path_);
  const Hdf5 space = space_of(dataset, doing);
  std::array<hsize_t, 2> size{};
  if (H5Sget_simple_extent_ndims(space.get()) != 2 ||
      H5Sget_simple_extent_dims(space.get(), size.data(), nullptr) < 0 ||
      size[1] != static_cast<hsize_t>(columns)) {
    throw RunError(fmt::format("{}: its rows do not have {} columns", doing, columns));
  }
  const Share share = share_of(dataset, writers_, rank_, ranks_);
  read_selection(dataset, type,
                 row_spaces(size[0], share.first, share.last - share.first, columns, doing), values,
                 doing);
}

void CheckpointReader::read_whole(const std::string& name, Stored type, void* values) const {
  const std::string doing = fmt::format("reading {} of {}", name, path_);
  const Hdf5 dataset = open_dataset(file_->file.get(), name, path_);
  const auto count = static_cast<hsize_t>(count_whole(name));
  read_selection(dataset, type, row_spaces(count, 0, count, 1, doing), values, doing);
}

void CheckpointReader::read_block(const std::string& name, Stored type, const GridBlock& grid,
                                  int columns, void* values) const {
  const std::string doing = fmt::format("reading {} of {}", name, path_);
  const Hdf5 dataset = open_dataset(file_->file.get(), name, path_);
  const BlockSpaces spaces = block_spaces(grid, columns, doing);
  const Hdf5 found = space_of(dataset, doing);
  if (H5Sextent_equal(found.get(), spaces.file.get()) <= 0) {
    throw RunError(fmt::format("{}: it is of another grid", doing));
  }
  read_selection(dataset, type, spaces, values, doing);
}

}  // namespace porefines::io
