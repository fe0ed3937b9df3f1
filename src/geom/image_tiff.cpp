// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <tiffio.h>

#include "core/error.hpp"
#include "geom/image_codec.hpp"

namespace porefines::geom {

namespace {

// libtiff reports through a global handler; the last message of this thread goes into our error.
std::string& last_message() {
  static thread_local std::string text;
  return text;
}

void keep_message(const char* /*module*/, const char* format, va_list arguments) {
  std::array<char, 300> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  last_message() = text.data();
}

void silence_libtiff() {
  TIFFSetErrorHandler(keep_message);
  TIFFSetWarningHandler(nullptr);
  last_message().clear();
}

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

[[noreturn]] void fail(const std::string& name, const std::string& what,
                       const std::string& advice) {
  const std::string said = last_message().empty() ? "" : " (" + last_message() + ")";
  throw InputError(fmt::format("{}: {}{}.\n{}", name, what, said, advice));
}

const char* const save_again = "Save it again as an 8-bit grey TIFF without compression.";

/// What has to be known of a page before its pixels are read.
struct Page {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;
  std::uint16_t channels = 1;
  std::uint16_t kind = SAMPLEFORMAT_UINT;
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t planar = PLANARCONFIG_CONTIG;
};

Page describe(TIFF* tiff, const std::string& name) {
  Page page;
  TIFFGetField(tiff, TIFFTAG_IMAGEWIDTH, &page.width);
  TIFFGetField(tiff, TIFFTAG_IMAGELENGTH, &page.height);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_BITSPERSAMPLE, &page.bits);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLESPERPIXEL, &page.channels);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_SAMPLEFORMAT, &page.kind);
  TIFFGetFieldDefaulted(tiff, TIFFTAG_PLANARCONFIG, &page.planar);
  TIFFGetField(tiff, TIFFTAG_PHOTOMETRIC, &page.photometric);
  if (page.kind == SAMPLEFORMAT_IEEEFP || page.bits > 16) {
    fail(name,
         fmt::format("{}-bit {} pixels are not supported", page.bits,
                     page.kind == SAMPLEFORMAT_IEEEFP ? "floating-point" : "integer"),
         "Convert the image to 8 or 16 bits per pixel (ImageJ: Image > Type > 8-bit).");
  }
  constexpr int most_channels = 8;
  if (page.channels < 1 || page.channels > most_channels) {
    fail(name, fmt::format("{} channels per pixel", page.channels),
         "An image has one (grey), three (colour) or four (colour and alpha); is it corrupt?");
  }
  return page;
}

/// libtiff takes memory for whole strips or tiles: refuse absurd ones before it tries.
void require_reasonable_blocks(TIFF* tiff, const std::string& name, const ReadLimits& limits) {
  const std::uint64_t block = TIFFIsTiled(tiff) != 0 ? TIFFTileSize64(tiff) : TIFFStripSize64(tiff);
  if (block == 0 || block / 16 > static_cast<std::uint64_t>(limits.max_voxels)) {
    fail(name, fmt::format("strips or tiles of {} bytes", block), "Is it corrupt?");
  }
}

/// Rows of 1, 8 or 16 bits and one channel: read as they are.
bool is_plain(TIFF* tiff, const Page& page) {
  return TIFFIsTiled(tiff) == 0 && page.channels == 1 &&
         (page.bits == 1 || page.bits == 8 || page.bits == 16) &&
         (page.photometric == PHOTOMETRIC_MINISBLACK || page.photometric == PHOTOMETRIC_MINISWHITE);
}

void read_plain(TIFF* tiff, const Page& page, const std::string& name, Samples& out) {
  const bool inverted = page.photometric == PHOTOMETRIC_MINISWHITE;
  std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize64(tiff)));
  const std::size_t needed = (std::size_t{page.width} * page.bits + 7) / 8;
  if (row.size() < needed) {
    fail(name, "the rows are shorter than the image is wide", save_again);
  }
  for (std::uint32_t y = 0; y < page.height; ++y) {
    if (TIFFReadScanline(tiff, row.data(), y) < 0) {
      fail(name, fmt::format("row {} of {} cannot be read", y, page.height), save_again);
    }
    for (std::uint32_t x = 0; x < page.width; ++x) {
      if (page.bits == 16) {
        std::uint16_t value = 0;
        std::memcpy(&value, &row[2 * std::size_t{x}], 2);
        out.wide.push_back(inverted ? static_cast<std::uint16_t>(65535 - value) : value);
      } else {
        const unsigned value = page.bits == 8 ? row[x] : (row[x / 8] >> (7 - x % 8) & 1U) * 255U;
        out.narrow.push_back(static_cast<std::uint8_t>(inverted ? 255 - value : value));
      }
    }
  }
}

