// SPDX-License-Identifier: MPL-2.0
// Keys of the run as a whole, and of what it writes.
#include "config/item_key.hpp"

namespace porefines::config {
namespace {

void read_output_dir(Case& c, const Node& node) {
  c.run.output_dir = read_text(node);
  if (c.run.output_dir.empty()) {
    fail(node.place, "is empty, name a folder");
  }
}

std::vector<ItemKey<Output>> output_items() {
  return {choice_item(
              "kind", &Output::kind, {"fields", "pictures", "tracks", "summary", "movie"},
              "`fields`: fields.xdmf and HDF5; `pictures`: PNG; `tracks`: tracks.csv, a row "
              "per particle and sample; `summary`: series.csv, a row per sample, and with a flow "
              "the clogging log, retention and pressures at throats; `movie`: movie.mp4"),
          quantity_item("every", &Output::every, kind::time, above_zero,
                        "a hundredth of the run; pictures: at the end",
                        "simulated time from sample to sample"),
          only_where([](const Output& o) { return o.kind == OutputKind::tracks; },
                     flag_item("forces", &Output::forces, "tracks: forces and torques too")),
          only_where([](const Output& o) { return o.kind == OutputKind::movie; },
                     integer_item("frame_rate", &Output::frame_rate, Range{1, 120},
                                  "movie: frames a second"))};
}

/// A kind must be said: its default is only there to be overwritten.
Key output_key() {
  Key key = list_key("output", &Case::output, output_items(),
                     "what is written besides summary.json; the default is fields and pictures, "
                     "and for particles tracks and summary too");
  key.read = [read = key.read](Case& c, const Node& node) {
    read(c, node);
    for (std::size_t i = 0; i < c.output.size(); ++i) {
      const Node& element = item_node(node, "", i);
      if (find(element, "kind") == nullptr) {
        fail(element.place, "needs a kind", "write kind = \"fields\" or kind = \"pictures\"");
      }
    }
  };
  return key;
}

/// "9.81 m/s^2" acts along -z, three components as they are.
void read_gravity(Case& c, const Node& node) {
  constexpr Range accelerations{-1e6, 1e6};
  if (std::holds_alternative<List>(node.value)) {
    c.gravity = read_triple(node, kind::acceleration, accelerations);
  } else {
    c.gravity = {0, 0, -read_quantity(node, kind::acceleration, accelerations)};
  }
}

}  // namespace

std::vector<Key> run_keys() {
  return {
      text_key("title", &Case::run, &Run::title, "none", "what the report is headed with"),
      text_key("reference", &Case::run, &Run::reference, "none",
               "the publication that the case follows"),
      {"gravity", "acceleration, e.g. `\"9.81 m/s^2\"` downwards along z, or a list of three",
       "acts on particles; none unless it is given", read_gravity,
       [](const Case& c) {
         return c.gravity == Triple{} ? "" : write_triple(c.gravity, kind::acceleration);
       },
       "none"},
      output_key(),
      particles_key(),
      injection_key(),
      surface_key(),
      drive_key(),
      probe_key(),
      {"run.output_dir", "text",
       "folder of the results, relative to the working directory; `-o` overrides it",
       read_output_dir, [](const Case& c) { return toml_string(c.run.output_dir); }},
      integer_key("run.random_seed", &Case::run, &Run::random_seed, not_negative,
                  "seed of every random number; the same on any number of ranks"),
      quantity_key("run.end_time", &Case::run, &Run::end_time, kind::time, above_zero,
                   "required with moving particles", "simulated time at which the run ends"),
      quantity_key("run.max_wall", &Case::run, &Run::max_wall, kind::time, above_zero, "no limit",
                   "wall time after which the run ends, with its results so far"),
      quantity_key("run.max_pore_volumes", &Case::run, &Run::max_pore_volumes, kind::number,
                   above_zero, "no limit", "pore volumes of fluid after which the run ends"),
      integer_key("run.max_clogged_throats", &Case::run, &Run::max_clogged_throats, Range{0, 1e9},
                  "clogged throats at which the run ends; 0: no limit"),
      quantity_key("run.min_permeability_ratio", &Case::run, &Run::min_permeability_ratio,
                   kind::number, above_zero, "no limit", "k/k0 at which the run ends"),
      quantity_key(
          "checkpoint.every", &Case::checkpoint, &Checkpoint::every, kind::time, above_zero, "",
          "wall time between two checkpoint.h5, from which `--restart` goes on; one more is "
          "written at the end, at SIGINT and at SIGTERM"),
      integer_key("checkpoint.keep", &Case::checkpoint, &Checkpoint::keep, Range{1, 9},
                  "how many of them stay: checkpoint_1.h5 is the one before checkpoint.h5"),
  };
}

}  // namespace porefines::config
