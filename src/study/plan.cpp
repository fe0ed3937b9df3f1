// SPDX-License-Identifier: MPL-2.0
#include "study/plan.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/atomic_file.hpp"
#include "core/cores.hpp"
#include "core/error.hpp"
#include "core/json_read.hpp"
#include "core/memory.hpp"
#include "core/process.hpp"

namespace porefines::study {
namespace {

/// plan.json of a dry run. On one rank: several share the time, and each needs a little more memory.
Cost dry_run(const Study& study, const Member& member, const std::string& output) {
  const std::string folder = output + "/plans/" + member.name;
  const std::string plan_file = folder + "/plan.json";
  make_folder(folder);
  if (!std::filesystem::exists(plan_file)) {
    std::vector<std::string> words{"run", study.case_file, "--dry-run", "-o", folder};
    words.insert(words.end(), member.settings.begin(), member.settings.end());
    const std::string console = folder + "/console.txt";
    std::filesystem::remove(console);
    if (const int code = wait_for(start_process(on_ranks(1, words), console)); code != 0) {
      throw InputError(fmt::format("{}: the dry run of {} ends with code {}\n{}", study.path,
                                   describe(study, member), code, last_lines(console, 3)));
    }
  }
  const auto plan = read_flat_json(plan_file);
  return plan ? Cost{plan->number("seconds") / study.ranks, plan->number("memory_bytes")} : Cost{};
}

}  // namespace

int choose_side_by_side(const Study& study, int cores, Real available, Real most_memory) {
  if (most_memory > available) {
    throw InputError(
        fmt::format("{}: a member needs about {}, and {} are free\nmake its cells larger or its "
                    "sample smaller: "
                    "set = [\"grid.cell_size=...\"]",
                    study.path, format_bytes(static_cast<std::int64_t>(most_memory)),
                    format_bytes(static_cast<std::int64_t>(available))));
  }
  const int by_cores = std::max(1, cores / study.ranks);
  const Real by_memory = most_memory > 0 ? std::floor(available / most_memory) : by_cores;
  const int most = static_cast<int>(std::min<Real>(by_cores, by_memory));
  return std::max(1, study.side_by_side > 0 ? std::min(study.side_by_side, most) : most);
}

StudyPlan plan_study(const Study& study, const std::vector<Member>& members,
                     const std::vector<bool>& wanted, const std::string& output) {
  StudyPlan plan;
  plan.groups.resize(members.empty() ? 0 : members.back().group + 1);
  std::vector<bool> known(plan.groups.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const std::size_t group = members[i].group;
    if (wanted[i] && !known[group]) {
      plan.groups[group] = dry_run(study, members[i], output);
      known[group] = true;
    }
    plan.seconds += wanted[i] ? plan.groups[group].seconds : 0;
    plan.most_memory = std::max(plan.most_memory, plan.groups[group].memory);
  }
  plan.cores = find_cores().physical;
  plan.available = static_cast<Real>(available_memory());
  plan.side_by_side = choose_side_by_side(study, plan.cores, plan.available, plan.most_memory);
  plan.seconds /= plan.side_by_side;
  return plan;
}

}  // namespace porefines::study
