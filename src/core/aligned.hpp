// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace porefines {

/// Allocates on cache-line boundaries, so that lines of 16 floats are whole vector loads. What fills
/// huge pages asks the system for them, and then costs one page fault per 2 MB instead of 512.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::size_t line = 64;
  static constexpr std::size_t huge = std::size_t{2} << 20;

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    void* const memory = ::operator new(bytes, alignment(bytes));
    if (bytes >= huge) {
      ::madvise(memory, bytes / huge * huge, MADV_HUGEPAGE);  // a wish: no matter if it fails
    }
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t count) {
    ::operator delete(memory, alignment(count * sizeof(T)));
  }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }

 private:
  static std::align_val_t alignment(std::size_t bytes) {
    return std::align_val_t{bytes >= huge ? huge : line};
  }
};

template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace porefines
