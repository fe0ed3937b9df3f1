// SPDX-License-Identifier: MPL-2.0
#include "geom/image_write.hpp"

#include <filesystem>
#include <memory>

#include <fmt/format.h>
#include <png.h>
#include <tiffio.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"

namespace porefines::geom {

namespace {

/// Row r from the top of page k, as 0 and 255.
void copy_row(const VoxelView& voxels, int r, int k, std::uint8_t* to) {
  for (int i = 0; i < voxels.n[0]; ++i) {
    to[i] = voxels.at(i, voxels.n[1] - 1 - r, k) ? 255 : 0;
  }
}

void write_png_image(const std::string& path, const VoxelView& voxels) {
  const auto width = static_cast<std::size_t>(voxels.n[0]);
  std::vector<std::uint8_t> pixels(width * static_cast<std::size_t>(voxels.n[1]));
  for (int r = 0; r < voxels.n[1]; ++r) {
    copy_row(voxels, r, 0, pixels.data() + r * width);
  }
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(voxels.n[0]);
  image.height = static_cast<png_uint_32>(voxels.n[1]);
  image.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
  std::string bytes(size, '\0');
  if (png_image_write_to_memory(&image, bytes.data(), &size, 0, pixels.data(), 0, nullptr) == 0) {
    throw RunError("cannot encode " + path + ": " + image.message);
  }
  bytes.resize(size);
  write_file(path, bytes);
}

void write_tiff_image(const std::string& path, const VoxelView& voxels) {
  const std::string part = path + ".part";
  {
    const std::unique_ptr<TIFF, decltype(&TIFFClose)> tiff(TIFFOpen(part.c_str(), "w"), &TIFFClose);
    if (!tiff) {
      throw RunError("cannot write " + path);
    }
    std::vector<std::uint8_t> row(static_cast<std::size_t>(voxels.n[0]));
    for (int k = 0; k < voxels.n[2]; ++k) {
      TIFFSetField(tiff.get(), TIFFTAG_IMAGEWIDTH, voxels.n[0]);
      TIFFSetField(tiff.get(), TIFFTAG_IMAGELENGTH, voxels.n[1]);
      TIFFSetField(tiff.get(), TIFFTAG_BITSPERSAMPLE, 8);
      TIFFSetField(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, 1);
      TIFFSetField(tiff.get(), TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
      TIFFSetField(tiff.get(), TIFFTAG_COMPRESSION, COMPRESSION_LZW);
      TIFFSetField(tiff.get(), TIFFTAG_ROWSPERSTRIP, voxels.n[1]);
      for (int r = 0; r < voxels.n[1]; ++r) {
        copy_row(voxels, r, k, row.data());
        if (TIFFWriteScanline(tiff.get(), row.data(), static_cast<std::uint32_t>(r)) < 0) {
          throw RunError("cannot write " + path + "; is the disk full?");
        }
      }
      TIFFWriteDirectory(tiff.get());
    }
  }
  std::filesystem::rename(part, path);
}

}  // namespace

void write_image(const std::string& path, const VoxelView& voxels) {
  const std::string ending = std::filesystem::path(path).extension().string();
  if (ending == ".tif" || ending == ".tiff") {
    write_tiff_image(path, voxels);
  } else if (ending == ".png" && voxels.n[2] == 1) {
    write_png_image(path, voxels);
  } else {
    throw InputError(fmt::format("{}: images are written as {}.", path,
                                 voxels.n[2] == 1 ? ".png or .tif" : ".tif (a stack of pages)"));
  }
}

}  // namespace porefines::geom
