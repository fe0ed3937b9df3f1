// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace porefines {

/// Memory on a cache-line boundary. Large arrays come in huge pages, straight from the system and back
/// to it: one page fault per 2 MB instead of 512, and no holes in the heap.
///
/// Arrays that follow each other start at different places of a page: loops over a dozen fields would
/// otherwise want the same few sets of the cache for all of them, and run at half their speed.
/// Throws std::bad_alloc.
[[nodiscard]] void* allocate_lines(std::size_t bytes);
void release_lines(void* memory, std::size_t bytes);

/// Allocates on cache-line boundaries, so that lines of 16 floats are whole vector loads.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) { return static_cast<T*>(allocate_lines(count * sizeof(T))); }
  void deallocate(T* memory, std::size_t count) { release_lines(memory, count * sizeof(T)); }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace porefines
