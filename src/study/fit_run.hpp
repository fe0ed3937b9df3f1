// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>

#include "analysis/deep_bed.hpp"

namespace porefines::study {

/// A run's output folder as deep-bed filtration sees it.
struct RunBed {
  analysis::Bed bed;
  analysis::BedData data;
  Real pores = 0;  ///< length over the equivalent pore diameter: how many pores deep the sample is
};

/// From summary.json (length, porosity, clean permeability), series.csv and the last profile of retention.csv.
///
///     s = retained_fraction porosity_clean,   k0/k = 1 / permeability_ratio,
///     c0 = fines that came in / suspension that came in, while they did
///
/// @throws InputError  a file or column that is missing
[[nodiscard]] RunBed read_run_bed(const std::string& folder);

/// Fits and writes fit.json, fit_retention.png, fit_breakthrough.png, fit_permeability.png; says the result.
void fit_run(const std::string& folder, const std::string& output, Real confidence, int resamples);

}  // namespace porefines::study
