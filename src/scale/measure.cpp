// SPDX-License-Identifier: MPL-2.0
#include "scale/measure.hpp"

#include <filesystem>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/json_read.hpp"
#include "core/process.hpp"

namespace porefines::scale {
namespace {

Measured read(const FlatJson& summary) {
  Measured run;
  run.ranks = static_cast<int>(summary.number("ranks"));
  run.seconds = summary.number("wall_time_s");
  run.halo = summary.number("time_halo_s");
  run.reductions = summary.number("time_reductions_s");
  run.waiting = summary.number("time_waiting_s");
  run.messages = summary.number("messages_per_rank");
  run.bytes = summary.number("message_bytes_per_rank");
  run.collectives = summary.number("collectives_per_rank");
  return run;
}

}  // namespace

Measured measure(const std::string& case_file, const std::vector<std::string>& overrides, int ranks,
                 int repeats, const std::string& folder, Int3& cells) {
  make_folder(folder);
  std::vector<std::string> words{"run", case_file, "-o", folder};
  words.insert(words.end(), overrides.begin(), overrides.end());
  Measured best;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    const std::string console = folder + "/console.txt";
    std::filesystem::remove(console);
    const int code = wait_for(start_process(on_ranks(ranks, words), console));
    const auto summary = read_flat_json(folder + "/summary.json");
    if (code != exit_code::done || !summary) {
      throw InputError(fmt::format("{} on {} ranks ends with code {}\n{}", case_file, ranks, code,
                                   last_lines(console, 3)));
    }
    const Measured run = read(*summary);
    best = repeat == 0 || run.seconds < best.seconds ? run : best;
    for (std::size_t a = 0; a < 3; ++a) {
      cells[a] = static_cast<int>(summary->number(fmt::format("cells_{}", "xyz"[a])));
    }
  }
  return best;
}

}  // namespace porefines::scale
