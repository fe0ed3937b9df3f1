// SPDX-License-Identifier: MPL-2.0
// FieldWriter on any number of ranks: the file is the same however the grid is cut.
#include <algorithm>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hdf5.h>
#include <sys/resource.h>
#include <unistd.h>

#include "core/error.hpp"
#include "io/agree.hpp"
#include "io/fields.hpp"

namespace porefines {
namespace {

constexpr Int3 global{6, 5, 7};

int world_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

/// Cuts z into ranks, unevenly; with more ranks than 3 the fourth has nothing.
io::GridBlock my_block(Int3 cells = global) {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  const int parts = std::min(size, 3);
  const int rank = world_rank();
  io::GridBlock block{cells, {1, 2, 3}, {0.1, 0.2, 0.4}, {0, 0, 0}, {cells[0], cells[1], 0}};
  if (rank < parts) {
    block.offset[2] = cells[2] * rank / parts;
    block.cells[2] = cells[2] * (rank + 1) / parts - block.offset[2];
  }
  return block;
}

struct Values {
  std::vector<float> scalar;
  std::vector<float> vector;
};

Values values_of(const io::GridBlock& block, float time) {
  Values values;
  for (int k = 0; k < block.cells[2]; ++k) {
    for (int j = 0; j < block.cells[1]; ++j) {
      for (int i = 0; i < block.cells[0]; ++i) {
        const auto z = static_cast<float>(block.offset[2] + k);
        values.scalar.push_back(1000 * time + i + 10 * j + 100 * z);
        values.vector.insert(values.vector.end(),
                             {static_cast<float>(i), static_cast<float>(j), z});
      }
    }
  }
  return values;
}

void write_step(io::FieldWriter& writer, const io::GridBlock& block, float time) {
  const Values values = values_of(block, time);
  const io::ScalarField scalars[] = {{"pressure", values.scalar}};
  const io::VectorField vectors[] = {{"velocity", values.vector}};
  writer.write(time, scalars, vectors);
}

/// Reads a whole dataset as a plain serial program would; empty when it is not there.
std::vector<float> dataset(const std::string& path, const std::string& name) {
  std::vector<float> values;
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = file < 0 ? -1 : H5Dopen2(file, name.c_str(), H5P_DEFAULT);
  if (data >= 0) {
    const hid_t space = H5Dget_space(data);
    values.resize(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
    H5Dread(data, H5T_NATIVE_FLOAT, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data());
    H5Sclose(space);
    H5Dclose(data);
  }
  if (file >= 0) {
    H5Fclose(file);
  }
  return values;
}

std::string text(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

int count(const std::string& where, const std::string& what) {
  int found = 0;
  for (auto at = where.find(what); at != std::string::npos; at = where.find(what, at + 1)) {
    ++found;
  }
  return found;
}

class IoFields : public ::testing::Test {
 protected:
  void SetUp() override {
    folder = "/tmp/pf_io_fields_" + std::to_string(::getppid()) + "_" +
             ::testing::UnitTest::GetInstance()->current_test_info()->name();
    MPI_Bcast(folder.data(), static_cast<int>(folder.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
    std::filesystem::create_directories(folder);
    MPI_Barrier(MPI_COMM_WORLD);
  }
  void TearDown() override {
    MPI_Barrier(MPI_COMM_WORLD);
    if (world_rank() == 0) {
      std::filesystem::remove_all(folder);
    }
  }
  std::string folder;
};

TEST_F(IoFields, file_is_complete_after_every_write_while_the_writer_lives) {
  const io::GridBlock block = my_block();
  io::FieldWriter writer(folder, MPI_COMM_WORLD, block, io::make_provenance(1, 1));
  const Values all = [] {
    io::GridBlock whole = my_block();
    whole.offset = {0, 0, 0};
    whole.cells = global;
    return values_of(whole, 0.5F);
  }();
  for (int step = 0; step < 2; ++step) {
    write_step(writer, block, 0.5F * static_cast<float>(step));
    const std::string listed = text(folder + "/fields.xdmf");
    EXPECT_EQ(count(listed, "GridType=\"Uniform\""), step + 1);
    EXPECT_NE(listed.find("Dimensions=\"8 6 7\""), std::string::npos);
    EXPECT_NE(listed.find("3 2 1</DataItem>"), std::string::npos) << "origin is not z y x";
    EXPECT_NE(listed.find("0.4 0.2 0.1</DataItem>"), std::string::npos) << "spacing is not z y x";
    MPI_Barrier(MPI_COMM_WORLD);
  }
  EXPECT_EQ(dataset(folder + "/fields.h5", "step_000001/pressure"), all.scalar);
  EXPECT_EQ(dataset(folder + "/fields.h5", "step_000001/velocity"), all.vector);
}

TEST_F(IoFields, resume_keeps_steps_up_to_the_time_and_appends) {
  const io::GridBlock block = my_block();
  {
    io::FieldWriter writer(folder, MPI_COMM_WORLD, block, io::make_provenance(1, 1));
    for (const float time : {0.0F, 1.0F, 2.0F, 3.0F}) {
      write_step(writer, block, time);
    }
  }
  auto writer =
      io::FieldWriter::resume(folder, MPI_COMM_WORLD, block, io::make_provenance(1, 1), 1.0);
  EXPECT_EQ(writer.steps(), 2);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_TRUE(dataset(folder + "/fields.h5", "step_000002/pressure").empty());
  EXPECT_TRUE(dataset(folder + "/fields.h5", "step_000003/pressure").empty());
  MPI_Barrier(MPI_COMM_WORLD);
  write_step(writer, block, 1.5F);
  const std::string listed = text(folder + "/fields.xdmf");
  EXPECT_EQ(count(listed, "<Time"), 3);
  EXPECT_NE(listed.find("<Time Value=\"1.5\"/>"), std::string::npos);
  EXPECT_EQ(count(listed, "AttributeType=\"Vector\""), 3);
  EXPECT_EQ(dataset(folder + "/fields.h5", "step_000002/pressure").at(0), 1500);

  Int3 other = global;
  other[0] += 1;
  EXPECT_THROW((void)io::FieldWriter::resume(folder, MPI_COMM_WORLD, my_block(other),
                                             io::make_provenance(1, 1), 1.0),
               RunError);
}

TEST_F(IoFields, mistakes_of_one_rank_are_errors_on_all) {
  const io::GridBlock block = my_block();
  io::FieldWriter writer(folder, MPI_COMM_WORLD, block, io::make_provenance(1, 1));
  Values values = values_of(block, 0);
  if (world_rank() == 0) {
    values.scalar.pop_back();
  }
  const io::ScalarField wrong_size[] = {{"pressure", values.scalar}};
  EXPECT_THROW(writer.write(0, wrong_size, {}), RunError);
  const std::string name = world_rank() == 0 ? "a/b" : "ab";
  const Values right = values_of(block, 0);
  const io::ScalarField wrong_name[] = {{name, right.scalar}};
  EXPECT_THROW(writer.write(0, wrong_name, {}), RunError);
  EXPECT_EQ(count(text(folder + "/fields.xdmf"), "<Time"), 0);
  write_step(writer, block, 0);
  EXPECT_EQ(writer.steps(), 1);
  EXPECT_THROW(
      io::FieldWriter(folder + "/missing", MPI_COMM_WORLD, block, io::make_provenance(1, 1)),
      RunError);
}

/// A limit on the file size stands in for the full disk: the write fails half-way in both cases.
TEST_F(IoFields, a_write_that_fails_says_why_and_leaves_the_earlier_steps) {
  const Int3 cells{64, 64, 64};
  const io::GridBlock block = my_block(cells);
  io::FieldWriter writer(folder, MPI_COMM_WORLD, block, io::make_provenance(1, 1));
  write_step(writer, block, 0);
  MPI_Barrier(MPI_COMM_WORLD);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit low = before;
  low.rlim_cur = std::filesystem::file_size(folder + "/fields_000000.h5") - 1000000;
  MPI_Barrier(MPI_COMM_WORLD);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &low);
  std::string message;
  try {
    write_step(writer, block, 1);
  } catch (const RunError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("File too large"), std::string::npos) << message;
  EXPECT_EQ(count(text(folder + "/fields.xdmf"), "<Time"), 1);
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(dataset(folder + "/fields.h5", "step_000000/pressure").size(),
            static_cast<std::size_t>(product(cells)));
}

TEST(io_agree, lowest_failing_rank_speaks_for_all) {
  int size = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &size);
  EXPECT_NO_THROW(io::throw_everywhere(MPI_COMM_WORLD, ""));
  const bool fails = world_rank() >= size / 2;
  try {
    io::throw_everywhere(MPI_COMM_WORLD, fails ? "rank " + std::to_string(world_rank()) : "");
    FAIL() << "no error";
  } catch (const RunError& error) {
    EXPECT_EQ(error.what(), "rank " + std::to_string(size / 2));
  }
}

}  // namespace
}  // namespace porefines
