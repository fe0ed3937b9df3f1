// SPDX-License-Identifier: MPL-2.0
#include "core/aligned.hpp"

#include <cstdint>

#include <sys/mman.h>

namespace porefines {
namespace {

constexpr std::size_t page = 4096;

std::size_t in_pages(std::size_t bytes) {
  return (bytes + page - 1) / page * page;
}

}  // namespace

void* map_pages(std::size_t bytes) {
  const std::size_t wanted = in_pages(bytes);
  const std::size_t mapped = wanted + huge_page;
  void* const raw =
      ::mmap(nullptr, mapped, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (raw == MAP_FAILED) {
    throw std::bad_alloc();
  }
  auto* const first = static_cast<std::uint8_t*>(raw);
  const std::size_t before =
      (huge_page - reinterpret_cast<std::uintptr_t>(raw) % huge_page) % huge_page;
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

void unmap_pages(void* memory, std::size_t bytes) {
  ::munmap(memory, in_pages(bytes));
}

}  // namespace porefines
