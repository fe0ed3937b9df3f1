// SPDX-License-Identifier: MPL-2.0
#include "page/pack.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <zlib.h>

#include "core/error.hpp"
#include "core/json.hpp"

namespace porefines::page {
namespace {

template <typename Values, typename Text>
std::string joined(const Values& values, const Text& text) {
  std::string out = "[";
  for (const auto& value : values) {
    out += out.size() > 1 ? "," : "";
    out += text(value);
  }
  return out + "]";
}

}  // namespace

std::string json_numbers(std::span<const Real> values) {
  return joined(values, [](Real value) {
    return std::isfinite(value) ? fmt::format("{:.7g}", value) : std::string("null");
  });
}

std::string json_strings(std::span<const std::string> texts) {
  return joined(texts, [](const std::string& text) { return json_string(text); });
}

std::string json_list(std::span<const std::string> values) {
  return joined(values, [](const std::string& value) { return value; });
}

std::string base64(std::string_view bytes) {
  constexpr std::string_view letters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  out.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - at);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      three = three << 8U | (k < count ? static_cast<unsigned char>(bytes[at + k]) : 0U);
    }
    for (std::size_t k = 0; k < 4; ++k) {
      out += k <= count ? letters[three >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return out;
}

std::string pack_bytes(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string out(size, '\0');
  const int status = compress2(reinterpret_cast<Bytef*>(out.data()), &size,
                               reinterpret_cast<const Bytef*>(bytes.data()), bytes.size(), 9);
  if (status != Z_OK) {
    throw RunError("the report's data could not be compressed: out of memory");
  }
  out.resize(size);
  return base64(out);
}

std::string pack_numbers(std::span<const std::uint16_t> numbers) {
  std::string bytes;
  bytes.reserve(2 * numbers.size());
  for (const std::uint16_t number : numbers) {
    bytes += static_cast<char>(number & 255U);
    bytes += static_cast<char>(number >> 8U);
  }
  return '"' + pack_bytes(bytes) + '"';
}

std::uint16_t Range16::code(Real value) const {
  if (!std::isfinite(value)) {
    return none16;
  }
  const Real share = high > low ? (value - low) / (high - low) : 0;
  return static_cast<std::uint16_t>(std::lround(std::clamp(share, 0.0, 1.0) * (none16 - 1)));
}

Range16 range_of(std::span<const float> values) {
  Range16 range{INFINITY, -INFINITY};
  for (const float value : values) {
    if (std::isfinite(value)) {
      range.low = std::min<Real>(range.low, value);
      range.high = std::max<Real>(range.high, value);
    }
  }
  return range.low <= range.high ? range : Range16{};
}

}  // namespace porefines::page
