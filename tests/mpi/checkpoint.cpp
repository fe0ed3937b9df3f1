// SPDX-License-Identifier: MPL-2.0
// Checkpoints on any number of ranks, written by any other.
#include "io/checkpoint.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <numeric>
#include <optional>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "core/error.hpp"
#include "sim/particle_checkpoint.hpp"
#include "support/scratch.hpp"
#include "support/spheres.hpp"

namespace porefines::test {
namespace {

using dem::System;
using io::CheckpointReader;

constexpr Real d = 5e-6;
constexpr Real dt = 2e-8;
const io::Provenance somewhere = io::make_provenance(1, 1);

class Checkpoints : public ::testing::Test {
 protected:
  Checkpoints() {
    std::string path = std::string(mine_ ? mine_->path() : "");
    path.resize(200, '\0');
    MPI_Bcast(path.data(), 200, MPI_CHAR, 0, MPI_COMM_WORLD);
    folder_ = path.c_str();
  }
  ~Checkpoints() override { MPI_Barrier(MPI_COMM_WORLD); }

  [[nodiscard]] CheckpointReader reader() const {
    return CheckpointReader(folder_, world_.rank(), world_.size());
  }
  [[nodiscard]] CheckpointReader reader_alone() const { return CheckpointReader(folder_, 0, 1); }

