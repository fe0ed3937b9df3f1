// SPDX-License-Identifier: MPL-2.0
#include "analysis/clogging.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

namespace porefines::analysis {
namespace {

using What = ClogEvent::What;

/// Place among the resting of a retained particle, -1 when it is not.
std::int32_t retained_place(const RestState& rest, std::uint64_t id) {
  const auto found =
      std::lower_bound(rest.resting.begin(), rest.resting.end(), id,
                       [](const Resting& one, std::uint64_t other) { return one.id < other; });
  return found != rest.resting.end() && found->id == id && found->retained
             ? static_cast<std::int32_t>(found - rest.resting.begin())
             : -1;
}

bool all_retained(const RestState& rest, const Clog& clog) {
  return std::all_of(clog.ids.begin(), clog.ids.end(),
                     [&](std::uint64_t id) { return retained_place(rest, id) >= 0; });
}

bool share_one(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b) {
  return std::any_of(a.begin(), a.end(), [&](std::uint64_t id) {
    return std::find(b.begin(), b.end(), id) != b.end();
  });
}

/// Who is part of a clog already: nobody is in two.
class Taken {
 public:
  explicit Taken(const RestState& rest) : rest_(rest), taken_(rest.resting.size(), 0) {}

  void take(const Clog& clog) {
    for (const std::uint64_t id : clog.ids) {
      taken_[static_cast<std::size_t>(retained_place(rest_, id))] = 1;
    }
  }
  [[nodiscard]] bool is_free(std::int32_t k) const {
    return taken_[static_cast<std::size_t>(k)] == 0;
  }
  [[nodiscard]] Jam::Crowd free_of(const Jam::Crowd& crowd) const {
    Jam::Crowd left{crowd.throat, {}};
    std::copy_if(crowd.members.begin(), crowd.members.end(), std::back_inserter(left.members),
                 [&](std::int32_t k) { return is_free(k); });
    return left;
  }

