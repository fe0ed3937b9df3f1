// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "analysis/blocks.hpp"

namespace porefines::analysis {

/// A throat that is clogged now.
struct Clog {
  std::int32_t throat = 0;
  ClogKind kind = ClogKind::sieve;
  std::vector<std::uint64_t> ids;  ///< of the arch, or of the sieved one
  Index behind = 0;                ///< retained particles held by it through contacts
  Index most = 0;                  ///< particles in its last row of the log
  Real since = 0;                  ///< [s]
};

/// What happened at a throat: a row of clogging.csv.
struct ClogEvent {
  enum class What : std::uint8_t { clogged, grown, released };
  What what;
  Clog clog;
  Real time;
  Real pore_volumes;
  Index out;  ///< particles that had left by then: the escapees, where there is one throat
};

/// Particles of each fate; out of the run counts as piping.
struct FateCounts {
  Index piping = 0;
  Index bridging = 0;
  Index clogged = 0;
  Index resting = 0;

  [[nodiscard]] Index all() const { return piping + bridging + clogged + resting; }
  /// Of all that ever came in; 0 where there are none.
  [[nodiscard]] Real share(Index count) const {
    return all() > 0 ? static_cast<Real>(count) / static_cast<Real>(all()) : 0;
  }
};

/// The clogging log's memory.
struct CloggingState {
  RestState rest;
  std::vector<Clog> clogs;  ///< in rising order of throat

  // of the last sample
  std::vector<Fate> fates;  ///< in its order
  FateCounts counts;
};

/// Takes a sample; gives what happened since the last one, in rising order of throat.
///
/// A throat is clogged as long as the particles that block it stay retained; when one of them is
/// released and others block it still, it stays clogged if one of the old ones is among them. Nobody blocks
/// two throats: an arch near several goes to the one whose centre it is nearest to. A clog
/// has grown when more particles than in its last row are in it or held behind it.
/// Cost O(particles + throats): only resting particles look for neighbours, only retained ones for
/// throats, both through cells.
/// Source of the kinds: Wyss et al. 2006, Sauret et al. 2014, Marin et al. 2018; thesis ch. 5 for
/// piping, bridging, clogging. Tests: unit/clogging.
[[nodiscard]] std::vector<ClogEvent> update_clogging(CloggingState& state, const RunSample& sample,
                                                     const geom::PoreNetwork& network,
                                                     const RestRules& rest,
                                                     const BlockRules& rules = {});

/// First column the time: fits io::SeriesWriter and its append_lines.
[[nodiscard]] std::vector<std::string> clogging_columns();
[[nodiscard]] std::string clogging_rows(const std::vector<ClogEvent>& events,
                                        const geom::PoreNetwork& network);

/// The state for a checkpoint, as numbers; ids are exact up to 2^53.
[[nodiscard]] std::vector<Real> pack(const CloggingState& state);
/// @throws RunError  when the numbers are not those of a state
[[nodiscard]] CloggingState unpack_clogging(std::span<const Real> numbers);

}  // namespace porefines::analysis
