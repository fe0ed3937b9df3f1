// SPDX-License-Identifier: MPL-2.0
#include "sim/dry_checkpoint.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "config/writer.hpp"
#include "core/error.hpp"
#include "sim/particle_checkpoint.hpp"

namespace porefines::sim {
namespace {

/// Calls visit(number) for every real number of the state, in a fixed order.
template <typename State, typename Visit>
void for_reals(State& state, const Visit& visit) {
  visit(state.time), visit(state.step);
  visit(state.energy.start), visit(state.energy.injected), visit(state.energy.out);
  for (auto& inlet : state.inlets) {
    visit(inlet.due), visit(inlet.entered);
  }
}

template <typename State, typename Visit>
void for_counts(State& state, const Visit& visit) {
  visit(state.steps), visit(state.next_id);
  visit(state.ledger.placed), visit(state.ledger.injected), visit(state.ledger.out);
  for (auto& written : state.written) {
    visit(written);
  }
  for (auto& inlet : state.inlets) {
    visit(inlet.particles), visit(inlet.tries), visit(inlet.waiting);
  }
}

void put_state(io::Checkpoint& checkpoint, const DryState& state) {
  std::vector<Real> reals;
  for_reals(state, [&](Real value) { reals.push_back(value); });
  std::vector<std::uint64_t> counts;
  for_counts(state, [&](auto value) { counts.push_back(static_cast<std::uint64_t>(value)); });
  checkpoint.whole("run_reals", std::move(reals));
  checkpoint.whole("run_counts", std::move(counts));
}

void get_state(const io::CheckpointReader& reader, DryState& state) {
  const auto reals = reader.whole<Real>("run_reals");
  const auto counts = reader.whole<std::uint64_t>("run_counts");
  std::size_t at = 0;
  for_reals(state, [&](Real& value) { value = reals.at(at++); });
  at = 0;
  for_counts(state, [&](auto& value) {
    value = static_cast<std::decay_t<decltype(value)>>(counts.at(at++));
  });
}

/// "[table]" and "name = value" lines as "table.name = value".
std::vector<std::string> entries(const std::string& text) {
  constexpr std::array may_differ{"title",
                                  "reference",
                                  "output",
                                  "drive",
                                  "run.output_dir",
                                  "run.end_time",
                                  "run.max_wall",
                                  "run.max_pore_volumes",
                                  "run.min_permeability_ratio",
                                  "run.max_clogged_throats",
                                  "flow.max_pressure"};
  std::vector<std::string> found;
  std::string table;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string line = text.substr(at, end - at);
    at = end + 1;
    if (line.empty() || line.front() == '#') {
      continue;
    }
    if (line.front() == '[') {
      table = line.substr(1, line.size() - 2) + ".";
      continue;
    }
    const std::string path = table + line.substr(0, line.find(" = "));
    const bool free = table == "checkpoint." ||
                      std::find(may_differ.begin(), may_differ.end(), path) != may_differ.end();
    if (!free) {
      found.push_back(table + line);
    }
  }
  return found;
}

}  // namespace

std::string difference_of_cases(const std::string& before, const std::string& now) {
  const std::vector<std::string> old_lines = entries(before);
  const std::vector<std::string> new_lines = entries(now);
  const auto missing = [](const std::vector<std::string>& some,
                          const std::vector<std::string>& all) -> std::string {
    const auto at = std::find_if(some.begin(), some.end(), [&](const std::string& line) {
      return std::find(all.begin(), all.end(), line) == all.end();
    });
    return at == some.end() ? "" : *at;
  };
  const std::string was = missing(old_lines, new_lines);
  const std::string is = missing(new_lines, old_lines);
  if (was.empty() && is.empty()) {
    return "";
  }
  return fmt::format("then: {}\nnow:  {}", was.empty() ? "nothing" : was,
                     is.empty() ? "nothing" : is);
}

void put_run(io::Checkpoint& checkpoint, const DryRun& run, const dem::Snapshot& snapshot) {
  checkpoint.text("case", config::effective_case(run.the_case));
  put_state(checkpoint, run.state);
  put_snapshot(checkpoint, snapshot);
}

void write_checkpoint(const DryRun& run, const std::string& folder,
                      const io::Provenance& provenance) {
  const dem::Snapshot snapshot = run.system.save();
  io::Checkpoint checkpoint;
  put_run(checkpoint, run, snapshot);
  io::write_checkpoint(folder, run.the_case.checkpoint.keep, checkpoint, provenance,
                       run.comm.handle());
}

void go_on(DryRun& run, const std::string& folder) {
  get_run(io::CheckpointReader(folder, run.comm.rank(), run.comm.size()), run);
}

void require_same_case(const io::CheckpointReader& reader, const config::Case& the_case) {
  const std::string difference =
      difference_of_cases(reader.text("case"), config::effective_case(the_case));
  if (!difference.empty()) {
    throw InputError(
        fmt::format("{} is of another case: change it back, or start without --restart\n{}",
                    reader.path(), difference));
  }
}

void get_run(const io::CheckpointReader& reader, DryRun& run) {
  require_same_case(reader, run.the_case);
  get_state(reader, run.state);
  run.system.restore(get_snapshot(reader, run.system.settings().walls), reader.same_ranks());
}

}  // namespace porefines::sim
