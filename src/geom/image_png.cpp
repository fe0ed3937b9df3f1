// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <bit>
#include <cmath>
#include <csetjmp>

#include <fmt/format.h>
#include <png.h>

#include "core/error.hpp"
#include "geom/image_codec.hpp"

namespace porefines::geom {

namespace {

constexpr std::array<std::uint8_t, 8> signature{0x89, 'P', 'N', 'G', 0x0D, 0x0A, 0x1A, 0x0A};
constexpr std::size_t header_bytes = 33;  // signature, then the IHDR chunk

std::uint32_t big_endian(const std::uint8_t* p) {
  return (std::uint32_t{p[0]} << 24) | (std::uint32_t{p[1]} << 16) | (std::uint32_t{p[2]} << 8) |
         p[3];
}

struct Source {
  std::span<const std::uint8_t> left;
};

void give_bytes(png_structp png, png_bytep to, png_size_t count) {
  auto& source = *static_cast<Source*>(png_get_io_ptr(png));
  if (count > source.left.size()) {
    png_error(png, "the file ends too early");
  }
  std::copy_n(source.left.begin(), count, to);
  source.left = source.left.subspan(count);
}

[[noreturn]] void leave(png_structp png, png_const_charp) {
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

/// What a picture is made of, once palettes are looked up and bits are at least 8.
struct Layout {
  png_uint_32 width = 0;
  png_uint_32 height = 0;
  int channels = 0;  ///< 1 grey, 2 grey and alpha, 3 colour, 4 colour and alpha
  int depth = 0;     ///< bits of a sample: 8 or 16
};

/// libpng reports errors by longjmp: this frame and the next hold nothing that needs a destructor.
bool read_layout(png_structp png, png_infop info, Layout& layout) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_read_info(png, info);
  png_set_expand(png);
  if constexpr (std::endian::native == std::endian::little) {
    png_set_swap(png);
  }
  png_set_interlace_handling(png);
  png_read_update_info(png, info);
  layout = {png_get_image_width(png, info), png_get_image_height(png, info),
            png_get_channels(png, info), png_get_bit_depth(png, info)};
  return true;
}

bool read_rows(png_structp png, png_bytepp rows) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_read_image(png, rows);
  png_read_end(png, nullptr);
  return true;
}

/// Grey of one picture: luma of ITU-R BT.601 where there is colour; alpha is not looked at.
template <typename Value>
std::vector<Value> to_luma(const std::vector<std::uint8_t>& bytes, const Layout& layout) {
  const auto* const samples = reinterpret_cast<const Value*>(bytes.data());
  std::vector<Value> grey(std::size_t{layout.width} * layout.height);
  for (std::size_t at = 0; at < grey.size(); ++at) {
    const Value* const s = samples + at * static_cast<std::size_t>(layout.channels);
    grey[at] = layout.channels < 3
                   ? s[0]
                   : static_cast<Value>(std::lround(0.299 * s[0] + 0.587 * s[1] + 0.114 * s[2]));
  }
  return grey;
}

/// The picture's bytes, row after row; empty when it cannot be decoded.
std::vector<std::uint8_t> decode(std::span<const std::uint8_t> bytes, Layout& layout) {
  Source source{bytes};
  std::vector<std::uint8_t> out;
  png_structp png = png_create_read_struct(PNG_LIBPNG_VER_STRING, nullptr, leave, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  if (info != nullptr) {
    png_set_read_fn(png, &source, give_bytes);
    if (read_layout(png, info, layout)) {
      const std::size_t stride = png_get_rowbytes(png, info);
      out.resize(stride * layout.height);
      std::vector<png_bytep> rows(layout.height);
      for (std::size_t r = 0; r < rows.size(); ++r) {
        rows[r] = out.data() + r * stride;
      }
      if (!read_rows(png, rows.data())) {
        out.clear();
      }
    }
  }
  png_destroy_read_struct(&png, &info, nullptr);
  return out;
}

}  // namespace

bool looks_like_png(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= signature.size() &&
         std::equal(signature.begin(), signature.end(), bytes.begin());
}

Samples read_png(std::span<const std::uint8_t> bytes, const std::string& name,
                 const ReadLimits& limits) {
  if (bytes.size() < header_bytes || bytes.size() > std::size_t{1} << 30) {
    throw InputError(fmt::format("{}: a PNG of {} bytes cannot be read.\nIs the file complete?",
                                 name, bytes.size()));
  }
  require_reasonable_size(name, big_endian(&bytes[16]), big_endian(&bytes[20]), 1, limits);
  Layout layout;
  const std::vector<std::uint8_t> picture = decode(bytes, layout);
  if (picture.empty()) {
    throw InputError(
        fmt::format("{}: this PNG cannot be decoded; it is corrupt or cut short.\n"
                    "Try opening it in an image viewer and saving it again as 8-bit grey PNG.",
                    name));
  }
  Samples samples{{static_cast<int>(layout.width), static_cast<int>(layout.height), 1}, {}, {}};
  if (layout.depth == 16) {
    samples.wide = to_luma<std::uint16_t>(picture, layout);
  } else {
    samples.narrow = to_luma<std::uint8_t>(picture, layout);
  }
  return samples;
}

}  // namespace porefines::geom
