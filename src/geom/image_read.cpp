// SPDX-License-Identifier: MPL-2.0
#include "geom/image_read.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geom/image_codec.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

namespace fs = std::filesystem;

namespace {

std::vector<std::uint8_t> read_bytes(const fs::path& path, std::size_t most) {
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    throw InputError(
        fmt::format("{}: the file cannot be opened.\nCheck its permissions.", path.string()));
  }
  const auto size = std::min<std::uintmax_t>(fs::file_size(path), most);
  std::vector<std::uint8_t> bytes(size);
  file.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  bytes.resize(static_cast<std::size_t>(std::max<std::streamsize>(file.gcount(), 0)));
  return bytes;
}

void require_exists(const std::string& path) {
  std::error_code ignored;
  if (fs::exists(path, ignored)) {
    return;
  }
  const fs::path folder = fs::path(path).parent_path();
  throw InputError(fmt::format(
      "{}: no such image file.\nThe path is taken relative to the case file (or to the current "
      "folder for a command line);{} check the spelling.",
      path,
      !folder.empty() && !fs::exists(folder, ignored)
          ? fmt::format(" the folder '{}' does not exist either;", folder.string())
          : ""));
}

GreyVolume read_raw(const std::string& path, const Int3& size, const ReadLimits& limits) {
  const std::uintmax_t found = fs::file_size(path);
  if (size[0] <= 0 || size[1] <= 0 || size[2] <= 0) {
    throw InputError(fmt::format(
        "{}: a raw volume needs raw_size = [nx, ny, nz]; the file holds {} bytes, one per voxel.",
        path, found));
  }
  require_reasonable_size(path, size[0], size[1], size[2], limits);
  if (found != static_cast<std::uintmax_t>(product(size))) {
    throw InputError(fmt::format(
        "{}: the file holds {} bytes, but raw_size = [{}, {}, {}] needs {}.\nraw_size must match, "
        "one byte per voxel and no header{}.",
        path, found, size[0], size[1], size[2], product(size),
        found == 2 * static_cast<std::uintmax_t>(product(size))
            ? "; this looks like 16 bits per voxel: convert it to 8"
            : ""));
  }
  return to_grey({size, {}, read_bytes(path, found)});
}

GreyVolume read_one(const std::string& path, const ReadLimits& limits) {
  const auto start = read_bytes(path, 16);
  if (start.empty()) {
    throw InputError(path + ": the file is empty (0 bytes).");
  }
  if (looks_like_tiff(start)) {
    return to_grey(read_tiff_file(path, limits));
  }
  return read_image(read_bytes(path, std::size_t{1} << 31), path, limits);
}

GreyVolume read_folder(const std::string& path, const ReadLimits& limits) {
  std::vector<std::string> slices;
  for (const auto& entry : fs::directory_iterator(path)) {
    const std::string extension = entry.path().extension().string();
    if (extension == ".png" || extension == ".tif" || extension == ".tiff") {
      slices.push_back(entry.path().string());
    }
  }
  if (slices.empty()) {
    throw InputError(path + ": the folder holds no .png, .tif or .tiff slices.");
  }
  std::sort(slices.begin(), slices.end());
  GreyVolume stack;
  for (const auto& slice : slices) {
    const GreyVolume page = read_one(slice, limits);
    if (stack.n[2] == 0) {
      stack.n = {page.n[0], page.n[1], 0};
    }
    if (page.n != Int3{stack.n[0], stack.n[1], 1}) {
      throw InputError(fmt::format(
          "{}: this slice has {}x{}x{} pixels, the first one ({}) has {}x{}.\nAll slices of a "
          "stack must be 2D and of one size.",
          slice, page.n[0], page.n[1], page.n[2], slices.front(), stack.n[0], stack.n[1]));
    }
    stack.grey.insert(stack.grey.end(), page.grey.begin(), page.grey.end());
    ++stack.n[2];
  }
  return stack;
}

int full_scale(int highest) {
  for (const int scale : {255, 1023, 4095, 16383}) {
    if (highest <= scale) {
      return scale;
    }
  }
  return 65535;
}

}  // namespace

void require_reasonable_size(const std::string& name, Index nx, Index ny, Index nz,
                             const ReadLimits& limits) {
  if (nx <= 0 || ny <= 0 || nz <= 0) {
    throw InputError(
        fmt::format("{}: the image has {} x {} x {} pixels: nothing to read.", name, nx, ny, nz));
  }
  constexpr Index longest = Index{1} << 30;
  const bool huge = nx > longest || ny > longest || nz > longest || nx * ny > limits.max_voxels ||
                    nx * ny * nz > limits.max_voxels;
  if (huge) {
    throw InputError(fmt::format(
        "{}: the file claims {} x {} x {} pixels, more than the {} that are accepted.\nIt is "
        "probably corrupt; otherwise cut the image into smaller ones.",
        name, nx, ny, nz, limits.max_voxels));
  }
}

GreyVolume to_grey(Samples samples) {
  GreyVolume out{samples.n, std::move(samples.narrow)};
  if (!samples.wide.empty()) {
    const int scale = full_scale(*std::max_element(samples.wide.begin(), samples.wide.end()));
    out.grey.resize(samples.wide.size());
    std::transform(samples.wide.begin(), samples.wide.end(), out.grey.begin(), [scale](int value) {
      return static_cast<std::uint8_t>((value * 255 + scale / 2) / scale);
    });
  }
  const auto row = static_cast<std::ptrdiff_t>(out.n[0]);
  for (int k = 0; k < out.n[2]; ++k) {  // rows downwards -> y upwards
    for (int top = 0, bottom = out.n[1] - 1; top < bottom; ++top, --bottom) {
      const auto first = out.grey.begin() + voxel_index(out.n, 0, top, k);
      std::swap_ranges(first, first + row, out.grey.begin() + voxel_index(out.n, 0, bottom, k));
    }
  }
  return out;
}

GreyVolume read_image(std::span<const std::uint8_t> bytes, const std::string& name,
                      const ReadLimits& limits) {
  if (looks_like_png(bytes)) {
    return to_grey(read_png(bytes, name, limits));
  }
  if (looks_like_tiff(bytes)) {
    return to_grey(read_tiff(bytes, name, limits));
  }
  const bool jpeg = bytes.size() > 2 && bytes[0] == 0xFF && bytes[1] == 0xD8;
  throw InputError(fmt::format(
      "{}: neither a PNG nor a TIFF{}.\nSave the image as PNG or TIFF; a raw volume must end in "
      ".raw and needs raw_size.",
      name, jpeg ? " but a JPEG, whose compression blurs grain edges" : ""));
}

GreyVolume read_image(const std::string& path, const Int3& raw_size, const ReadLimits& limits) {
  require_exists(path);
  if (fs::is_directory(path)) {
    return read_folder(path, limits);
  }
  if (fs::path(path).extension() == ".raw") {
    return read_raw(path, raw_size, limits);
  }
  return read_one(path, limits);
}

}  // namespace porefines::geom
