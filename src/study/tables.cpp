// SPDX-License-Identifier: MPL-2.0
// The tables of a study.
#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/json.hpp"
#include "io/provenance.hpp"
#include "study/folder.hpp"
#include "study/groups.hpp"

namespace porefines::study {
namespace {

/// No comma within a field of our tables.
std::string field(std::string text) {
  for (char& c : text) {
    c = c == ',' || c == '\n' ? ';' : c;
  }
  return text;
}

std::string axis_names(const Study& study) {
  std::string text;
  for (const Axis& axis : study.axes) {
    for (const std::string& key : axis.keys) {
      text += fmt::format(",{}", field(key));
    }
  }
  return text;
}

std::string axis_values(const Study& study, const std::vector<std::size_t>& at) {
  std::string text;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    for (const std::string& value : study.axes[a].points[at[a]].values) {
      text += fmt::format(",{}", field(value));
    }
  }
  return text;
}

std::string members_table(const std::string& output, const Study& study,
                          const std::vector<Member>& members,
                          const std::vector<std::optional<Result>>& results) {
  std::string text = "member,group,folder,status,attempts_failed" + axis_names(study) + ",seed";
  for (const std::string& reading : study.readings) {
    text += fmt::format(",{}", field(reading));
  }
  text += ",wall_time_s,reason\n";
  for (std::size_t i = 0; i < members.size(); ++i) {
    const Member& member = members[i];
    const Failure failure = read_failure(member_folder(output, member));
    const auto& result = results[i];
    text += fmt::format("{},{},{},{},{}{},{}", i + 1, member.group + 1, member.name,
                        result                 ? "done"
                        : failure.attempts > 0 ? "failed"
                                               : "open",
                        failure.attempts, axis_values(study, member.at), member.seed);
    for (std::size_t k = 0; k < study.readings.size(); ++k) {
      text += result ? fmt::format(",{}", result->readings[k]) : ",nan";
    }
    text += fmt::format(",{},{}\n", result ? result->wall_time : 0, field(failure.reason));
  }
  return text;
}

std::string fit_columns(const std::vector<analysis::Lifetime>& lives, const Study& study) {
  const analysis::ExponentialFit fit = analysis::fit_exponential(lives, study.confidence);
  return fmt::format(",{},{},{}", fit.mean, fit.low, fit.high);
}

std::string groups_table(const Study& study, const std::vector<Group>& groups) {
  std::string text =
      "group" + axis_names(study) + ",members,done,clogged,clog_share,clog_low,clog_high";
  for (const char* what : {"escapees", "time_s", "pore_volumes"}) {
    text += fmt::format(",{0}_mean,{0}_low,{0}_high", what);
  }
  for (const std::string& reading : study.readings) {
    text += fmt::format(",{0}_mean,{0}_low,{0}_high", field(reading));
  }
  text += "\n";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Group& group = groups[g];
    text += fmt::format("{}{},{},{},{},{},{},{}", g + 1, axis_values(study, group.at),
                        group.members, group.done, group.clogged.hits, group.clogged.share,
                        group.clogged.low, group.clogged.high);
    for (const auto* lives : {&group.escapees, &group.time, &group.volumes}) {
      text += group.clogs ? fit_columns(*lives, study) : ",nan,nan,nan";
    }
    for (const analysis::Estimate& e : group.readings) {
      text += fmt::format(",{},{},{}", e.value, e.low, e.high);
    }
    text += "\n";
  }
  return text;
}

std::string survival_table(const Study& study, const std::vector<Group>& groups) {
  std::string text = "group,of,at,at_risk,events,survival,deviation,low,high\n";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const auto add = [&](const char* what, const std::vector<analysis::Lifetime>& lives) {
      for (const auto& s : analysis::kaplan_meier(lives, study.confidence)) {
        text += fmt::format("{},{},{},{},{},{},{},{},{}\n", g + 1, what, s.at, s.at_risk, s.events,
                            s.survival, s.deviation, s.low, s.high);
      }
    };
    add("escapees", groups[g].escapees);
    add("time_s", groups[g].time);
    add("pore_volumes", groups[g].volumes);
  }
  return text;
}

std::string bands_table(const std::vector<Group>& groups) {
  std::string text = "group,curve,x,members,mean,low,high,p10,p50,p90\n";
  for (std::size_t g = 0; g < groups.size(); ++g) {
    for (std::size_t k = 0; k < curve_kinds.size(); ++k) {
      for (const analysis::BandPoint& p : groups[g].bands[k]) {
        text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", g + 1, curve_kinds[k].name, p.x,
                            p.members, p.mean.value, p.mean.low, p.mean.high, p.lower, p.median,
                            p.upper);
      }
    }
  }
  return text;
}

Json summary(const std::string& output, const Study& study, const std::vector<Member>& members,
             const std::vector<Group>& groups) {
  Json json;
  Index done = 0;
  Index failed = 0;
  for (const Group& group : groups) {
    done += group.done;
  }
  for (const Member& member : members) {
    const std::string folder = member_folder(output, member);
    failed += !is_done(folder) && read_failure(folder).attempts > 0 ? 1 : 0;
  }
  const auto total = static_cast<Index>(members.size());
  json.set("status", done == total ? "done" : "incomplete");
  json.set("title", study.title);
  json.set("study", study.path);
  json.set("case", study.case_file);
  json.set("members", total);
  json.set("members_done", done);
  json.set("members_failed", failed);
  json.set("groups", static_cast<Index>(groups.size()));
  json.set("ranks_per_member", study.ranks);
  json.set("confidence", study.confidence);
  for (const auto& [name, value] : io::entries(io::make_provenance(study.ranks, 0))) {
    json.set(name, value);
  }
  return json;
}

}  // namespace

void write_tables(const std::string& output, const Study& study, const std::vector<Member>& members,
                  const std::vector<std::optional<Result>>& results,
                  const std::vector<Group>& groups) {
  write_file(output + "/members.csv", members_table(output, study, members, results));
  write_file(output + "/groups.csv", groups_table(study, groups));
  write_file(output + "/survival.csv", survival_table(study, groups));
  write_file(output + "/bands.csv", bands_table(groups));
  write_file(output + "/study.json", summary(output, study, members, groups).text());
}

}  // namespace porefines::study
