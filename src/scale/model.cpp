// SPDX-License-Identifier: MPL-2.0
#include "scale/model.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "par/decomposition.hpp"

namespace porefines::scale {
namespace {

/// Two coefficients that are not negative: y = a p + b q in the least squares sense. One run, or two that tell the same,
/// are the first's alone.
std::array<Real, 2> not_negative(const std::vector<Real>& p, const std::vector<Real>& q,
                                 const std::vector<Real>& y) {
  Real pp = 0;
  Real pq = 0;
  Real qq = 0;
  Real py = 0;
  Real qy = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    pp += p[i] * p[i];
    pq += p[i] * q[i];
    qq += q[i] * q[i];
    py += p[i] * y[i];
    qy += q[i] * y[i];
  }
  const Real determinant = pp * qq - pq * pq;
  const std::array<Real, 2> only_p{pp > 0 ? std::max(0.0, py / pp) : 0, 0};
  if (!(determinant > 1e-9 * pp * qq)) {
    return only_p;
  }
  const std::array<Real, 2> both{(qq * py - pq * qy) / determinant,
                                 (pp * qy - pq * py) / determinant};
  if (both[0] < 0) {
    return {0, std::max(0.0, qy / qq)};
  }
  return both[1] < 0 ? only_p : both;
}

void fit_compute(ScalingModel& model, const std::vector<Measured>& runs) {
  std::vector<Real> share;
  std::vector<Real> one;
  std::vector<Real> seconds;
  Real waiting = 0;
  Real compute = 0;
  for (const Measured& run : runs) {
    share.push_back(surface_of(model.cells, run.ranks).share / run.ranks);
    one.push_back(1);
    seconds.push_back(run.compute());
    waiting += run.ranks > 1 ? run.waiting : 0;
    compute += run.ranks > 1 ? run.compute() : 0;
  }
  const auto found = not_negative(share, one, seconds);
  model.work = found[0];
  model.fixed = found[1];
  model.waiting_share = compute > 0 ? waiting / compute : 0;
}

void fit_messages(ScalingModel& model, const std::vector<Measured>& runs) {
  std::vector<Real> messages;
  std::vector<Real> bytes;
  std::vector<Real> halo;
  std::vector<Real> hops;
  std::vector<Real> none;
  std::vector<Real> reductions;
  Real faces = 0;
  Real cells = 0;
  Real all_messages = 0;
  Real all_bytes = 0;
  for (const Measured& run : runs) {
    if (run.ranks < 2) {
      continue;
    }
    const Surface surface = surface_of(model.cells, run.ranks);
    messages.push_back(run.messages);
    bytes.push_back(run.bytes);
    halo.push_back(run.halo);
    hops.push_back(run.collectives * std::log2(run.ranks));
    none.push_back(0);
    reductions.push_back(run.reductions);
    faces += surface.neighbours;
    cells += surface.cells;
    all_messages += run.messages;
    all_bytes += run.bytes;
    model.collectives = run.collectives;
  }
  model.messages_per_face = faces > 0 ? all_messages / faces : 0;
  model.bytes_per_cell = cells > 0 ? all_bytes / cells : 0;
  const auto found = not_negative(messages, bytes, halo);
  model.latency = found[0];
  model.seconds_per_byte = found[1];
  model.hop = not_negative(hops, none, reductions)[0];
}

}  // namespace

Surface surface_of(const Int3& cells, int ranks) {
  par::LayerWork even;
  for (std::size_t a = 0; a < 3; ++a) {
    even[a].assign(static_cast<std::size_t>(cells[a]), 1);
  }
  const par::Decomposition cut = par::decompose(cells, ranks, even);
  Surface surface;
  Real largest = 0;
  for (int rank = 0; rank < ranks; ++rank) {
    const Int3 at = cut.coordinates(rank);
    const Int3 extent = cut.extent(rank);
    const auto volume = static_cast<Real>(product(extent));
    largest = std::max(largest, volume);
    Surface mine;
    for (std::size_t a = 0; a < 3; ++a) {
      const int sides = (at[a] > 0 ? 1 : 0) + (at[a] + 1 < cut.ranks[a] ? 1 : 0);
      mine.neighbours += sides;
      mine.cells += sides * volume / extent[a];
    }
    surface.neighbours = std::max(surface.neighbours, mine.neighbours);
    surface.cells = std::max(surface.cells, mine.cells);
  }
  surface.share = largest * ranks / static_cast<Real>(product(cells));
  return surface;
}

Real ScalingModel::seconds(int ranks) const {
  const Surface surface = surface_of(cells, ranks);
  const Real compute = fixed + work * surface.share / ranks;
  if (ranks == 1) {
    return compute;
  }
  return compute * (1 + waiting_share) + messages_per_face * surface.neighbours * latency +
         bytes_per_cell * surface.cells * seconds_per_byte + collectives * std::log2(ranks) * hop;
}

ScalingModel fit_model(const Int3& cells, const std::vector<Measured>& runs) {
  ScalingModel model;
  model.cells = cells;
  fit_compute(model, runs);
  fit_messages(model, runs);
  return model;
}

int recommend(const std::vector<Measured>& runs, int physical_cores) {
  constexpr Real near = 1.05;
  Real least = std::numeric_limits<Real>::infinity();
  for (const Measured& run : runs) {
    least = run.ranks <= physical_cores ? std::min(least, run.seconds) : least;
  }
  int ranks = physical_cores;
  for (const Measured& run : runs) {
    if (run.ranks <= physical_cores && run.seconds <= near * least) {
      ranks = std::min(ranks, run.ranks);
    }
  }
  return ranks;
}

std::vector<int> ranks_to_try(int physical_cores) {
  std::vector<int> ranks;
  for (int n = 1; n < physical_cores; n *= 2) {
    ranks.push_back(n);
  }
  ranks.push_back(physical_cores);
  return ranks;
}

}  // namespace porefines::scale
