// SPDX-License-Identifier: MPL-2.0
// A study as a list of runs.
#include <cstdint>
#include <set>

#include <fmt/format.h>

#include "config/reader.hpp"
#include "config/writer.hpp"
#include "core/error.hpp"
#include "study/study.hpp"

namespace porefines::study {
namespace {

/// FNV-1a, 64 bits.
std::uint64_t hash(const std::string& text) {
  std::uint64_t value = 14695981039346656037ULL;
  for (const char c : text) {
    value = (value ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
  }
  return value;
}

/// The next combination, the last axis fastest; false after the last one.
bool advance(std::vector<std::size_t>& at, const Study& study) {
  for (std::size_t a = at.size(); a-- > 0;) {
    if (++at[a] < study.axes[a].points.size()) {
      return true;
    }
    at[a] = 0;
  }
  return false;
}

/// The case that the settings make, as text; where it is none, the study's lines are named too.
std::string effective(const Study& study, const Member& member) {
  try {
    config::Case the_case = config::load_case(study.case_file, member.settings);
    the_case.run.output_dir = "member";
    const std::string text = config::effective_case(the_case);
    return text.substr(text.find('\n'));  // without the comment that names the file
  } catch (const InputError& error) {
    std::string where = study.path;
    for (const Axis& axis : study.axes) {
      where += fmt::format("{}{}",
                           &axis == &study.axes.front() ? ": member from [[axis]] of line " : ", ",
                           axis.place.line);
    }
    throw InputError(fmt::format("{} ({})\n{}", where, describe(study, member), error.what()));
  }
}

Member make_member(const Study& study, const std::vector<std::size_t>& at, std::size_t group,
                   int seed) {
  Member member;
  member.group = group;
  member.at = at;
  member.seed = seed;
  member.settings = study.settings;
  for (std::size_t a = 0; a < at.size(); ++a) {
    const Axis& axis = study.axes[a];
    for (std::size_t k = 0; k < axis.keys.size(); ++k) {
      member.settings.push_back(axis.keys[k] + "=" + axis.points[at[a]].values[k]);
    }
  }
  if (seed > 0) {
    member.settings.push_back(fmt::format("run.random_seed={}", seed));
  }
  member.name = fmt::format("{:016x}", hash(effective(study, member)));
  return member;
}

}  // namespace

std::vector<Member> expand(const Study& study) {
  std::vector<Member> members;
  std::set<std::string> names;
  std::vector<std::size_t> at(study.axes.size(), 0);
  std::size_t group = 0;
  do {
    for (int k = 0; k < std::max(1, study.seeds); ++k) {
      const int seed = study.seeds > 0 ? study.first_seed + k : 0;
      Member member = make_member(study, at, group, seed);
      member.number = members.size();
      if (!names.insert(member.name).second) {
        throw InputError(
            fmt::format("{}: two members are the same run: {}\nan axis repeats a value", study.path,
                        describe(study, member)));
      }
      members.push_back(std::move(member));
    }
    ++group;
  } while (advance(at, study));
  return members;
}

std::string describe_group(const Study& study, const Member& member) {
  std::string text;
  for (std::size_t a = 0; a < study.axes.size(); ++a) {
    text += fmt::format("{}{} {}", text.empty() ? "" : ", ", study.axes[a].name,
                        study.axes[a].points[member.at[a]].label);
  }
  return text.empty() ? "the case" : text;
}

std::string describe(const Study& study, const Member& member) {
  return describe_group(study, member) +
         (member.seed > 0 ? fmt::format(", seed {}", member.seed) : "");
}

}  // namespace porefines::study
