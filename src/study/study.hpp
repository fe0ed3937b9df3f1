// SPDX-License-Identifier: MPL-2.0
// What a study is: one case, the values that change, and what is read from every run.
#pragma once

#include <string>
#include <vector>

#include "config/place.hpp"
#include "core/types.hpp"

namespace porefines::study {

/// One step along an axis: a value for each of its keys.
struct AxisPoint {
  std::vector<std::string> values;  ///< as on the command line: "4 um"
  Real at = 0;                      ///< SI, where it lies in plots; its count where it is no number
  std::string label = {};  ///< for people: the word of `at`, else the first value, else all of them
};

/// [[axis]]: keys that change together. Axes multiply.
struct Axis {
  std::string name;
  std::string unit;  ///< SI, of `at`
  std::vector<std::string> keys;
  std::vector<AxisPoint> points;
  config::Place place;
};

/// A study file, checked.
struct Study {
  std::string path;
  std::string title;
  std::string case_file;
  std::vector<std::string> settings;  ///< key=value for every member
  std::vector<Axis> axes;
  int seeds = 0;  ///< repeats of every point; 0: one, with the seed of the case
  int first_seed = 1;
  int ranks = 1;         ///< of every member
  int side_by_side = 0;  ///< members at a time; 0: as many as the cores and memory hold
  int retries = 1;
  Real confidence = 0.95;
  int resamples = 1000;               ///< of the bootstrap
  std::vector<std::string> readings;  ///< columns of members.csv, see collect.hpp
  std::string output_dir;
};

/// One run.
struct Member {
  std::size_t number = 0;       ///< from 0, in order of the axes, the last one fastest, seeds last
  std::size_t group = 0;        ///< members that differ in nothing but their seed
  std::vector<std::size_t> at;  ///< which point of every axis
  int seed = 0;                 ///< 0: that of the case
  std::vector<std::string> settings;  ///< key=value
  std::string name;                   ///< of its folder: a hash of all that it depends on
};

/// @throws InputError  with file, line, key
/// @param overrides  from the command line, "seeds=2", "axis.0.count=3", applied in order
[[nodiscard]] Study read_study(const std::string& path,
                               const std::vector<std::string>& overrides = {});
[[nodiscard]] Study parse_study(const std::string& text, const std::string& path,
                                const std::vector<std::string>& overrides = {});

/// Every combination of the axes, `seeds` times; each is read as a case and so checked.
///
/// The folder of a member is named by a hash of its effective case: a study that is made larger keeps
/// what it has, and one whose case is changed begins anew.
/// @throws InputError  a member that is no valid case, naming the axis and its line
[[nodiscard]] std::vector<Member> expand(const Study& study);

/// "diameter 4 um, seed 3", for people.
[[nodiscard]] std::string describe(const Study& study, const Member& member);
/// The same without the seed.
[[nodiscard]] std::string describe_group(const Study& study, const Member& member);

}  // namespace porefines::study
