// SPDX-License-Identifier: MPL-2.0
// Small files: replaced whole, series that resume, provenance, PNG.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <png.h>

#include "core/error.hpp"
#include "io/png.hpp"
#include "io/provenance.hpp"
#include "io/replace_file.hpp"
#include "io/series.hpp"

namespace porefines {
namespace {

class IoFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = ::testing::TempDir() + "pf_io_" +
             ::testing::UnitTest::GetInstance()->current_test_info()->name();
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  [[nodiscard]] std::string file(const std::string& name) const { return folder + "/" + name; }
  std::string folder;
};

std::string content(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST_F(IoFiles, replace_leaves_the_new_content_and_no_temporary) {
  io::replace_file(file("a"), "old and longer");
  io::replace_file(file("a"), "new");
  EXPECT_EQ(content(file("a")), "new");
  EXPECT_FALSE(std::filesystem::exists(file("a.part")));
}

TEST_F(IoFiles, replace_names_the_path_and_the_reason) {
  try {
    io::replace_file(folder + "/missing/a", "x");
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_NE(std::string(error.what()).find("missing/a"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("No such file"), std::string::npos);
  }
  std::filesystem::create_directories(file("folder/inside"));
  EXPECT_THROW(io::replace_file(file("folder"), "x"), RunError);
  EXPECT_FALSE(std::filesystem::exists(file("folder.part")));
}

TEST_F(IoFiles, series_numbers_read_back_to_the_same_double) {
  const Real third = 1.0 / 3;
  io::SeriesWriter series(file("s.csv"), {"time_s", "value"});
  series.append(std::vector<Real>{0.1, third});
  series.append(std::vector<Real>{2.5e-7, std::numeric_limits<Real>::quiet_NaN()});
  std::ifstream in(file("s.csv"));
  std::string line;
  std::getline(in, line);
  EXPECT_EQ(line, "time_s,value");
  std::getline(in, line);
  EXPECT_EQ(std::stod(line), 0.1);
  EXPECT_EQ(std::stod(line.substr(line.find(',') + 1)), third);
  std::getline(in, line);
  EXPECT_EQ(line, "2.5e-07,nan");
}

TEST_F(IoFiles, series_resumes_at_a_time_without_the_broken_row) {
  {
    io::SeriesWriter series(file("s.csv"), {"time_s", "v"});
    for (int i = 0; i < 5; ++i) {
      series.append(std::vector<Real>{i * 0.5, 10.0 * i});
    }
  }
  std::ofstream(file("s.csv"), std::ios::app) << "2.5,5";
  {
    auto series = io::SeriesWriter::resume(file("s.csv"), {"time_s", "v"}, 1.0);
    series.append(std::vector<Real>{1.25, -1});
  }
  EXPECT_EQ(content(file("s.csv")), "time_s,v\n0,0\n0.5,10\n1,20\n1.25,-1\n");
  { const auto series = io::SeriesWriter::resume(file("s.csv"), {"time_s", "v"}, 99); }
  EXPECT_EQ(content(file("s.csv")), "time_s,v\n0,0\n0.5,10\n1,20\n1.25,-1\n");
  EXPECT_THROW((void)io::SeriesWriter::resume(file("s.csv"), {"time_s", "w"}, 1.0), RunError);
  const auto fresh = io::SeriesWriter::resume(file("t.csv"), {"time_s"}, 1.0);
  EXPECT_EQ(content(file("t.csv")), "time_s\n");
}

TEST_F(IoFiles, series_refuses_a_wrong_row) {
  io::SeriesWriter series(file("s.csv"), {"time_s", "v"});
  EXPECT_THROW(series.append(std::vector<Real>{1.0}), RunError);
  EXPECT_EQ(content(file("s.csv")), "time_s,v\n");
}

TEST(io_provenance, names_version_commit_ranks_and_seed) {
  const io::Provenance provenance = io::make_provenance(3, 20211);
  EXPECT_EQ(provenance.version, PF_VERSION);
  EXPECT_FALSE(provenance.commit.empty());
  EXPECT_EQ(provenance.date.size(), std::string("2026-11-22T03:00:00Z").size());
  const std::string line = io::describe(provenance);
  for (const auto& [name, value] : io::entries(provenance)) {
    EXPECT_NE(line.find(value), std::string::npos) << name;
  }
}

struct Decoded {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;
};

Decoded decode(const std::string& path, png_uint_32 format) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  Decoded out;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0) {
    return out;
  }
  image.format = format;
  out.width = static_cast<int>(image.width);
  out.height = static_cast<int>(image.height);
  out.pixels.resize(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, out.pixels.data(), 0, nullptr);
  return out;
}

TEST_F(IoFiles, png_reads_back_pixel_by_pixel_and_names_its_origin) {
  const io::Provenance provenance{"9.8.7", "0123456789ab", 2, 5, "2026-01-02T03:04:05Z"};
  const std::vector<std::uint8_t> rgb{1, 2, 3, 4, 5, 6, 250, 251, 252, 7, 8, 9, 0, 0, 0, 9, 8, 7};
  io::write_png(file("a.png"), {2, 3, 3, rgb}, provenance, "a title");
  const Decoded colour = decode(file("a.png"), PNG_FORMAT_RGB);
  EXPECT_EQ(colour.width, 2);
  EXPECT_EQ(colour.height, 3);
  EXPECT_EQ(colour.pixels, rgb);
  const std::string bytes = content(file("a.png"));
  EXPECT_NE(bytes.find(io::describe(provenance)), std::string::npos);
  EXPECT_NE(bytes.find("a title"), std::string::npos);

  const std::vector<std::uint8_t> grey{10, 20, 30};
  io::write_png(file("g.png"), {3, 1, 1, grey}, provenance);
  EXPECT_EQ(decode(file("g.png"), PNG_FORMAT_GRAY).pixels, grey);
  EXPECT_THROW(io::write_png(file("b.png"), {3, 1, 3, grey}, provenance), RunError);
  EXPECT_FALSE(std::filesystem::exists(file("b.png")));
}

}  // namespace
}  // namespace porefines
