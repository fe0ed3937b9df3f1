// SPDX-License-Identifier: MPL-2.0
#include "core/random.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace porefines {
namespace {

constexpr std::uint64_t samples = 100'000;

struct Moments {
  Real mean = 0;
  Real deviation = 0;
};

/// Of one draw of each of many ids, which is how particles use it.
template <typename Draw>
Moments moments(const Draw& draw) {
  Real sum = 0;
  Real squares = 0;
  for (std::uint64_t id = 0; id < samples; ++id) {
    Draws draws(2021, Stream::size, id);
    const auto x = static_cast<Real>(draw(draws));
    sum += x;
    squares += x * x;
  }
  const Real mean = sum / samples;
  return {mean, std::sqrt(squares / samples - mean * mean)};
}

TEST(Random, gives_the_known_answers_of_its_authors) {
  // kat_vectors of Random123: nothing, everything, the digits of pi.
  using Block = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox({0, 0, 0, 0}, {0, 0}), (Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  constexpr std::uint32_t ones = 0xffffffff;
  EXPECT_EQ(philox({ones, ones, ones, ones}, {ones, ones}),
            (Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

TEST(Random, resumes_where_it_stopped) {
  Draws whole(7, Stream::place, 1ULL << 40);
  for (std::uint32_t n = 0; n < 9; ++n) {
    Draws resumed(7, Stream::place, 1ULL << 40, n);
    EXPECT_EQ(whole.uniform(), resumed.uniform()) << n;
  }
  EXPECT_EQ(whole.drawn(), 9U);
}

TEST(Random, seed_stream_and_id_each_matter) {
  const auto first = [](std::uint64_t seed, Stream stream, std::uint64_t id) {
    return Draws(seed, stream, id).uniform();
  };
  const Real one = first(1, Stream::size, 1);
  EXPECT_NE(one, first(2, Stream::size, 1));
  EXPECT_NE(one, first(1ULL << 32 | 1, Stream::size, 1));
  EXPECT_NE(one, first(1, Stream::place, 1));
  EXPECT_NE(one, first(1, Stream::size, 2));
  EXPECT_NE(one, first(1, Stream::size, 1ULL << 32 | 1));
}

// Tolerances: five standard errors, s / sqrt(N) of a mean and about s sqrt(k / 4N) of a deviation,
// k the kurtosis less one. The draws are fixed, so these tests pass or fail for good.
TEST(Random, uniform_has_its_moments) {
  const Moments m = moments([](Draws& draws) { return draws.uniform(2, 5); });
  EXPECT_NEAR(m.mean, 3.5, 0.014);
  EXPECT_NEAR(m.deviation, 3 / std::sqrt(12.0), 0.007);
}

TEST(Random, normal_has_its_moments) {
  const Moments m = moments([](Draws& draws) { return draws.normal(); });
  EXPECT_NEAR(m.mean, 0, 0.016);
  EXPECT_NEAR(m.deviation, 1, 0.012);
  const Moments fourth = moments([](Draws& draws) { return std::pow(draws.normal(), 4); });
  EXPECT_NEAR(fourth.mean, 3, 0.16);
}

TEST(Random, lognormal_has_its_moments) {
  const Moments m = moments([](Draws& draws) { return draws.lognormal(5, 1.5); });
  EXPECT_NEAR(m.mean, 5, 0.024);
  EXPECT_NEAR(m.deviation, 1.5, 0.027);
}

TEST(Random, poisson_has_its_moments) {
  const Moments m = moments([](Draws& draws) { return draws.poisson(4); });
  EXPECT_NEAR(m.mean, 4, 0.032);
  EXPECT_NEAR(m.deviation, 2, 0.025);
}

TEST(Random, directions_fill_the_sphere) {
  Vec3 sum;
  Real along_z = 0;
  for (std::uint64_t id = 0; id < samples; ++id) {
    const Vec3 n = Draws(3, Stream::place, id).direction();
    EXPECT_NEAR(norm(n), 1, 1e-14);
    sum += n;
    along_z += n.z * n.z;
  }
  EXPECT_LT(norm(sum) / samples, 0.01);
  EXPECT_NEAR(along_z / samples, 1.0 / 3, 0.005);
}

}  // namespace
}  // namespace porefines
