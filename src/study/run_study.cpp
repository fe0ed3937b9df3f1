// SPDX-License-Identifier: MPL-2.0
#include "study/run_study.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "config/reader.hpp"
#include "core/atomic_file.hpp"
#include "core/error.hpp"
#include "core/memory.hpp"
#include "core/signals.hpp"
#include "study/crew.hpp"
#include "study/groups.hpp"

namespace porefines::study {
namespace {

using Results = std::vector<std::optional<Result>>;

Results collect_all(const Study& study, const std::vector<Member>& members,
                    const std::string& output) {
  Results results;
  for (const Member& member : members) {
    results.push_back(collect(member_folder(output, member), study.readings));
  }
  return results;
}

void say_plan(const Study& study, const std::vector<Member>& members, const Results& results,
              const StudyPlan& plan) {
  const auto done = std::count_if(results.begin(), results.end(),
                                  [](const auto& result) { return result.has_value(); });
  fmt::print("study      {}{}\n", study.title.empty() ? study.path : study.title,
             done > 0 ? fmt::format(", {} members are done already", done) : "");
  std::size_t group = members.size();
  for (const Member& member : members) {
    if (member.group != group) {
      group = member.group;
      const Cost& cost = plan.groups[group];
      fmt::print("{:>4}       {}: {} of {}, {}\n", group + 1, describe_group(study, member),
                 study.seeds > 0 ? fmt::format("{} runs", study.seeds) : "a run",
                 cost.seconds > 0 ? "about " + format_duration(cost.seconds) : "unknown time",
                 cost.memory > 0 ? format_bytes(static_cast<std::int64_t>(cost.memory))
                                 : "unknown memory");
    }
  }
  fmt::print("machine    {} physical cores, {} free\n", plan.cores,
             format_bytes(static_cast<std::int64_t>(plan.available)));
  fmt::print("in all     {} members, {} at a time on {} {} each, {}\n", members.size(),
             plan.side_by_side, study.ranks, study.ranks == 1 ? "rank" : "ranks",
             plan.seconds > 0 ? "about " + format_duration(plan.seconds) : "nothing left to run");
  if (study.ranks > plan.cores) {
    fmt::print("warning: {} ranks on {} physical cores: a member would be faster on {}\n",
               study.ranks, plan.cores, plan.cores);
  }
  std::fflush(stdout);
}

Crew make_crew(const Study& study, const std::vector<Member>& members, const Results& results,
               const std::string& output, int side_by_side) {
  Crew crew{.study = study,
            .members = members,
            .output = output,
            .side_by_side = side_by_side,
            .waiting = {}};
  crew.tries.resize(members.size());
  crew.afresh.resize(members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    crew.end_times.push_back(config::load_case(study.case_file, members[i].settings).run.end_time);
    if (results[i]) {
      ++crew.done;
    } else if (is_resumable(member_folder(output, members[i]))) {
      crew.waiting.push_front(i);  // what was begun is finished first
    } else {
      crew.waiting.push_back(i);
    }
  }
  return crew;
}

void say_groups(const std::vector<Group>& groups, const Study& study) {
  for (const Group& group : groups) {
    if (!group.clogs) {
      continue;
    }
    const analysis::ExponentialFit fit =
        analysis::fit_exponential(group.escapees, study.confidence);
    fmt::print(
        "{}: {} of {} clogged, {:.2f} ({:.2f} to {:.2f}); mean escapees {:.3g} ({:.3g} to "
        "{:.3g})\n",
        group.name, group.clogged.hits, group.clogged.trials, group.clogged.share,
        group.clogged.low, group.clogged.high, fit.mean, fit.low, fit.high);
  }
}

void write_results(const Study& study, const std::vector<Member>& members,
                   const std::string& output) {
  const Results results = collect_all(study, members, output);
  const std::vector<Group> groups = make_groups(study, members, results);
  write_tables(output, study, members, results, groups);
  const std::vector<std::string> charts = draw_charts(output, study, groups);
  say_groups(groups, study);
  fmt::print(
      "results    {}/members.csv, groups.csv, survival.csv, bands.csv, study.json and {} "
      "charts\n",
      output, charts.size());
}

}  // namespace

int run_study(const std::string& path, const StudyOptions& options) {
  const Study study = read_study(path, options.overrides);
  const std::vector<Member> members = expand(study);
  const std::string output = options.output_dir.empty() ? study.output_dir : options.output_dir;
  make_folder(output);
  const FolderLock lock(output);
  const Results before = collect_all(study, members, output);
  std::vector<bool> wanted(members.size());
  std::transform(before.begin(), before.end(), wanted.begin(),
                 [](const auto& result) { return !result.has_value(); });
  const StudyPlan plan = plan_study(study, members, wanted, output);
  say_plan(study, members, before, plan);
  if (options.dry_run) {
    return exit_code::done;
  }
  Crew crew = make_crew(study, members, before, output, plan.side_by_side);
  const int signal = work(crew);
  write_results(study, members, output);
  if (signal != 0) {
    fmt::print("stopped by signal {}: the same command goes on\n", signal);
    return exit_code::signal_base + signal;
  }
  if (!crew.failed.empty()) {
    throw RunError(
        fmt::format("{} of {} members failed; members.csv has the reasons\nthe same "
                    "command tries them again",
                    crew.failed.size(), members.size()));
  }
  return exit_code::done;
}

}  // namespace porefines::study
