// SPDX-License-Identifier: MPL-2.0
#include "core/aligned.hpp"

#include <atomic>
#include <cstdint>

#include <sys/mman.h>

namespace porefines {
namespace {

constexpr std::size_t line = 64;
constexpr std::size_t page = 4096;
constexpr std::size_t huge_page = std::size_t{2} << 20;
constexpr std::size_t small = 4 * page;  ///< arrays below crowd no cache

/// Where the next array starts after its boundary [bytes]. 167 lines on are 39 on among the 64 sets of a
/// first-level cache: sixteen arrays take sixteen different ones, and neighbours are far apart, so that
/// rows of one do not meet nearby rows of the next. Their pages differ for the second level.
std::size_t next_shift() {
  static std::atomic<unsigned> turn = 0;
  return (turn++ % 16) * 167 * line;
}

std::size_t in_pages(std::size_t bytes) {
  return (bytes + page - 1) / page * page;
}

/// Bytes by which memory lies behind the last boundary of `unit`.
std::size_t beyond(const void* memory, std::size_t unit) {
  return reinterpret_cast<std::uintptr_t>(memory) % unit;
}

/// Aligned to a huge page.
std::uint8_t* map_pages(std::size_t bytes) {
  const std::size_t wanted = in_pages(bytes);
  const std::size_t mapped = wanted + huge_page;
  void* const raw =
      ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) {
    throw std::bad_alloc();
  }
  auto* const first = static_cast<std::uint8_t*>(raw);
  const std::size_t before = (huge_page - beyond(raw, huge_page)) % huge_page;
  std::uint8_t* const memory = first + before;
  if (before > 0) {
    ::munmap(first, before);
  }
  if (before < huge_page) {
    ::munmap(memory + wanted, huge_page - before);
  }
  ::madvise(memory, bytes / huge_page * huge_page, MADV_HUGEPAGE);  // a wish: no matter if it fails
  return memory;
}

}  // namespace

void* allocate_lines(std::size_t bytes) {
  if (bytes < small) {
    return ::operator new (bytes, std::align_val_t{line});
  }
  const std::size_t shift = next_shift();
  if (bytes < huge_page) {
    void* const memory = ::operator new (bytes + page, std::align_val_t{page});
    return static_cast<std::uint8_t*>(memory) + shift % page;
  }
  return map_pages(bytes + shift) + shift;
}

void release_lines(void* memory, std::size_t bytes) {
  if (bytes < small) {
    ::operator delete (memory, std::align_val_t{line});
    return;
  }
  const bool mapped = bytes >= huge_page;
  const std::size_t shift = beyond(memory, mapped ? huge_page : page);
  std::uint8_t* const first = static_cast<std::uint8_t*>(memory) - shift;
  if (mapped) {
    ::munmap(first, in_pages(bytes + shift));
  } else {
    ::operator delete (first, std::align_val_t{page});
  }
}

}  // namespace porefines