/// Everything else (colour, palettes, tiles) through libtiff's own conversion to RGBA.
void read_converted(TIFF* tiff, const Page& page, const std::string& name, Samples& out) {
  std::vector<std::uint32_t> rgba(std::size_t{page.width} * page.height);
  if (TIFFReadRGBAImageOriented(tiff, page.width, page.height, rgba.data(), ORIENTATION_TOPLEFT,
                                1) == 0) {
    fail(name, "the pixels cannot be read", save_again);
  }
  for (const std::uint32_t value : rgba) {
    const unsigned grey =
        (299 * TIFFGetR(value) + 587 * TIFFGetG(value) + 114 * TIFFGetB(value) + 500) / 1000;
    out.narrow.push_back(static_cast<std::uint8_t>(grey));
  }
}

Samples read_pages(TIFF* tiff, const std::string& name, const ReadLimits& limits) {
  const Page first = describe(tiff, name);
  const bool plain = is_plain(tiff, first);
  const auto pages = static_cast<int>(TIFFNumberOfDirectories(tiff));
  require_reasonable_size(name, first.width, first.height, pages, limits);
  Samples out{{static_cast<int>(first.width), static_cast<int>(first.height), pages}, {}, {}};
  const auto count = static_cast<std::size_t>(product(out.n));
  (plain && first.bits == 16 ? out.wide.reserve(count) : out.narrow.reserve(count));
  for (int z = 0; z < pages; ++z) {
    if (TIFFSetDirectory(tiff, static_cast<tdir_t>(z)) == 0) {
      fail(name, fmt::format("page {} of {} cannot be read", z + 1, pages), save_again);
    }
    const Page page = describe(tiff, name);
    if (page.width != first.width || page.height != first.height || page.bits != first.bits ||
        is_plain(tiff, page) != plain) {
      fail(name,
           fmt::format("page {} is {}x{} with {} bits, but page 1 is {}x{} with {} bits", z + 1,
                       page.width, page.height, page.bits, first.width, first.height, first.bits),
           "All pages of a 3D image must be alike; previews and thumbnails must be removed.");
    }
    require_reasonable_blocks(tiff, name, limits);
    if (plain) {
      read_plain(tiff, page, name, out);
    } else {
      read_converted(tiff, page, name, out);
    }
  }
  return out;
}

/// A file in memory, as libtiff's callbacks see it.
struct Memory {
  std::span<const std::uint8_t> bytes;
  std::uint64_t position = 0;
};

tmsize_t read_memory(thandle_t handle, void* buffer, tmsize_t size) {
  auto* memory = static_cast<Memory*>(handle);
  const std::uint64_t left =
      memory->position < memory->bytes.size() ? memory->bytes.size() - memory->position : 0;
  const auto count = std::min<std::uint64_t>(left, static_cast<std::uint64_t>(size));
  if (count > 0) {
    std::memcpy(buffer, memory->bytes.data() + memory->position, count);
  }
  memory->position += count;
  return static_cast<tmsize_t>(count);
}

toff_t seek_memory(thandle_t handle, toff_t offset, int whence) {
  auto* memory = static_cast<Memory*>(handle);
  const std::uint64_t base = whence == SEEK_SET   ? 0
                             : whence == SEEK_CUR ? memory->position
                                                  : memory->bytes.size();
  return memory->position = base + offset;
}

}  // namespace

bool looks_like_tiff(std::span<const std::uint8_t> bytes) {
  return bytes.size() >= 4 && ((bytes[0] == 'I' && bytes[1] == 'I' && bytes[3] == 0) ||
                               (bytes[0] == 'M' && bytes[1] == 'M' && bytes[2] == 0));
}

Samples read_tiff_file(const std::string& path, const ReadLimits& limits) {
  silence_libtiff();
  const Tiff tiff(TIFFOpen(path.c_str(), "r"), &TIFFClose);
  if (!tiff) {
    fail(path, "this TIFF cannot be opened", "Is the file complete?");
  }
  return read_pages(tiff.get(), path, limits);
}

Samples read_tiff(std::span<const std::uint8_t> bytes, const std::string& name,
                  const ReadLimits& limits) {
  silence_libtiff();
  Memory memory{bytes, 0};
  const Tiff tiff(
      TIFFClientOpen(
          name.c_str(), "rm", &memory, read_memory,
          [](thandle_t, void*, tmsize_t) -> tmsize_t { return 0; }, seek_memory,
          [](thandle_t) { return 0; },
          [](thandle_t handle) -> toff_t { return static_cast<Memory*>(handle)->bytes.size(); },
          [](thandle_t, void**, toff_t*) { return 0; }, [](thandle_t, void*, toff_t) {}),
      &TIFFClose);
  if (!tiff) {
    fail(name, "this TIFF cannot be opened", "Is the file complete?");
  }
  return read_pages(tiff.get(), name, limits);
}

}  // namespace porefines::geom
