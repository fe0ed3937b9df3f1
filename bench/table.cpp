// SPDX-License-Identifier: MPL-2.0
#include "table.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace porefines::bench {
namespace {

constexpr double giga = 1e9;

double counter(const benchmark::BenchmarkReporter::Run& run, const std::string& name) {
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? 0.0 : static_cast<double>(found->second.value);
}

/// The name without what the library appends ("/iterations:3/repeats:5").
std::string short_name(const benchmark::BenchmarkReporter::Run& run) {
  return run.run_name.function_name + (run.run_name.args.empty() ? "" : "/" + run.run_name.args);
}

/// What plain streams reached in this run [bytes/s]; 0 where one was not run.
struct Streams {
  double triad, update, read;
};

std::string share(double bytes, double of) {
  return of > 0 ? fmt::format("{:.0f} %", 100 * bytes / of) : "-";
}

void print_row(const std::string& name, const benchmark::BenchmarkReporter::Run& run,
               const Streams& streams) {
  const double bytes = counter(run, "bytes_per_second");
  const double cells = counter(run, "cells/s");
  fmt::print("{:<24}{:>8.2f}{:>10}{:>11}{:>10}{:>10}\n", name, bytes / giga,
             share(bytes, streams.triad), share(bytes, streams.update), share(bytes, streams.read),
             cells > 0 ? fmt::format("{:.2f}", cells / 1e6) : "-");
}

}  // namespace

void Fastest::ReportRuns(const std::vector<Run>& runs) {
  const Run* fastest = nullptr;
  for (const Run& run : runs) {
    const bool faster =
        fastest == nullptr || run.GetAdjustedRealTime() < fastest->GetAdjustedRealTime();
    if (run.run_type == Run::RT_Iteration && !run.error_occurred && faster) {
      fastest = &run;
    }
  }
  if (fastest != nullptr) {
    best_[short_name(*fastest)] = *fastest;
    ConsoleReporter::ReportRuns({*fastest});
  } else if (std::any_of(runs.begin(), runs.end(), [](const Run& r) { return r.error_occurred; })) {
    ConsoleReporter::ReportRuns(runs);
  }
}

void Fastest::print_ratios() const {
  const auto stream = [&](const std::string& name) {
    const auto found = best_.find("stream/" + name);
    return found == best_.end() ? 0.0 : counter(found->second, "bytes_per_second");
  };
  const Streams streams{stream("triad"), stream("update"), stream("read")};
  fmt::print("\nBytes that must move, per second and rank, against plain streams in this run:\n");
  fmt::print("{:<24}{:>8}{:>10}{:>11}{:>10}{:>10}\n", "", "GB/s", "of triad", "of update",
             "of read", "Mcells/s");
  for (const bool plain : {true, false}) {
    for (const auto& [name, run] : best_) {
      if (counter(run, "bytes_per_second") > 0 && name.starts_with("stream") == plain) {
        print_row(name, run, streams);
      }
    }
  }
  fmt::print("Cells are fluid cells of all ranks. Counting rules: bench/traffic.hpp.\n");
}

}  // namespace porefines::bench
