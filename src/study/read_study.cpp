// SPDX-License-Identifier: MPL-2.0
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "config/value.hpp"
#include "core/error.hpp"
#include "study/collect.hpp"
#include "study/read_axis.hpp"
#include "study/study.hpp"

namespace porefines::study {
namespace {

namespace fs = std::filesystem;
using config::Node;

const std::vector<std::string> known{
    "title",      "reference", "case",       "set",       "ranks",    "side_by_side", "seeds",
    "first_seed", "retries",   "confidence", "resamples", "readings", "output_dir",   "axis"};

std::vector<std::string> read_texts(const Node& node, const std::string& example) {
  std::vector<std::string> texts;
  for (const Node& element : config::read_list(node, example)) {
    texts.push_back(config::read_text(element));
  }
  return texts;
}

void read_whole(const Node& root, const std::string& name, int low, int& value) {
  if (const Node* node = config::find(root, name)) {
    value = static_cast<int>(config::read_integer(*node, {static_cast<Real>(low), 1e6}));
  }
}

std::string case_beside(const Node& root, const std::string& path) {
  const Node* node = config::find(root, "case");
  if (node == nullptr) {
    config::fail(root.place, "needs a case", "case = \"case.toml\", from the folder of this file");
  }
  const fs::path file = fs::path(path).parent_path() / config::read_text(*node);
  return file.lexically_normal().string();
}

void read_axes(Study& study, const Node& root) {
  const Node* node = config::find(root, "axis");
  if (node == nullptr) {
    return;
  }
  if (std::holds_alternative<config::Table>(node->value)) {
    study.axes.push_back(read_axis(*node));
    return;
  }
  for (const Node& element : config::read_list(*node, "[[axis]]")) {
    study.axes.push_back(read_axis(element));
  }
}

void check(const Study& study, const Node& root) {
  if (study.axes.empty() && study.seeds == 0) {
    config::fail(root.place, "changes nothing",
                 "give an [[axis]] with key and values, or seeds = 20 for repeats");
  }
  for (const Axis& axis : study.axes) {
    const auto sets_seed = std::find(axis.keys.begin(), axis.keys.end(), "run.random_seed");
    if (study.seeds > 0 && sets_seed != axis.keys.end()) {
      config::fail(axis.place, "changes run.random_seed, and so does seeds",
                   "keep seeds = N: its statistics take repeats together");
    }
  }
  if (const Node* node = config::find(root, "readings")) {
    for (const std::string& reading : study.readings) {
      if (const std::string problem = reading_problem(reading); !problem.empty()) {
        config::fail(node->place, problem, reading_help);
      }
    }
  }
}

}  // namespace

Study parse_study(const std::string& text, const std::string& path,
                  const std::vector<std::string>& overrides) {
  Node root = config::parse_toml(text, path);
  for (const std::string& assignment : overrides) {
    config::apply_override(root, assignment);
  }
  (void)config::read_table(root, known);
  Study study;
  study.path = path;
  study.case_file = case_beside(root, path);
  const auto text_of = [&](const std::string& name, std::string& value) {
    if (const Node* node = config::find(root, name)) {
      value = config::read_text(*node);
    }
  };
  text_of("title", study.title);
  study.output_dir = "out/" + fs::absolute(path).parent_path().filename().string();
  text_of("output_dir", study.output_dir);
  if (const Node* node = config::find(root, "set")) {
    study.settings = read_texts(*node, "set = [\"run.end_time=1 s\"]");
  }
  study.readings = default_readings();
  if (const Node* node = config::find(root, "readings")) {
    study.readings = read_texts(*node, "readings = [\"permeability_ratio\"]");
  }
  read_whole(root, "ranks", 1, study.ranks);
  read_whole(root, "side_by_side", 0, study.side_by_side);
  read_whole(root, "seeds", 0, study.seeds);
  read_whole(root, "first_seed", 0, study.first_seed);
  read_whole(root, "retries", 0, study.retries);
  read_whole(root, "resamples", 100, study.resamples);
  if (const Node* node = config::find(root, "confidence")) {
    study.confidence = config::read_quantity(*node, kind::number, {0.5, 0.9999});
  }
  read_axes(study, root);
  check(study, root);
  return study;
}

Study read_study(const std::string& path, const std::vector<std::string>& overrides) {
  std::ifstream file(path);
  if (!file || fs::is_directory(path)) {
    throw InputError(
        fmt::format("{}: cannot be read; the first argument is a study file in TOML", path));
  }
  return parse_study({std::istreambuf_iterator<char>(file), {}}, path, overrides);
}

}  // namespace porefines::study
