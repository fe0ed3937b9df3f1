// SPDX-License-Identifier: MPL-2.0
// The deep-bed fit on files of a real coupled run.
#include "study/fit_run.hpp"

#include <cmath>
#include <numeric>

#include <gtest/gtest.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json_read.hpp"
#include "support/scratch.hpp"

namespace porefines::study {
namespace {

/// cases/throat/bridging.toml at ratio 1.5, seed 18: series and the last profile, six digits.
const std::string recorded = PF_SOURCE_DIR "/tests/data/throat_run";

/// What the fit says is caught on the way is, within its interval, what the profile holds of what came in.
TEST(FitRun, catches_what_the_run_has_caught) {
  const RunBed run = read_run_bed(recorded);
  EXPECT_NEAR(run.bed.length, 64e-6, 1e-9);
  EXPECT_LT(run.pores, 20);
  const Real held = std::accumulate(run.data.s.begin(), run.data.s.end(), Real{0}) /
                    static_cast<Real>(run.data.s.size());
  const Real came_in = run.bed.feed * run.bed.porosity * run.data.profile_at;
  const analysis::BedFit fit = analysis::fit_bed(run.bed, run.data, 0.95, 200, 1);
  const Real share = held / came_in;
  EXPECT_GT(share, 0);
  EXPECT_LT(1 - std::exp(-fit.lambda.low * run.bed.length), share);
  EXPECT_GT(1 - std::exp(-fit.lambda.high * run.bed.length), share);
  EXPECT_GT(fit.beta.low, 0);
}

TEST(FitRun, writes_its_results_and_says_what_is_missing) {
  const test::Scratch folder;
  fit_run(recorded, folder.path(), 0.9, 50);
  const auto json = read_flat_json(folder / "fit.json");
  ASSERT_TRUE(json);
  EXPECT_GT(json->number("lambda_per_m"), json->number("lambda_per_m_low"));
  EXPECT_LT(json->number("beta"), json->number("beta_high"));
  EXPECT_DOUBLE_EQ(json->number("confidence"), 0.9);
  EXPECT_THROW(fit_run(folder / "none", folder.path(), 0.9, 50), InputError);
  write_file(folder / "summary.json", "{\n  \"length_m\": 1\n}\n");
  EXPECT_THROW(fit_run(folder.path(), folder.path(), 0.9, 50), InputError);
}

}  // namespace
}  // namespace porefines::study
