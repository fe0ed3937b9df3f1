// SPDX-License-Identifier: MPL-2.0
// Any bytes are an image or an InputError. Build with clang and -DPF_FUZZ=ON.
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include "core/error.hpp"
#include "geom/image_read.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr porefines::geom::ReadLimits small{porefines::Index{1} << 20};
  try {
    const auto image = porefines::geom::read_image({data, size}, "fuzz", small);
    if (static_cast<porefines::Index>(image.grey.size()) != porefines::product(image.n)) {
      std::abort();  // sizes must agree with what was read
    }
  } catch (const porefines::InputError&) {
    return 0;  // the only way in which a bad image may end
  }
  return 0;
}
