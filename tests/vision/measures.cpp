// SPDX-License-Identifier: MPL-2.0
#include "vision/measures.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace porefines::vision {
namespace {

/// A particle that moves by a pixel along x in every frame.
Path walk(Real x, Real y, int first, int frames) {
  Path path;
  for (int f = first; f < first + frames; ++f) {
    path.push_back({f, x + f, y});
  }
  return path;
}

Path moved(Path path, Real dx) {
  for (PathPoint& p : path) {
    p.x += dx;
  }
  return path;
}

TEST(Measures, of_the_truth_are_perfect) {
  const std::vector<Path> truth{walk(0, 0, 0, 10), walk(3, 40, 2, 5)};
  const Agreement a = measure(truth, {truth[1], truth[0]});
  EXPECT_EQ(a.alpha, 1);
  EXPECT_EQ(a.beta, 1);
  EXPECT_EQ(a.jaccard, 1);
  EXPECT_EQ(a.jaccard_tracks, 1);
  EXPECT_EQ(a.rmse, 0);
}

TEST(Measures, of_nothing_are_zero) {
  const Agreement a = measure({walk(0, 0, 0, 10)}, {});
  EXPECT_EQ(a.alpha, 0);
  EXPECT_EQ(a.beta, 0);
  EXPECT_EQ(a.jaccard, 0);
  EXPECT_EQ(a.jaccard_tracks, 0);
}

TEST(Measures, of_an_offset_by_a_pixel) {
  const std::vector<Path> truth{walk(0, 0, 0, 10)};
  const Agreement a = measure(truth, {moved(truth[0], 1)});
  EXPECT_DOUBLE_EQ(a.alpha, 1 - 1 / isbi_gate);
  EXPECT_DOUBLE_EQ(a.beta, a.alpha);
  EXPECT_EQ(a.jaccard, 1);
  EXPECT_DOUBLE_EQ(a.rmse, 1);
}

/// 10 true positions; found are the first 6 of them in one track and the last 4 in another. The long
/// half is the partner, the short one spurious: alpha = 6/10, beta = (50 - 20) / (50 + 20).
TEST(Measures, of_a_track_broken_in_two) {
  const Path whole = walk(0, 0, 0, 10);
  const Agreement a = measure(
      {whole}, {Path(whole.begin(), whole.begin() + 6), Path(whole.begin() + 6, whole.end())});
  EXPECT_DOUBLE_EQ(a.alpha, 0.6);
  EXPECT_DOUBLE_EQ(a.beta, 30.0 / 70);
  EXPECT_DOUBLE_EQ(a.jaccard, 6.0 / 14);
  EXPECT_DOUBLE_EQ(a.jaccard_tracks, 0.5);
}

/// Two particles whose tracks swap identities half-way: each has 5 right and 5 wrong positions.
TEST(Measures, of_swapped_identities) {
  const Path a = walk(0, 0, 0, 10);
  const Path b = walk(0, 40, 0, 10);
  Path ab(a.begin(), a.begin() + 5);
  ab.insert(ab.end(), b.begin() + 5, b.end());
  Path ba(b.begin(), b.begin() + 5);
  ba.insert(ba.end(), a.begin() + 5, a.end());
  const Agreement m = measure({a, b}, {ab, ba});
  EXPECT_DOUBLE_EQ(m.alpha, 0.5);
  EXPECT_DOUBLE_EQ(m.jaccard, 10.0 / 30);
  EXPECT_DOUBLE_EQ(m.jaccard_tracks, 1);
}

/// A false track costs beta and Jaccard, not alpha; a position beyond the gate counts as missed.
TEST(Measures, of_what_is_not_there) {
  const Path a = walk(0, 0, 0, 10);
  Agreement m = measure({a}, {a, walk(0, 100, 0, 10)});
  EXPECT_EQ(m.alpha, 1);
  EXPECT_DOUBLE_EQ(m.beta, 0.5);
  EXPECT_DOUBLE_EQ(m.jaccard, 0.5);
  EXPECT_DOUBLE_EQ(m.jaccard_tracks, 0.5);
  Path far = a;
  far[3].y += 6;
  m = measure({a}, {far});
  EXPECT_DOUBLE_EQ(m.alpha, 0.9);
  EXPECT_DOUBLE_EQ(m.jaccard, 9.0 / 11);
}

}  // namespace
}  // namespace porefines::vision
