// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "core/json.hpp"
#include "io/provenance.hpp"
#include "report/picture.hpp"
#include "sim/dry_state.hpp"
#include "sim/ending.hpp"

namespace porefines::sim {

/// summary.json: flat, SI. Collective, the text counts on rank 0.
[[nodiscard]] Json summarise_dry(const DryRun& run, const Ending& ending,
                                 const io::Provenance& provenance);

/// A picture of the particles: coloured by speed, seen along y, or along z when the box is thin there.
/// On rank 0; collective.
[[nodiscard]] report::Picture paint_dry(const DryRun& run);
/// "title, 0.25 s"
[[nodiscard]] std::string title_of_moment(const DryRun& run);
/// Saves a picture of the moment, that of rank 0. Collective.
void write_moment(const std::string& path, const DryRun& run, const report::Picture& picture,
                  const io::Provenance& provenance);
/// Paints and saves. Collective.
void draw_dry(const std::string& path, const DryRun& run, const io::Provenance& provenance);

/// The numbers of the run before it starts, in lines for a person. Collective.
[[nodiscard]] std::vector<std::string> describe_dry(const DryRun& run,
                                                    const std::vector<std::string>& remarks);

}  // namespace porefines::sim
