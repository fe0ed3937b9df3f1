// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/types.hpp"

namespace porefines::validate {

/// A run of the program. Jobs of one comparison have names of their own.
struct Job {
  std::string name = {};
  std::string case_text = {};                                   ///< case.toml
  std::vector<std::pair<std::string, std::string>> files = {};  ///< beside it: name, content
  std::vector<std::vector<std::string>> after =
      {};                                  ///< commands after the run; "copy" FROM TO copies a file
  std::vector<std::string> generate = {};  ///< words after `porefines`, run before
  std::vector<std::string> instead = {};   ///< the same, in place of a run of the case
  std::vector<std::string> set = {};       ///< words key=value of the run
};

/// A number of a flat JSON file of a job: offset + factor times it.
struct FromSummary {
  std::string key = {};
  Real factor = 1;
  Real offset = 0;
  std::string file = "out/summary.json";
};

/// What a column of tracks.csv comes to for one particle, times a factor: its last value, less or over the first.
struct FromTracks {
  enum class Measure { last, change, ratio };
  Index id = 0;
  std::string column = {};
  Measure measure = Measure::last;
  Real factor = 1;
};

/// Numbers of a key on three grids whose cells are h1 > h2 > h3, extrapolated to cells of size 0 with the
/// second order of the scheme: f = f3 + (f3 - f2) h3^2 / (h2^2 - h3^2). The row also shows the change from f3, its error bar.
struct Extrapolated {
  std::string key = {};
  std::vector<Real> cells = {};  ///< [m] of the jobs at `job` and after it
};

/// Of the jobs at `job` and after it.
using Folders = std::span<const std::string>;

/// Whatever else a number is read from.
struct Computed {
  std::function<Real(Folders folders)> read;
};

using Source = std::variant<FromSummary, FromTracks, Extrapolated, Computed>;

/// One line of a table: a number of a run beside the one that it should be.
struct Row {
  std::string label = {};
  Real x = 0;  ///< place of the row in the figure
  std::size_t job = 0;
  Source source = FromSummary{};
  Real reference = 0;
  Real tolerance = 0;                 ///< relative; where the reference is 0, absolute
  std::vector<Real> literature = {};  ///< further columns, see Comparison; NaN: none
};

/// A table of the validation page.
struct Comparison {
  std::string name = {};    ///< for --only and for its folder
  std::string folder = {};  ///< of the comparison whose jobs these are as well; empty: its own
  std::string title = {};
  std::string quantity = {};   ///< what the numbers are, with unit
  std::string along = {};      ///< what x is; empty: no figure
  std::string reference = {};  ///< where the references come from
  std::vector<Job> jobs = {};
  std::vector<Row> rows = {};
  std::vector<std::string> literature = {};  ///< names of the further columns
  std::vector<std::pair<std::string, std::string>> pictures =
      {};                    ///< of the first job: file, caption
  bool logarithmic = false;  ///< axis of the quantity
};

/// All comparisons, those that take longest last.
/// @param quick  without what takes more than a minute on a core
/// @param data   folder with the pictures of others, see add_videos
[[nodiscard]] std::vector<Comparison> all_comparisons(bool quick, const std::string& data);

// One function per file list_*.cpp.
void add_permeability(std::vector<Comparison>& list);  ///< references.md A1, A2, A3, A5
void add_contact(std::vector<Comparison>& list);       ///< references.md C
void add_impacts(std::vector<Comparison>& list);       ///< references.md C, Chung & Ooi 2011
void add_spheres(std::vector<Comparison>& list);       ///< references.md B3
void add_mobility(std::vector<Comparison>& list, bool quick);  ///< references.md B1, B2, B4 to B6
void add_inertia(std::vector<Comparison>& list, bool quick);   ///< references.md B7 to B10
void add_clogging(std::vector<Comparison>& list, bool quick);  ///< references.md E
void add_cylinder(std::vector<Comparison>& list, bool quick);  ///< thesis table 1, references.md A4
void add_microscope(std::vector<Comparison>& list);            ///< thesis figs. 17 to 19
void add_forces(std::vector<Comparison>& list);                ///< references.md D
/// references.md F, from the pictures of a folder like ../shared/data; nothing where it is empty.
void add_videos(std::vector<Comparison>& list, const std::string& data);
void add_chip(std::vector<Comparison>& list);  ///< thesis table 2

}  // namespace porefines::validate
