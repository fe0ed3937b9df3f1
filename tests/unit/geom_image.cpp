// SPDX-License-Identifier: MPL-2.0
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <tiffio.h>

#include "core/error.hpp"
#include "geom/build.hpp"
#include "geom/image_read.hpp"
#include "unit/geom_support.hpp"

namespace porefines::geom {

namespace fs = std::filesystem;

namespace {

/// Pages of width x height with value = f(x, row, page), 1, 8, 16 or 32 (float) bits.
std::string write_tiff(const fs::path& path, const Int3& n, int bits) {
  TIFF* const tiff = TIFFOpen(path.c_str(), "w");
  for (int page = 0; page < n[2]; ++page) {
    TIFFSetField(tiff, TIFFTAG_IMAGEWIDTH, n[0]);
    TIFFSetField(tiff, TIFFTAG_IMAGELENGTH, n[1]);
    TIFFSetField(tiff, TIFFTAG_BITSPERSAMPLE, bits);
    TIFFSetField(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(tiff, TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
    TIFFSetField(tiff, TIFFTAG_COMPRESSION, bits == 16 ? COMPRESSION_LZW : COMPRESSION_NONE);
    if (bits == 32) {
      TIFFSetField(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_IEEEFP);
    }
    for (int row = 0; row < n[1]; ++row) {
      std::vector<std::uint8_t> bytes(static_cast<std::size_t>(n[0]) * 4);
      for (int x = 0; x < n[0]; ++x) {
        const int value = x + 10 * row + 100 * page;
        const auto u = static_cast<std::size_t>(x);
        if (bits == 1) {
          bytes[u / 8] |= static_cast<std::uint8_t>((value % 2) << (7 - x % 8));
        } else if (bits == 8) {
          bytes[u] = static_cast<std::uint8_t>(value);
        } else if (bits == 16) {
          reinterpret_cast<std::uint16_t*>(bytes.data())[u] =
              static_cast<std::uint16_t>(257 * value);
        }
      }
      TIFFWriteScanline(tiff, bytes.data(), static_cast<std::uint32_t>(row));
    }
    TIFFWriteDirectory(tiff);
  }
  TIFFClose(tiff);
  return path.string();
}

std::vector<std::uint8_t> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string message_of(const std::string& path, const Int3& raw_size = {0, 0, 0}) {
  try {
    (void)read_image(path, raw_size);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

}  // namespace

TEST(Image, stack_of_8_and_16_bits_reads_with_y_upwards_and_z_as_page) {
  const auto folder = support::scratch("stack");
  for (const int bits : {8, 16}) {
    const auto path = write_tiff(folder / std::to_string(bits), {7, 5, 2}, bits);
    for (const auto& image : {read_image(path), read_image(bytes_of(path), "memory")}) {
      ASSERT_EQ(image.n, (Int3{7, 5, 2}));
      for (int k = 0; k < 2; ++k) {
        for (int j = 0; j < 5; ++j) {
          for (int i = 0; i < 7; ++i) {
            const int row = 4 - j;
            ASSERT_EQ(image.grey[static_cast<std::size_t>(voxel_index(image.n, i, j, k))],
                      i + 10 * row + 100 * k);
          }
        }
      }
    }
  }
}

TEST(Image, one_bit_becomes_0_and_255) {
  const auto image = read_image(write_tiff(support::scratch("bit") / "a.tif", {9, 2, 1}, 1));
  EXPECT_EQ(image.grey[0], 0);    // row 1 of the file, x = 0: value 10
  EXPECT_EQ(image.grey[8], 0);    // x = 8
  EXPECT_EQ(image.grey[7], 255);  // x = 7
}

TEST(Image, png_of_grey_colour_and_16_bits) {
  const auto folder = support::scratch("png");
  const cv::Mat colour(4, 6, CV_8UC3, cv::Scalar(255, 0, 0));  // blue
  cv::imwrite((folder / "blue.png").string(), colour);
  EXPECT_EQ(read_image((folder / "blue.png").string()).grey[0], 29);  // 0.114 * 255
  cv::Mat deep(4, 6, CV_16U, cv::Scalar(0));
  deep.at<std::uint16_t>(0, 5) = 4095;  // a 12-bit camera: top right corner is full scale
  deep.at<std::uint16_t>(3, 0) = 2048;
  cv::imwrite((folder / "deep.png").string(), deep);
  const auto image = read_image((folder / "deep.png").string());
  EXPECT_EQ(image.grey[6 * 3 + 5], 255);
  EXPECT_EQ(image.grey[0], 128);
  cv::Mat labels(4, 6, CV_16U, cv::Scalar(2));
  cv::imwrite((folder / "labels.png").string(), labels);
  EXPECT_EQ(read_image((folder / "labels.png").string()).grey[0], 2);
}

TEST(Image, folder_of_slices_is_a_stack) {
  const auto folder = support::scratch("slices");
  for (int z = 0; z < 3; ++z) {
    cv::imwrite((folder / ("slice" + std::to_string(z) + ".png")).string(),
                cv::Mat(4, 6, CV_8U, cv::Scalar(10 * z)));
  }
  const auto image = read_image(folder.string());
  ASSERT_EQ(image.n, (Int3{6, 4, 3}));
  EXPECT_EQ(image.grey.back(), 20);
}

TEST(Image, errors_name_the_file_what_was_found_and_what_to_try) {
  const auto folder = support::scratch("errors");
  EXPECT_TRUE(contains(message_of("/nowhere/image.png"), "/nowhere/image.png: no such"));
  const auto empty = (folder / "empty.png").string();
  std::ofstream(empty).flush();
  EXPECT_TRUE(contains(message_of(empty), "0 bytes"));
  const auto text = (folder / "text.png").string();
  std::ofstream(text) << "this is no picture";
  EXPECT_TRUE(contains(message_of(text), "neither a PNG nor a TIFF"));
  EXPECT_TRUE(contains(message_of(write_tiff(folder / "f.tif", {4, 4, 1}, 32)), "floating-point"));

  const auto good = bytes_of(write_tiff(folder / "good.tif", {64, 64, 2}, 16));
  const auto cut = (folder / "cut.tif").string();
  std::ofstream(cut, std::ios::binary)
      .write(reinterpret_cast<const char*>(good.data()), static_cast<std::streamsize>(200));
  EXPECT_TRUE(contains(message_of(cut), cut));

  cv::imwrite((folder / "whole.png").string(), cv::Mat(40, 40, CV_8U, cv::Scalar(3)));
  auto png = bytes_of((folder / "whole.png").string());
  png[16] = 0x7F;  // absurd width
  EXPECT_THROW((void)read_image(png, "memory"), InputError);
  png[16] = 0;
  png.resize(png.size() / 2);
  EXPECT_THROW((void)read_image(png, "memory"), InputError);
}

TEST(Image, raw_volume_must_match_its_size) {
  const auto path = (support::scratch("raw") / "a.raw").string();
  std::ofstream(path) << "abcdefghijkl";
  const auto image = read_image(path, {2, 3, 2});
  EXPECT_EQ(image.grey[0], 'e');  // the last row of page 0 is y = 0
  EXPECT_TRUE(contains(message_of(path, {2, 3, 3}), "12 bytes"));
  EXPECT_TRUE(contains(message_of(path, {1, 3, 2}), "16 bits"));
  EXPECT_TRUE(contains(message_of(path), "raw_size"));
}

TEST(Image, real_berea_has_the_published_porosity) {
  const auto path = support::shared_file("images/berea_200.tif");
  if (path.empty()) {
    GTEST_SKIP() << "needs ../shared/data/images/berea_200.tif (or PF_SHARED)";
  }
  Spec spec;
  spec.source = path;
  spec.pixel_size = 5.345e-6;
  spec.only_percolating = false;
  const Sample sample = build_sample(spec, MPI_COMM_WORLD);
  ASSERT_EQ(sample.voxels.n, (Int3{200, 200, 200}));
  EXPECT_NEAR(static_cast<Real>(sample.found_pores) / 8e6, 0.19872, 5e-6);
  EXPECT_NEAR(sample.box.size.z, 200 * 5.345e-6, 1e-12);
  const Solid solid = make_solid(sample, {0, 0, 0}, {1e-4, 1e-4, 1e-4}, 2e-5);
  EXPECT_NEAR(band_of(solid), 4 * 5.345e-6, 1e-12);
}

}  // namespace porefines::geom
