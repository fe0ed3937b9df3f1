// SPDX-License-Identifier: MPL-2.0
#include "vision/settings.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>

#include "config/value.hpp"
#include "core/error.hpp"

namespace porefines::vision {
namespace {

using config::Node;
using config::Range;

TrackKey quantity(const std::string& path, Real TrackSettings::*member, const QuantityKind& kind,
                  const std::string& absent, const std::string& doc) {
  return {path, fmt::format("{}, e.g. `\"{}\"`", kind.name, kind.example), absent, doc,
          [=](TrackSettings& s, const Node& node) {
            s.*member = config::read_quantity(node, kind, config::above_zero);
          }};
}

TrackKey whole(const std::string& path, int TrackSettings::*member, int low,
               const std::string& absent, const std::string& doc) {
  const Range range{static_cast<Real>(low), 1e9};
  return {path, fmt::format("whole number, {} or more", low), absent, doc,
          [=](TrackSettings& s, const Node& node) {
            s.*member = static_cast<int>(config::read_integer(node, range));
          }};
}

TrackKey number(const std::string& path, std::optional<Real> DetectWishes::*member,
                const std::string& absent, const std::string& doc) {
  return {path, "number above 0", absent, doc, [=](TrackSettings& s, const Node& node) {
            s.detect.*member = config::read_quantity(node, kind::number, config::above_zero);
          }};
}

template <typename Set>
TrackKey choice(const std::string& path, const std::vector<std::string>& words,
                const std::string& absent, const std::string& doc, const Set& set) {
  std::string type;
  for (const std::string& word : words) {
    type += (type.empty() ? "`\"" : ", `\"") + word + "\"`";
  }
  return {path, type, absent, doc,
          [=](TrackSettings& s, const Node& node) { set(s, config::read_choice(node, words)); }};
}

std::string path_in(const Node& node) {
  const std::filesystem::path path = config::read_text(node);
  const bool from_file = path.is_relative() && !node.place.command_line;
  return from_file ? (std::filesystem::path(node.place.file).parent_path() / path).string()
                   : path.string();
}

std::vector<TrackKey> video_keys() {
  return {
      quantity("video.frame_rate", &TrackSettings::frame_rate, kind::frequency,
               "what the video says", "frames per second"),
      quantity("video.pixel_size", &TrackSettings::pixel_size, kind::length, "required",
               "edge of a pixel in the sample"),
      whole("video.start", &TrackSettings::start, 0, "0", "first frame, counted from 0"),
      whole("video.stop", &TrackSettings::stop, 0, "the end", "last frame"),
      {"video.region", "`[left, top, width, height]` in pixels", "the whole frame",
       "only particles in it are looked for",
       [](TrackSettings& s, const Node& node) {
         const auto& list = config::read_list(node, "[0, 0, 640, 424]");
         if (list.size() != 4) {
           config::fail(node.place, "needs four whole numbers: left, top, width, height");
         }
         for (std::size_t k = 0; k < 4; ++k) {
           s.region[k] =
               static_cast<int>(config::read_integer(list[k], Range{k < 2 ? 0.0 : 1.0, 1e6}));
         }
       }},
      {"video.annotate", "true or false", "true", "write annotated.avi",
       [](TrackSettings& s, const Node& node) { s.video = config::read_flag(node); }},
  };
}

std::vector<TrackKey> detect_keys() {
  return {
      choice("detect.polarity", {"bright", "dark"}, "estimated", "particles against the water",
             [](TrackSettings& s, std::size_t k) { s.detect.dark = k == 1; }),
      quantity("detect.diameter", &TrackSettings::diameter, kind::length, "estimated",
               "of the picture of a particle with its blur"),
      quantity("detect.separation", &TrackSettings::separation, kind::length,
               "0.6 diameters; one pixel more than the diameter where particles are faint",
               "of two that are nearer, the one with less light goes"),
      number("detect.least_mass", &DetectWishes::least_mass, "estimated",
             "light of the faintest particle, sum of grey levels"),
      number("detect.threshold", &DetectWishes::threshold, "estimated",
             "grey levels above the background that count"),
      number("detect.blur", &DetectWishes::noise, "1",
             "standard deviation of the first blur in pixels"),
      choice("detect.centre", {"contour", "centroid", "gaussian"},
             "gaussian; centroid where particles are faint", "how centres are found",
             [](TrackSettings& s, std::size_t k) { s.detect.centre = static_cast<Centre>(k); }),
      {"detect.whole_levels", "true or false", "where 8-bit particles are faint",
       "background in whole grey levels",
       [](TrackSettings& s, const Node& node) { s.detect.whole_levels = config::read_flag(node); }},
      choice("detect.grains", {"auto", "none", "dark", "bright"}, "auto",
             "how grains look in the frames (in the mask: dark unless bright)",
             [](TrackSettings& s, std::size_t k) { s.grains = static_cast<GrainKind>(k); }),
      {"detect.mask", "image", "found from the frames", "where the grains are",
       [](TrackSettings& s, const Node& node) { s.mask = path_in(node); }},
      choice(
          "detect.background", {"auto", "none", "median"}, "median where there are grains",
          "what is taken away before particles are looked for",
          [](TrackSettings& s, std::size_t k) { s.background = static_cast<BackgroundKind>(k); }),
  };
}

std::vector<TrackKey> link_keys() {
  return {
      choice("link.method", {"assignment", "thesis"}, "assignment", "how frames are joined",
             [](TrackSettings& s, std::size_t k) { s.method = static_cast<LinkMethod>(k); }),
      quantity("link.max_speed", &TrackSettings::max_speed, kind::velocity, "estimated",
               "nothing moves faster"),
      whole("link.memory", &TrackSettings::memory, 0, "3",
            "frames that a particle may be out of sight"),
      whole("link.min_length", &TrackSettings::min_length, 1, "3", "shorter tracks are dropped"),
      choice("link.flow", {"x+", "x-", "y+", "y-"}, "none",
             "main direction; the thesis's criterion needs it",
             [](TrackSettings& s, std::size_t k) {
               s.flow = {k == 0 ? 1 : k == 1 ? -1 : 0, k == 2 ? 1 : k == 3 ? -1 : 0};
             }),
      {"link.least_slope", "number above 0", "1", "thesis: least slope of a step against the flow",
       [](TrackSettings& s, const Node& node) {
         s.least_slope = config::read_quantity(node, kind::number, config::above_zero);
       }},
      {"link.velocity_field", "folder of a run", "the mean flow found from the positions",
       "its fields.h5 predicts the steps",
       [](TrackSettings& s, const Node& node) { s.velocity_field = path_in(node); }},
      quantity("link.stuck_time", &TrackSettings::stuck_time, kind::time,
               "40 frames, or half of a shorter video", "at rest for so long: stuck"),
  };
}

void require_known(const Node& root) {
  std::vector<std::string> tables;
  for (const TrackKey& key : track_keys()) {
    const std::string table = key.path.substr(0, key.path.find('.'));
    if (std::find(tables.begin(), tables.end(), table) == tables.end()) {
      tables.push_back(table);
    }
  }
  for (const config::Entry& entry : config::read_table(root, tables)) {
    std::vector<std::string> names;
    for (const TrackKey& key : track_keys()) {
      if (key.path.starts_with(entry.name + ".")) {
        names.push_back(key.path.substr(entry.name.size() + 1));
      }
    }
    (void)config::read_table(entry.node, names);
  }
}

}  // namespace

const std::vector<TrackKey>& track_keys() {
  static const std::vector<TrackKey> keys = [] {
    std::vector<TrackKey> all = video_keys();
    for (const auto& part : {detect_keys(), link_keys()}) {
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }();
  return keys;
}

TrackSettings load_track(const std::string& path, const std::vector<std::string>& overrides) {
  std::string text;
  if (!path.empty()) {
    std::ifstream file(path);
    if (!file) {
      throw InputError(path + ": no such track file");
    }
    std::ostringstream content;
    content << file.rdbuf();
    text = content.str();
  }
  Node root = config::parse_toml(text, path.empty() ? "command line" : path);
  for (const std::string& assignment : overrides) {
    config::apply_override(root, assignment);
  }
  require_known(root);
  TrackSettings settings;
  for (const TrackKey& key : track_keys()) {
    if (const Node* node = config::find(root, key.path)) {
      key.read(settings, *node);
    }
  }
  if (settings.stop >= 0 && settings.stop < settings.start) {
    config::fail(config::place_of(root, "video.stop"),
                 fmt::format("is before the first frame, {}", settings.start));
  }
  return settings;
}

std::string track_reference() {
  std::string text = "| key | value | when absent | meaning |\n|---|---|---|---|\n";
  for (const TrackKey& key : track_keys()) {
    text += fmt::format("| `{}` | {} | {} | {} |\n", key.path, key.type, key.absent, key.doc);
  }
  return text;
}

}  // namespace porefines::vision
