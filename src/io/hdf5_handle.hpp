// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <hdf5.h>
#include <mpi.h>

#include "core/types.hpp"
#include "io/provenance.hpp"

namespace porefines::io {

/// Stops HDF5 from printing its error stack; failures are reported by RunError instead.
void silence_hdf5();

/// @throws RunError  when `status` is negative: what was being done, and HDF5's own first words
void require_hdf5(herr_t status, std::string_view doing);

/// Owns an HDF5 identifier; closes it at the end of the scope.
class Hdf5 {
 public:
  using Close = herr_t (*)(hid_t);

  /// @throws RunError  when `id` is negative, see require_hdf5
  Hdf5(hid_t id, Close close, std::string_view doing) : id_(id), close_(close) {
    require_hdf5(id < 0 ? -1 : 0, doing);
  }
  Hdf5(Hdf5&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
  Hdf5(const Hdf5&) = delete;
  Hdf5& operator=(const Hdf5&) = delete;
  Hdf5& operator=(Hdf5&&) = delete;
  ~Hdf5() {
    if (id_ >= 0) {
      close_(id_);
    }
  }

  [[nodiscard]] hid_t get() const { return id_; }

  /// Closes now, where a failure (late write) can still be reported.
  void finish(std::string_view doing) { require_hdf5(close_(std::exchange(id_, -1)), doing); }

 private:
  hid_t id_;
  Close close_;
};

/// Attributes of a file, group or dataset. Collective when the file is open in parallel.
void write_attribute(hid_t owner, const std::string& name, const std::string& text);
void write_attribute(hid_t owner, const std::string& name, std::span<const Real> values);
void write_attribute(hid_t owner, const std::string& name, std::span<const Index> values);
void write_attributes(hid_t owner, const Provenance& provenance);
void read_attribute(hid_t owner, const std::string& name, hid_t type, void* value);

/// Properties of a file that all ranks of `comm` open together.
[[nodiscard]] Hdf5 parallel_access(MPI_Comm comm);

}  // namespace porefines::io
