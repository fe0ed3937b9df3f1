// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <mpi.h>

#include "core/types.hpp"
#include "io/fields.hpp"
#include "io/provenance.hpp"

namespace porefines::io {

/// Numbers that a checkpoint can hold.
enum class Stored { f64, f32, i64, u64, u32, u16, u8 };

template <typename T>
[[nodiscard]] constexpr Stored stored_as() {
  if constexpr (std::floating_point<T>) {
    return sizeof(T) == 8 ? Stored::f64 : Stored::f32;
  } else if constexpr (std::signed_integral<T>) {
    static_assert(sizeof(T) == 8);
    return Stored::i64;
  } else {
    static_assert(std::unsigned_integral<T>);
    return sizeof(T) == 8   ? Stored::u64
           : sizeof(T) == 4 ? Stored::u32
           : sizeof(T) == 2 ? Stored::u16
                            : Stored::u8;
  }
}

/// What a run needs to go on, collected under names before it is written as a whole.
///
/// Every rank puts the same names in the same order. Spans are not copied: they must live until
/// write_checkpoint returns; vectors are taken over.
class Checkpoint {
 public:
  struct Array {
    enum class Kind { rows, whole, block };
    std::string name;
    Kind kind = Kind::rows;
    Stored type = Stored::f64;
    int columns = 1;
    std::span<const std::byte> bytes;
    GridBlock grid;               ///< block
    std::shared_ptr<void> owned;  ///< what `bytes` points into, unless it is the caller's
  };

  /// This rank's rows of a table with so many columns, row by row.
  template <typename T>
  void rows(std::string name, std::span<const T> values, int columns = 1) {
    arrays_.push_back({std::move(name),
                       Array::Kind::rows,
                       stored_as<T>(),
                       columns,
                       std::as_bytes(values),
                       {},
                       {}});
  }
  template <typename T>
  void rows(std::string name, std::vector<T> values, int columns = 1) {
    const auto kept = std::make_shared<std::vector<T>>(std::move(values));
    rows(std::move(name), std::span<const T>(*kept), columns);
    arrays_.back().owned = kept;
  }
  /// The same numbers on every rank: written once.
  template <typename T>
  void whole(std::string name, std::vector<T> values) {
    const auto kept = std::make_shared<std::vector<T>>(std::move(values));
    arrays_.push_back({std::move(name),
                       Array::Kind::whole,
                       stored_as<T>(),
                       1,
                       std::as_bytes(std::span<const T>(*kept)),
                       {},
                       kept});
  }
  void text(std::string name, const std::string& content) {
    whole(std::move(name), std::vector<std::uint8_t>(content.begin(), content.end()));
  }
  /// This rank's cells of a grid, x fastest, `columns` numbers a cell: found again on any number of
  /// ranks, however they cut the grid.
  template <typename T>
  void block(std::string name, const GridBlock& grid, std::span<const T> values, int columns = 1) {
    arrays_.push_back({std::move(name),
                       Array::Kind::block,
                       stored_as<T>(),
                       columns,
                       std::as_bytes(values),
                       grid,
                       {}});
  }
  [[nodiscard]] const std::vector<Array>& arrays() const { return arrays_; }

 private:
  std::vector<Array> arrays_;
};

/// Writes `<folder>/checkpoint.h5`, complete or not at all: under another name, synced to disk, then
/// renamed. The one before becomes checkpoint_1.h5, and so on, `keep` in all. A full disk is found
/// before anything is written, and leaves the earlier ones as they are. Collective.
///
///     /<name>   [rows of all ranks, rank by rank][columns], attribute `starts` [ranks + 1];
///               whole: [count]; block: [nz][ny][nx][columns];
///     /         attributes ranks_that_wrote, version, commit, ranks, seed, date
///
/// @throws RunError  on every rank, with the reason
/// Tests: mpi/checkpoint (1 to 4 ranks, other numbers of ranks, a limit on the file size).
void write_checkpoint(const std::string& folder, int keep, const Checkpoint& checkpoint,
                      Provenance provenance, MPI_Comm comm);

/// Removes the checkpoints in a folder, the unfinished ones too. One rank.
void remove_checkpoints(const std::string& folder);

/// Reads one on this rank alone; nothing here is collective.
class CheckpointReader {
 public:
  /// The newest readable checkpoint of a folder.
  /// @throws InputError  there is none
  explicit CheckpointReader(const std::string& folder, int rank, int ranks);
  ~CheckpointReader();
  CheckpointReader(const CheckpointReader&) = delete;
  CheckpointReader& operator=(const CheckpointReader&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }
  /// Written by as many ranks as read it: rows() gives back what this rank wrote, and a run goes on
  /// bit for bit. Otherwise each rank gets whole ranks' rows, in their order.
  [[nodiscard]] bool same_ranks() const { return writers_ == ranks_; }
  [[nodiscard]] bool has(const std::string& name) const;

  /// @throws RunError  when there is none of this name and type
  template <typename T>
  [[nodiscard]] std::vector<T> rows(const std::string& name, int columns = 1) const {
    std::vector<T> values(count_rows(name, columns));
    read_rows(name, stored_as<T>(), columns, values.data());
    return values;
  }
  template <typename T>
  [[nodiscard]] std::vector<T> whole(const std::string& name) const {
    std::vector<T> values(count_whole(name));
    read_whole(name, stored_as<T>(), values.data());
    return values;
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    const auto bytes = whole<std::uint8_t>(name);
    return {bytes.begin(), bytes.end()};
  }
  template <typename T>
  [[nodiscard]] std::vector<T> block(const std::string& name, const GridBlock& grid,
                                     int columns = 1) const {
    std::vector<T> values(static_cast<std::size_t>(product(grid.cells)) *
                          static_cast<std::size_t>(columns));
    read_block(name, stored_as<T>(), grid, columns, values.data());
    return values;
  }

 private:
  struct File;
  [[nodiscard]] std::size_t count_rows(const std::string& name, int columns) const;
  [[nodiscard]] std::size_t count_whole(const std::string& name) const;
  void read_rows(const std::string& name, Stored type, int columns, void* values) const;
  void read_whole(const std::string& name, Stored type, void* values) const;
  void read_block(const std::string& name, Stored type, const GridBlock& grid, int columns,
                  void* values) const;

  std::string path_;
  std::unique_ptr<File> file_;
  int rank_;
  int ranks_;
  int writers_ = 1;
};

}  // namespace porefines::io
