// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <map>
#include <string>

#include <benchmark/benchmark.h>

namespace porefines::bench {

/// Prints the fastest of each benchmark's repetitions, which other users of the machine disturb
/// least, and keeps it for the table at the end.
class Fastest : public benchmark::ConsoleReporter {
 public:
  Fastest() : ConsoleReporter(OO_Tabular) {}
  void ReportRuns(const std::vector<Run>& runs) override;

  /// Bytes that each kernel must move per second, beside what plain streams reach here.
  void print_ratios() const;

 private:
  std::map<std::string, Run> best_;
};

/// Says nothing: ranks other than 0.
class Silent : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context& /*context*/) override { return true; }
  void ReportRuns(const std::vector<Run>& /*runs*/) override {}
};

}  // namespace porefines::bench
