// SPDX-License-Identifier: MPL-2.0
// Keys of the run as a whole, and of what it writes.
#include "config/key.hpp"

namespace porefines::config {
namespace {

const std::vector<std::string>& output_kinds() {
  static const std::vector<std::string> kinds{"fields", "pictures"};
  return kinds;
}

void read_output_dir(Case& c, const Node& node) {
  c.run.output_dir = read_text(node);
  if (c.run.output_dir.empty()) {
    fail(node.place, "is empty, name a folder");
  }
}

void read_outputs(Case& c, const Node& node) {
  constexpr auto example = "[[output]] with kind = \"fields\"";
  c.output = {.fields = false, .pictures = false};
  for (const Node& element : read_list(node, example)) {
    for (const Entry& entry : read_table(element, {"kind", "every", "fields"})) {
      if (entry.name != "kind") {
        fail(entry.node.place, "not available in this version",
             "a steady flow is written once, with every field");
      }
    }
    const Node* kind = find(element, "kind");
    if (kind == nullptr) {
      fail(element.place, "needs a kind", "write kind = \"fields\" or kind = \"pictures\"");
    }
    const std::string& name = read_text(*kind);
    if (name == "tracks" || name == "summary") {
      fail(kind->place, toml_string(name) + " is not available in this version",
           name == "summary" ? "summary.json is always written, delete this table"
                             : "there are no moving particles to track yet");
    }
    (read_choice(*kind, output_kinds()) == 0 ? c.output.fields : c.output.pictures) = true;
  }
}

std::string write_outputs(const Case& c) {
  std::string list;
  list += c.output.fields ? "{ kind = \"fields\" }" : "";
  list += c.output.fields && c.output.pictures ? ", " : "";
  list += c.output.pictures ? "{ kind = \"pictures\" }" : "";
  return "[" + list + "]";
}

}  // namespace

std::vector<Key> run_keys() {
  return {
      text_key("title", &Case::run, &Run::title, "none", "what the report is headed with"),
      text_key("reference", &Case::run, &Run::reference, "none",
               "the publication that the case follows"),
      {"output", "list of tables with `kind`",
       "what is written besides summary.json: `\"fields\"` (fields.xdmf and HDF5), `\"pictures\"` "
       "(PNG); also as `[[output]]`",
       read_outputs, write_outputs},
      {"run.output_dir", "text",
       "folder of the results, relative to the working directory; `-o` overrides it",
       read_output_dir, [](const Case& c) { return toml_string(c.run.output_dir); }},
      integer_key("run.random_seed", &Case::run, &Run::random_seed, not_negative,
                  "seed of every random number; the same on any number of ranks"),
  };
}

}  // namespace porefines::config
