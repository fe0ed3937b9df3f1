// SPDX-License-Identifier: MPL-2.0
#include "analysis/retention.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include <fmt/format.h>

namespace porefines::analysis {
namespace {

/// Calls share(bin, from, to) for the parts of [from, to] that lie in bins.
template <class Share>
void cut_by_bins(Real from, Real to, const ProfileBins& bins, const Share& share) {
  const Real width = bins.width();
  const auto bin_of = [&](Real x) { return std::floor((x - bins.low) / width); };
  const int first = static_cast<int>(std::max<Real>(bin_of(from), 0));
  const int last = static_cast<int>(std::min<Real>(bin_of(to), bins.count - 1));
  for (int bin = first; bin <= last; ++bin) {
    const Real low = bins.low + bin * width;
    share(static_cast<std::size_t>(bin), std::max(from, low), std::min(to, low + width));
  }
}

Real per(Real amount, Real volume) {
  return volume > 0 ? amount / volume : 0;
}

}  // namespace

Real sphere_below(Real radius, Real height) {
  const Real h = std::clamp(height, -radius, radius);
  return std::numbers::pi / 3 * (radius + h) * (radius + h) * (2 * radius - h);
}

std::vector<Real> pore_volumes_along(std::span<const float> solid, const grid::Block& block,
                                     const Vec3& spacing, Real origin, const ProfileBins& bins,
                                     const par::Communicator& comm) {
  std::vector<Real> planes(static_cast<std::size_t>(block.n[bins.axis]), 0);
  std::size_t at = 0;
  Int3 cell{};
  for (cell[2] = 0; cell[2] < block.n[2]; ++cell[2]) {
    for (cell[1] = 0; cell[1] < block.n[1]; ++cell[1]) {
      for (cell[0] = 0; cell[0] < block.n[0]; ++cell[0], ++at) {
        planes[static_cast<std::size_t>(cell[bins.axis])] += 1 - static_cast<Real>(solid[at]);
      }
    }
  }
  const Real edge = spacing[bins.axis];
  const Real face = spacing.x * spacing.y * spacing.z / edge;
  std::vector<Real> volumes(static_cast<std::size_t>(bins.count), 0);
  for (std::size_t p = 0; p < planes.size(); ++p) {
    const Real low = origin + edge * (block.start[bins.axis] + static_cast<Real>(p));
    cut_by_bins(low, low + edge, bins, [&](std::size_t bin, Real from, Real to) {
      volumes[bin] += planes[p] * face * std::max(to - from, 0.0);
    });
  }
  comm.sum(volumes);
  return volumes;
}

RetentionProfile retention_along(const RunSample& sample, std::span<const Fate> fates,
                                 const ProfileBins& bins) {
  const auto count = static_cast<std::size_t>(bins.count);
  RetentionProfile profile{std::vector<Index>(count, 0), std::vector<Real>(count, 0),
                           std::vector<Real>(count, 0)};
  for (std::size_t i = 0; i < sample.id.size(); ++i) {
    const Real x = sample.position[i][bins.axis];
    const Real r = sample.radius[i];
    const bool retained = fates[i] != Fate::piping;
    auto& volume = retained ? profile.retained_volume : profile.suspended_volume;
    cut_by_bins(x - r, x + r, bins, [&](std::size_t bin, Real from, Real to) {
      volume[bin] += sphere_below(r, to - x) - sphere_below(r, from - x);
    });
    const Real bin = std::floor((x - bins.low) / bins.width());
    if (retained && bin >= 0 && bin < bins.count) {
      ++profile.retained[static_cast<std::size_t>(bin)];
    }
  }
  return profile;
}

std::vector<std::string> retention_columns() {
  return {"time_s",
          "pore_volumes",
          "x_m",
          "retained",
          "retained_per_m3",
          "retained_fraction",
          "suspended_fraction",
          "porosity_clean",
          "porosity"};
}

std::string retention_rows(const RunSample& sample, const RetentionProfile& profile,
                           std::span<const Real> pore_volumes, Real area, const ProfileBins& bins) {
  const Real bulk = area * bins.width();
  std::string text;
  for (std::size_t bin = 0; bin < pore_volumes.size(); ++bin) {
    const Real pore = pore_volumes[bin];
    const Real kept = profile.retained_volume[bin];
    fmt::format_to(std::back_inserter(text), "{},{},{:.9g},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n",
                   sample.time, sample.pore_volumes, bins.centre(static_cast<int>(bin)),
                   profile.retained[bin], per(static_cast<Real>(profile.retained[bin]), pore),
                   per(kept, pore), per(profile.suspended_volume[bin], pore), per(pore, bulk),
                   per(pore - kept, bulk));
  }
  return text;
}

}  // namespace porefines::analysis