 private:
  const RestState& rest_;
  std::vector<char> taken_;
};

/// What may block a throat that has no clog, or one that has lost a particle.
struct Candidate {
  const Jam::Crowd* crowd;
  const Clog* old;
  Block block;
};

const Clog* clog_at(const std::vector<Clog>& clogs, std::int32_t throat) {
  const auto found =
      std::lower_bound(clogs.begin(), clogs.end(), throat,
                       [](const Clog& clog, std::int32_t other) { return clog.throat < other; });
  return found != clogs.end() && found->throat == throat ? &*found : nullptr;
}

Clog make_clog(const CloggingState& state, const Candidate& from, Real time) {
  Clog clog{from.crowd->throat, from.block.kind, {}, 0, 0, time};
  for (const std::int32_t k : from.block.members) {
    clog.ids.push_back(state.rest.resting[static_cast<std::size_t>(k)].id);
  }
  if (from.old != nullptr && share_one(clog.ids, from.old->ids)) {
    clog.since = from.old->since;
    clog.most = from.old->most;
  }
  return clog;
}

/// Clogs that stand keep theirs; then clogs that lost some, then new ones, the best placed first.
std::vector<Clog> renew_clogs(const CloggingState& state, const Jam& jam, Real time) {
  Taken taken(state.rest);
  std::vector<Clog> now;
  std::vector<Candidate> candidates;
  for (const Jam::Crowd& crowd : jam.crowds()) {
    const Clog* const old = clog_at(state.clogs, crowd.throat);
    if (old != nullptr && all_retained(state.rest, *old)) {
      taken.take(*old);
      now.push_back(*old);
    } else {
      candidates.push_back({&crowd, old, {}});
    }
  }
  for (Candidate& one : candidates) {
    one.block = jam.find_block(taken.free_of(*one.crowd));
  }
  std::sort(candidates.begin(), candidates.end(), [](const Candidate& a, const Candidate& b) {
    return std::tuple(a.old == nullptr, a.block.off, a.crowd->throat) <
           std::tuple(b.old == nullptr, b.block.off, b.crowd->throat);
  });
  for (Candidate& one : candidates) {
    const auto& members = one.block.members;
    if (!std::all_of(members.begin(), members.end(),
                     [&](std::int32_t k) { return taken.is_free(k); })) {
      one.block = jam.find_block(taken.free_of(*one.crowd));
    }
    if (!one.block.empty()) {
      now.push_back(make_clog(state, one, time));
      taken.take(now.back());
    }
  }
  std::sort(now.begin(), now.end(),
            [](const Clog& a, const Clog& b) { return a.throat < b.throat; });
  return now;
}

/// Old clogs of which no particle blocks their throat any more.
std::vector<ClogEvent> find_released(const std::vector<Clog>& before, const std::vector<Clog>& now,
                                     const RunSample& sample) {
  std::vector<ClogEvent> events;
  for (const Clog& old : before) {
    const Clog* const still = clog_at(now, old.throat);
    if (still == nullptr || still->most == 0) {
      events.push_back({What::released, old, sample.time, sample.pore_volumes, sample.out});
    }
  }
  return events;
}

/// Every retained particle goes with the clog that holds it over the fewest contacts; -1: with none.
std::vector<std::int32_t> hold(const CloggingState& state, const Jam& jam) {
  std::vector<std::int32_t> holder(state.rest.resting.size(), -1);
  std::vector<std::int32_t> queue;
  for (std::size_t c = 0; c < state.clogs.size(); ++c) {
    for (const std::uint64_t id : state.clogs[c].ids) {
      const std::int32_t k = retained_place(state.rest, id);
      if (k >= 0 && holder[static_cast<std::size_t>(k)] < 0) {
        holder[static_cast<std::size_t>(k)] = static_cast<std::int32_t>(c);
        queue.push_back(k);
      }
    }
  }
  for (std::size_t head = 0; head < queue.size(); ++head) {
    for (const std::int32_t k : jam.touching(queue[head])) {
      if (holder[static_cast<std::size_t>(k)] < 0) {
        holder[static_cast<std::size_t>(k)] = holder[static_cast<std::size_t>(queue[head])];
        queue.push_back(k);
      }
    }
  }
  return holder;
}

/// Counts who is held and writes down every particle's fate.
void set_fates(CloggingState& state, const Jam& jam, const RunSample& sample) {
  const auto holder = hold(state, jam);
  state.fates.assign(sample.id.size(), Fate::piping);
  for (Clog& clog : state.clogs) {
    clog.behind = -static_cast<Index>(clog.ids.size());
  }
  for (std::size_t k = 0; k < holder.size(); ++k) {
    if (holder[k] >= 0) {
      ++state.clogs[static_cast<std::size_t>(holder[k])].behind;
    }
    if (state.rest.resting[k].retained) {
      state.fates[static_cast<std::size_t>(state.rest.place_in_sample[k])] =
          holder[k] >= 0 ? Fate::clogged : Fate::resting;
    }
  }
  for (Clog& clog : state.clogs) {
    for (const std::uint64_t id : clog.ids) {
      const auto k = static_cast<std::size_t>(retained_place(state.rest, id));
      if (clog.kind == ClogKind::arch) {
        state.fates[static_cast<std::size_t>(state.rest.place_in_sample[k])] = Fate::bridging;
      }
    }
  }
  const auto count = [&](Fate fate) {
    return static_cast<Index>(std::count(state.fates.begin(), state.fates.end(), fate));
  };
  state.counts = {count(Fate::piping) + sample.out, count(Fate::bridging), count(Fate::clogged),
                  count(Fate::resting)};
}

const char* name_of(What what) {
  return what == What::clogged ? "clogged" : what == What::grown ? "grown" : "released";
}

}  // namespace

std::vector<ClogEvent> update_clogging(CloggingState& state, const RunSample& sample,
                                       const geom::PoreNetwork& network, const RestRules& rest,
                                       const BlockRules& rules) {
  update_resting(state.rest, sample, rest, {network.size, network.periodic});
  const Jam jam(network, sample, state.rest, rest, rules);
  std::vector<Clog> now = renew_clogs(state, jam, sample.time);
  std::vector<ClogEvent> events = find_released(state.clogs, now, sample);
  state.clogs = std::move(now);
  set_fates(state, jam, sample);
  for (Clog& clog : state.clogs) {
    const Index size = static_cast<Index>(clog.ids.size()) + clog.behind;
    if (size > clog.most) {
      const What what = clog.most == 0 ? What::clogged : What::grown;
      clog.most = size;
      events.push_back({what, clog, sample.time, sample.pore_volumes, sample.out});
    }
  }
  std::stable_sort(events.begin(), events.end(), [](const ClogEvent& a, const ClogEvent& b) {
    return a.clog.throat < b.clog.throat;
  });
  return events;
}

std::vector<std::string> clogging_columns() {
  return {"time_s", "pore_volumes", "throat",    "x_m",    "y_m", "z_m", "width_m",
          "event",  "kind",         "particles", "behind", "out", "ids"};
}

std::string clogging_rows(const std::vector<ClogEvent>& events, const geom::PoreNetwork& network) {
  std::string text;
  for (const ClogEvent& event : events) {
    const Clog& clog = event.clog;
    const geom::Throat& throat = network.throats[static_cast<std::size_t>(clog.throat)];
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{},{},{},{},{},{}\n", event.time,
                   event.pore_volumes, clog.throat, throat.centre.x, throat.centre.y,
                   throat.centre.z, throat.width, name_of(event.what), name_of(clog.kind),
                   clog.ids.size(), clog.behind, event.out, fmt::join(clog.ids, " "));
  }
  return text;
}

}  // namespace porefines::analysis
