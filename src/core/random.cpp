// SPDX-License-Identifier: MPL-2.0
#include "core/random.hpp"

#include <cmath>
#include <numbers>

namespace porefines {
namespace {

/// High and low half of a 64-bit product.
std::array<std::uint32_t, 2> multiply(std::uint32_t a, std::uint32_t b) {
  const std::uint64_t product = std::uint64_t{a} * b;
  return {static_cast<std::uint32_t>(product >> 32), static_cast<std::uint32_t>(product)};
}

std::uint32_t low_word(std::uint64_t x) {
  return static_cast<std::uint32_t>(x);
}
std::uint32_t high_word(std::uint64_t x) {
  return static_cast<std::uint32_t>(x >> 32);
}

}  // namespace

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                    std::array<std::uint32_t, 2> key) {
  constexpr int rounds = 10;
  constexpr std::uint32_t multiplier_0 = 0xD2511F53;
  constexpr std::uint32_t multiplier_1 = 0xCD9E8D57;
  constexpr std::uint32_t golden_ratio = 0x9E3779B9;
  constexpr std::uint32_t root_of_three = 0xBB67AE85;
  for (int round = 0; round < rounds; ++round) {
    const auto [high_0, low_0] = multiply(multiplier_0, counter[0]);
    const auto [high_1, low_1] = multiply(multiplier_1, counter[2]);
    counter = {high_1 ^ counter[1] ^ key[0], low_1, high_0 ^ counter[3] ^ key[1], low_0};
    key[0] += golden_ratio;
    key[1] += root_of_three;
  }
  return counter;
}

Draws::Draws(std::uint64_t seed, Stream stream, std::uint64_t id, std::uint32_t drawn)
    : key_{low_word(seed), high_word(seed)},
      counter_{0, static_cast<std::uint32_t>(stream), low_word(id), high_word(id)},
      drawn_(drawn) {}

Real Draws::uniform() {
  counter_[0] = drawn_ / 2;  // a block holds two numbers of 64 bits
  const auto block = philox(counter_, key_);
  const std::size_t half = 2 * (drawn_ % 2);
  ++drawn_;
  const std::uint64_t bits = (std::uint64_t{block[half + 1]} << 32) | block[half];
  return static_cast<Real>(bits >> 11) * 0x1.0p-53;
}

Real Draws::normal() {
  const Real r = std::sqrt(-2 * std::log(1 - uniform()));
  return r * std::cos(2 * std::numbers::pi * uniform());
}

Real Draws::lognormal(Real mean, Real standard_deviation) {
  const auto [m, s] = lognormal_parameters(mean, standard_deviation);
  return std::exp(m + s * normal());
}

std::int64_t Draws::poisson(Real mean) {
  // Waiting times are exponential: count how many fit into `mean`.
  std::int64_t events = 0;
  Real time = -std::log(1 - uniform());
  while (time < mean) {
    ++events;
    time -= std::log(1 - uniform());
  }
  return events;
}

Vec3 Draws::direction() {
  const Real z = uniform(-1, 1);
  const Real angle = uniform(0, 2 * std::numbers::pi);
  const Real r = std::sqrt(1 - z * z);
  return {r * std::cos(angle), r * std::sin(angle), z};
}

std::array<Real, 2> lognormal_parameters(Real mean, Real standard_deviation) {
  const Real s2 = std::log1p(standard_deviation * standard_deviation / (mean * mean));
  return {std::log(mean) - s2 / 2, std::sqrt(s2)};
}

}  // namespace porefines
