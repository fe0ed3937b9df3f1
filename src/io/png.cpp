// SPDX-License-Identifier: MPL-2.0
#include "io/png.hpp"

#include <csetjmp>
#include <new>
#include <string_view>

#include <fmt/format.h>
#include <png.h>

#include "core/error.hpp"
#include "io/replace_file.hpp"

namespace porefines::io {
namespace {

void append_bytes(png_structp png, png_bytep bytes, png_size_t count) {
  auto& out = *static_cast<std::string*>(png_get_io_ptr(png));
  bool appended = false;
  try {  // nothing may be thrown through libpng's C frames
    out.append(reinterpret_cast<const char*>(bytes), count);
    appended = true;
  } catch (const std::bad_alloc&) {
  }
  if (!appended) {
    png_error(png, "out of memory");
  }
}
void keep_message(png_structp png, png_const_charp message) {
  auto* kept = static_cast<std::string*>(png_get_error_ptr(png));
  *kept = message;
  png_longjmp(png, 1);
}
void ignore_warning(png_structp, png_const_charp) {}

/// libpng reports errors by longjmp: this frame holds nothing that would need a destructor.
bool encode(png_structp png, png_infop info, const PixelView& picture, png_textp texts, int count) {
  if (setjmp(png_jmpbuf(png)) != 0) {
    return false;
  }
  png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width),
               static_cast<png_uint_32>(picture.height), 8,
               picture.channels == 1 ? PNG_COLOR_TYPE_GRAY : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
               PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_text(png, info, texts, count);
  png_write_info(png, info);
  const auto stride = static_cast<std::size_t>(picture.width) * picture.channels;
  for (int row = 0; row < picture.height; ++row) {
    png_write_row(png, picture.pixels.data() + row * stride);
  }
  png_write_end(png, nullptr);
  return true;
}

png_text text_chunk(const char* key, std::string& value) {
  png_text text{};
  text.compression = PNG_TEXT_COMPRESSION_NONE;
  text.key = const_cast<char*>(key);
  text.text = value.data();
  text.text_length = value.size();
  return text;
}

}  // namespace

void write_png(const std::string& path, const PixelView& picture, const Provenance& provenance,
               const std::string& title) {
  const bool fits = picture.width > 0 && picture.height > 0 &&
                    (picture.channels == 1 || picture.channels == 3) &&
                    picture.pixels.size() ==
                        static_cast<std::size_t>(picture.width) * picture.height * picture.channels;
  if (!fits) {
    throw RunError(fmt::format("{}: {} bytes are not a picture of {} x {} pixels in {} channels",
                               path, picture.pixels.size(), picture.width, picture.height,
                               picture.channels));
  }
  std::string bytes;
  std::string message = "out of memory";
  std::string software = describe(provenance);
  std::string comment = title;
  png_text texts[] = {text_chunk("Software", software), text_chunk("Comment", comment)};

  png_structp png =
      png_create_write_struct(PNG_LIBPNG_VER_STRING, &message, keep_message, ignore_warning);
  png_infop info = png != nullptr ? png_create_info_struct(png) : nullptr;
  bool encoded = false;
  if (info != nullptr) {
    png_set_write_fn(png, &bytes, append_bytes, nullptr);
    encoded = encode(png, info, picture, texts, title.empty() ? 1 : 2);
  }
  png_destroy_write_struct(&png, &info);
  if (!encoded) {
    throw RunError(fmt::format("{}: cannot encode the picture: {}", path, message));
  }
  replace_file(path, bytes);
}

}  // namespace porefines::io
