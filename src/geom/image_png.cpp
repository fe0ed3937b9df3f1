// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <cstring>

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

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

cv::Mat decode(std::span<const std::uint8_t> bytes, const std::string& name) {
  const cv::Mat raw(1, static_cast<int>(bytes.size()), CV_8U,
                    const_cast<std::uint8_t*>(bytes.data()));  // OpenCV reads it only
  cv::Mat image;
  try {
    image = cv::imdecode(raw, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    image.release();
  }
  if (image.empty() || (image.depth() != CV_8U && image.depth() != CV_16U)) {
    throw InputError(
        fmt::format("{}: this PNG cannot be decoded; it is corrupt or cut short.\n"
                    "Try opening it in an image viewer and saving it again as 8-bit grey PNG.",
                    name));
  }
  return image;
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
  cv::Mat image = decode(bytes, name);
  if (image.channels() == 4) {
    cv::cvtColor(image, image, cv::COLOR_BGRA2GRAY);
  } else if (image.channels() == 3) {
    cv::cvtColor(image, image, cv::COLOR_BGR2GRAY);
  }
  Samples samples{{image.cols, image.rows, 1}, {}, {}};
  const auto count = static_cast<std::size_t>(image.cols) * image.rows;
  image = image.isContinuous() ? image : image.clone();
  if (image.depth() == CV_16U) {
    samples.wide.resize(count);
    std::memcpy(samples.wide.data(), image.data, 2 * count);
  } else {
    samples.narrow.resize(count);
    std::memcpy(samples.narrow.data(), image.data, count);
  }
  return samples;
}

}  // namespace porefines::geom
