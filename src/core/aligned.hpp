// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace porefines {

/// Memory in huge pages, straight from the system and back to it: one page fault per 2 MB instead of
/// 512, and no holes in the heap. Aligned to a huge page. Throws std::bad_alloc.
[[nodiscard]] void* map_pages(std::size_t bytes);
void unmap_pages(void* memory, std::size_t bytes);
inline constexpr std::size_t huge_page = std::size_t{2} << 20;

/// Allocates on cache-line boundaries, so that lines of 16 floats are whole vector loads.
template <typename T>
struct CacheLineAllocator {
  using value_type = T;
  static constexpr std::align_val_t alignment{64};

  CacheLineAllocator() = default;
  template <typename U>
  explicit CacheLineAllocator(const CacheLineAllocator<U>& /*other*/) {}

  T* allocate(std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    return static_cast<T*>(bytes < huge_page ? ::operator new(bytes, alignment) : map_pages(bytes));
  }
  void deallocate(T* memory, std::size_t count) {
    const std::size_t bytes = count * sizeof(T);
    bytes < huge_page ? ::operator delete(memory, alignment) : unmap_pages(memory, bytes);
  }
  friend bool operator==(const CacheLineAllocator&, const CacheLineAllocator&) { return true; }
};

template <typename T>
using AlignedVector = std::vector<T, CacheLineAllocator<T>>;

}  // namespace porefines