  par::Communicator world_;
  std::optional<Scratch> mine_ =
      world_.is_root() ? std::optional<Scratch>(std::in_place) : std::nullopt;
  std::string folder_;
};

/// Spheres between walls of which one moves, with friction and rolling springs.
dem::Settings settings() {
  dem::Settings s = cube(12 * d, false, latex, {0.8, 0.5, 0.1, 0.3});
  s.box.periodic = {true, false, false};
  s.model.rolling = dem::RollingSpring{};
  s.gravity = {500, 0, -1000};
  auto faces = dem::box_faces(s.box.low, s.box.high, {false, false, true, true, true, true});
  std::get<dem::Plane>(faces[0]).motion.velocity = {0, 0.01, 0};
  s.walls.emplace_back(faces);
  return s;
}

System colliding(const par::Communicator& comm) {
  System system(comm, settings());
  system.insert(gas(10, 12 * d, d / 2, 1.1, 0.1, 11));
  system.advance(dt, 400);
  return system;
}

void write(const System& system, const std::string& folder, const par::Communicator& comm) {
  const dem::Snapshot snapshot = system.save();
  io::Checkpoint checkpoint;
  sim::put_snapshot(checkpoint, snapshot);
  io::write_checkpoint(folder, 2, checkpoint, somewhere, comm.handle());
}

System read(const CheckpointReader& reader, const par::Communicator& comm) {
  System system(comm, settings());
  system.restore(sim::get_snapshot(reader, settings().walls), reader.same_ranks());
  return system;
}

/// [m] largest distance between the same particles; each rank has its own of `b`, all have `a`.
Real apart(const System& all, const System& some, const par::Communicator& comm) {
  const auto& p = some.particles();
  Real most = 0;
  for (std::size_t i = 0; i < p.owned; ++i) {
    const auto& q = all.particles();
    Vec3 way = p.position[i] - q.position[find(q, p.id[i])];
    way.x -= 12 * d * std::round(way.x / (12 * d));
    most = std::max(most, norm(way));
  }
  EXPECT_EQ(comm.sum(static_cast<Index>(p.owned)), 1000);
  return comm.max(most);
}

TEST_F(Checkpoints, on_the_same_ranks_the_run_goes_on_bit_for_bit) {
  System whole = colliding(world_);
  write(whole, folder_, world_);
  EXPECT_GT(whole.save().moved, 0) << "in the middle between two lists";
  System resumed = read(reader(), world_);
  EXPECT_EQ(resumed.largest_overlap(), whole.largest_overlap());
  whole.advance(dt, 500);
  resumed.advance(dt, 200);
  resumed.advance(dt, 300);
  const auto& a = whole.particles();
  const auto& b = resumed.particles();
  ASSERT_EQ(a.owned, b.owned);
  EXPECT_TRUE(
      std::equal(a.id.begin(), a.id.begin() + static_cast<std::ptrdiff_t>(a.owned), b.id.begin()));
  for (std::size_t i = 0; i < a.owned; ++i) {
    ASSERT_EQ(a.position[i], b.position[i]);
    ASSERT_EQ(a.velocity[i], b.velocity[i]);
    ASSERT_EQ(a.angular_velocity[i], b.angular_velocity[i]);
    ASSERT_EQ(a.force[i], b.force[i]);
  }
  EXPECT_EQ(resumed.largest_overlap(), whole.largest_overlap());
}

TEST_F(Checkpoints, on_other_ranks_it_goes_on_to_round_off) {
  System many = colliding(world_);
  write(many, folder_, world_);
  System alone = read(reader_alone(), par::Communicator::self());
  many.advance(dt, 100);
  alone.advance(dt, 100);
  EXPECT_LT(apart(alone, many, world_), 1e-10 * d);
  MPI_Barrier(MPI_COMM_WORLD);
  if (world_.is_root()) {
    write(alone, folder_, par::Communicator::self());
  }
  MPI_Barrier(MPI_COMM_WORLD);
  System again = read(reader(), world_);
  EXPECT_EQ(reader().same_ranks(), world_.size() == 1);
  alone.advance(dt, 100);
  again.advance(dt, 100);
  EXPECT_LT(apart(alone, again, world_), 1e-10 * d);
}

/// Slabs of z; the last ranks have nothing where there are more ranks than layers.
io::GridBlock slab(const Int3& cells, int rank, int ranks) {
  io::GridBlock block{cells, {}, {1, 1, 1}, {0, 0, cells[2] * rank / ranks}, cells};
  block.cells[2] = cells[2] * (rank + 1) / ranks - block.offset[2];
  return block;
}

TEST_F(Checkpoints, cells_of_a_grid_are_found_however_it_is_cut) {
  const io::GridBlock mine = slab({4, 3, 3}, world_.rank(), world_.size());
  const int before = 2 * 12 * mine.offset[2];
  std::vector<Real> values(static_cast<std::size_t>(2 * product(mine.cells)));
  std::iota(values.begin(), values.end(), before);
  std::vector<float> floats(values.begin(), values.end());
  floats.resize(values.size() / 2);
  io::Checkpoint checkpoint;
  checkpoint.block<Real>("pairs", mine, values, 2);
  checkpoint.block<float>("floats", mine, floats);
  checkpoint.text("case", "a = 1\n");
  checkpoint.rows("empty", std::vector<std::uint16_t>{});
  io::write_checkpoint(folder_, 1, checkpoint, somewhere, world_.handle());
  const io::GridBlock whole = slab({4, 3, 3}, 0, 1);
  const CheckpointReader there = reader_alone();
  const auto pairs = there.block<Real>("pairs", whole, 2);
  ASSERT_EQ(pairs.size(), 72U);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    EXPECT_EQ(pairs[i], static_cast<Real>(i));
  }
  EXPECT_EQ(there.block<float>("floats", mine), floats);
  EXPECT_EQ(there.text("case"), "a = 1\n");
  EXPECT_TRUE(there.rows<std::uint16_t>("empty").empty());
  EXPECT_FALSE(there.has("another"));
  EXPECT_THROW((void)there.rows<Real>("another"), RunError);
  EXPECT_THROW((void)there.block<Real>("floats", whole), RunError) << "another type";
  EXPECT_THROW((void)there.block<float>("floats", slab({4, 3, 4}, 0, 1)), RunError);
}

void write_number(Real value, int keep, const std::string& folder, const par::Communicator& comm) {
  io::Checkpoint checkpoint;
  checkpoint.whole("number", std::vector<Real>{value});
  checkpoint.rows("ballast", std::vector<Real>(100000, 1.0));
  io::write_checkpoint(folder, keep, checkpoint, somewhere, comm.handle());
}

Real number_in(const std::string& folder, const std::string& file) {
  const Scratch copy;
  std::filesystem::copy(folder + "/" + file, copy / "checkpoint.h5");
  return CheckpointReader(copy.path(), 0, 1).whole<Real>("number")[0];
}

TEST_F(Checkpoints, the_ones_before_are_kept_and_a_broken_one_is_passed_over) {
  for (const Real value : {1.0, 2.0, 3.0, 4.0}) {
    write_number(value, 3, folder_, world_);
  }
  EXPECT_EQ(number_in(folder_, "checkpoint.h5"), 4);
  EXPECT_EQ(number_in(folder_, "checkpoint_1.h5"), 3);
  EXPECT_EQ(number_in(folder_, "checkpoint_2.h5"), 2);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/checkpoint_3.h5"));
  MPI_Barrier(MPI_COMM_WORLD);
  if (world_.is_root()) {
    std::filesystem::resize_file(folder_ + "/checkpoint.h5", 1000);
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_EQ(reader().whole<Real>("number")[0], 3);
  MPI_Barrier(MPI_COMM_WORLD);
  if (world_.is_root()) {
    io::remove_checkpoints(folder_);
    EXPECT_TRUE(std::filesystem::is_empty(folder_));
  }
  MPI_Barrier(MPI_COMM_WORLD);
  EXPECT_THROW(reader(), InputError);
}

/// A limit on the file size stands in for the full disk.
TEST_F(Checkpoints, a_full_disk_leaves_the_one_before) {
  write_number(1, 2, folder_, world_);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit low = before;
  low.rlim_cur = 500000;
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &low);
  std::string message;
  try {
    write_number(2, 2, folder_, world_);
  } catch (const RunError& error) {
    message = error.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(message.find("MB of a checkpoint: File too large"), std::string::npos) << message;
  EXPECT_EQ(reader().whole<Real>("number")[0], 1);
  EXPECT_FALSE(std::filesystem::exists(folder_ + "/checkpoint.h5.part"));
  MPI_Barrier(MPI_COMM_WORLD);
  write_number(3, 2, folder_, world_);
  EXPECT_EQ(reader().whole<Real>("number")[0], 3);
}

}  // namespace
}  // namespace porefines::test
