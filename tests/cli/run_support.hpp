// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <cmath>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.hpp"
#include "support/scratch.hpp"

namespace porefines::test {

/// Runs a command in a folder, on several ranks by mpirun.
inline ProgramResult run_on(int ranks, const Scratch& folder, std::vector<std::string> words) {
  if (ranks > 1) {
    words.insert(words.begin(), {"mpirun", "--oversubscribe", "-n", std::to_string(ranks)});
  }
  return run_in(folder.path(), words);
}

inline std::string read_text(const std::string& path) {
  std::ifstream file(path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// A number of a flat JSON text; NaN when the key is missing or not a number.
inline double number(const std::string& json, const std::string& key) {
  std::smatch match;
  const std::regex wanted("\"" + key + "\": ([-+0-9.e]+)");
  return std::regex_search(json, match, wanted) ? std::stod(match[1]) : std::nan("");
}

/// A table by columns.
struct Csv {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  [[nodiscard]] double at(std::size_t row, const std::string& name) const {
    for (std::size_t c = 0; c < names.size(); ++c) {
      if (names[c] == name) {
        return std::stod(rows.at(row).at(c));
      }
    }
    ADD_FAILURE() << "no column " << name;
    return std::nan("");
  }
};

inline Csv read_csv(const std::string& path) {
  Csv csv;
  std::istringstream lines(read_text(path));
  for (std::string line; std::getline(lines, line);) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; std::getline(stream, word, ',');) {
      words.push_back(word);
    }
    (csv.names.empty() ? csv.names : csv.rows.emplace_back()) = words;
  }
  return csv;
}

/// Top and bottom of glass, open at both ends: k = h^2 / 12.
inline constexpr auto chip_case =
    "[geometry]\n"
    "kind = \"empty\"\n"
    "size = [\"32 um\", \"16 um\", \"16 um\"]\n"
    "[grid]\n"
    "cells = [32, 16, 16]\n"
    "[flow]\n"
    "inlet = { face = \"x-\", pressure = \"101337 Pa\" }\n"
    "outlet = { face = \"x+\", pressure = \"101325 Pa\" }\n"
    "walls = [\"z-\", \"z+\"]\n"
    "slip = [\"y-\", \"y+\"]\n";

/// One sphere of a periodic cubic array.
inline constexpr auto sphere_case =
    "[geometry]\n"
    "kind = \"spheres\"\n"
    "source = \"one.txt\"\n"
    "size = [\"1 mm\", \"1 mm\", \"1 mm\"]\n"
    "[grid]\n"
    "cells = [16, 16, 16]\n"
    "[flow]\n"
    "periodic = [\"x\", \"y\", \"z\"]\n"
    "pressure_gradient = \"1 Pa/m\"\n";

inline constexpr auto sphere_list = "5e-4 5e-4 5e-4 3.7221029e-4\n";

}  // namespace porefines::test
