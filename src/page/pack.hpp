// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/types.hpp"

namespace porefines::page {

/// [1.5,null,...]: numbers with seven digits, null for what is not finite.
[[nodiscard]] std::string json_numbers(std::span<const Real> values);

[[nodiscard]] std::string json_strings(std::span<const std::string> texts);

/// A list of values that are JSON already.
[[nodiscard]] std::string json_list(std::span<const std::string> values);

/// Bytes as text for a page: deflated (zlib), then base64. The page inflates them (web/src/data.js).
[[nodiscard]] std::string pack_bytes(std::string_view bytes);

/// Little-endian 16-bit numbers, packed as a JSON string.
[[nodiscard]] std::string pack_numbers(std::span<const std::uint16_t> numbers);

/// What a 16-bit number means: value = low + number (high - low) / 65534; 65535: none.
struct Range16 {
  Real low = 0;
  Real high = 1;

  [[nodiscard]] std::uint16_t code(Real value) const;
};
inline constexpr std::uint16_t none16 = 65535;

/// Smallest and largest finite value; {0, 1} when there is none.
[[nodiscard]] Range16 range_of(std::span<const float> values);

/// Plain base64 with padding (RFC 4648).
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace porefines::page
