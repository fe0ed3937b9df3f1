// SPDX-License-Identifier: MPL-2.0
#include "page/pictures.hpp"

#include <algorithm>
#include <cstdint>

#include <png.h>

#include "page/pack.hpp"

namespace porefines::page {
namespace {

struct Rgb8 {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bytes;
};

Rgb8 read(const std::string& path) {
  Rgb8 out;
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    return out;
  }
  image.format = PNG_FORMAT_RGB;
  std::vector<std::uint8_t> bytes(PNG_IMAGE_SIZE(image));
  const auto width = static_cast<int>(image.width);
  const auto height = static_cast<int>(image.height);
  if (png_image_finish_read(&image, nullptr, bytes.data(), 0, nullptr) != 0) {
    out = {width, height, std::move(bytes)};
  }
  return out;
}

/// Mean of two by two pixels; an odd row or column at the end is dropped.
Rgb8 halved(const Rgb8& from) {
  Rgb8 out{from.width / 2, from.height / 2, {}};
  for (int y = 0; y < out.height; ++y) {
    for (int x = 0; x < out.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int dx, int dy) {
          return from
              .bytes[static_cast<std::size_t>(3 * ((2 * y + dy) * from.width + 2 * x + dx) + c)];
        };
        out.bytes.push_back(
            static_cast<std::uint8_t>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
      }
    }
  }
  return out;
}

std::string encode(const Rgb8& picture) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(picture.width);
  image.height = static_cast<png_uint_32>(picture.height);
  image.format = PNG_FORMAT_RGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  const int done =
      png_image_write_to_memory(&image, bytes.data(), &size, 0, picture.bytes.data(), 0, nullptr);
  bytes.resize(done != 0 ? size : 0);
  return bytes;
}

}  // namespace

std::string picture_address(const std::string& path, int longest) {
  Rgb8 picture = read(path);
  while (std::max(picture.width, picture.height) > longest) {
    picture = halved(picture);
  }
  return picture.bytes.empty() ? "" : "data:image/png;base64," + base64(encode(picture));
}

}  // namespace porefines::page
