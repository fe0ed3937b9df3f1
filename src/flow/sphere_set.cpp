// SPDX-License-Identifier: MPL-2.0
#include "flow/sphere_set.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace porefines::flow {

namespace {

constexpr int margin = 2;  ///< cells around a sphere whose faces it may touch
constexpr int depth = 4;   ///< ghost layers of the finest level on axes that are cut or periodic

struct Span {
  int first;
  int last;  ///< one beyond
};

/// Cells along an axis that a ball and its margin cover.
Span cells_of(const Ball& ball, const Vec3& spacing, int axis) {
  const Real x = ball.centre[axis] / spacing[axis];
  const Real r = ball.radius / spacing[axis];
  return {static_cast<int>(std::floor(x - r)) - margin,
          static_cast<int>(std::ceil(x + r)) + margin + 1};
}

bool overlap(const Span& a, const Span& b) {
  return a.first < b.last && b.first < a.last;
}

/// Exchanges one array with each of several ranks, lengths unknown to the receiver.
template <typename Record>
std::vector<std::vector<Record>> swap_with(MPI_Comm comm, const std::vector<int>& ranks,
                                           const std::vector<const std::vector<Record>*>& out) {
  static_assert(std::is_trivially_copyable_v<Record>);
  constexpr int count_tag = 70;
  constexpr int data_tag = 71;
  const std::size_t n = ranks.size();
  std::vector<Index> sizes_out(n);
  std::vector<Index> sizes_in(n);
  std::vector<MPI_Request> requests(2 * n, MPI_REQUEST_NULL);
  for (std::size_t q = 0; q < n; ++q) {
    sizes_out[q] = static_cast<Index>(out[q]->size() * sizeof(Record));
    MPI_Irecv(&sizes_in[q], 1, MPI_INT64_T, ranks[q], count_tag, comm, &requests[2 * q]);
    MPI_Isend(&sizes_out[q], 1, MPI_INT64_T, ranks[q], count_tag, comm, &requests[2 * q + 1]);
  }
  MPI_Waitall(static_cast<int>(2 * n), requests.data(), MPI_STATUSES_IGNORE);
  std::vector<std::vector<Record>> in(n);
  std::fill(requests.begin(), requests.end(), MPI_REQUEST_NULL);
  for (std::size_t q = 0; q < n; ++q) {
    in[q].resize(static_cast<std::size_t>(sizes_in[q]) / sizeof(Record));
    if (sizes_in[q] > 0) {
      MPI_Irecv(in[q].data(), static_cast<int>(sizes_in[q]), MPI_BYTE, ranks[q], data_tag, comm,
                &requests[2 * q]);
    }
    if (sizes_out[q] > 0) {
      MPI_Isend(out[q]->data(), static_cast<int>(sizes_out[q]), MPI_BYTE, ranks[q], data_tag, comm,
                &requests[2 * q + 1]);
    }
  }
  MPI_Waitall(static_cast<int>(2 * n), requests.data(), MPI_STATUSES_IGNORE);
  return in;
}

}  // namespace

SphereSet::SphereSet(const par::Communicator& comm, const par::Decomposition& cut,
                     const Vec3& spacing, const Boundaries& boundaries, const grid::Block& block)
    : comm_(comm), cut_(cut), spacing_(spacing), periodic_(boundaries.periodic()), block_(block) {}

/// Does the block of a rank, ghosts included, meet the ball or one of its periodic copies?
bool SphereSet::meets(int rank, const Ball& ball) const {
  const Int3 start = cut_.start(rank);
  const Int3 extent = cut_.extent(rank);
  for (int a = 0; a < 3; ++a) {
    const int ghosts = periodic_[a] || cut_.ranks[a] > 1 ? depth : 0;
    const Span block{start[a] - ghosts, start[a] + extent[a] + ghosts + 1};
    const Span ball_cells = cells_of(ball, spacing_, a);
    const int n = cut_.cells[a];
    bool any = overlap(block, ball_cells);
    for (int wrap = 1; periodic_[a] && !any && wrap <= 1 + ghosts / n; ++wrap) {
      any = overlap(block, {ball_cells.first - wrap * n, ball_cells.last - wrap * n}) ||
            overlap(block, {ball_cells.first + wrap * n, ball_cells.last + wrap * n});
    }
    if (!any) {
      return false;
    }
  }
  return true;
}

/// Ranks whose blocks could hold a ball of ours, or we one of theirs: symmetric.
void SphereSet::find_neighbours(Real reach) {
  if (reach == reach_) {
    return;
  }
  reach_ = reach;
  neighbours_.clear();
  for (int rank = 0; rank < comm_.size(); ++rank) {
    bool near = rank != comm_.rank();
    for (int a = 0; a < 3 && near; ++a) {
      const Span mine{block_.start[a], block_.start[a] + block_.n[a]};
      const Int3 start = cut_.start(rank);
      const int far = 2 * (static_cast<int>(std::ceil(reach / spacing_[a])) + margin + depth) + 3;
      const Span other{start[a] - far, start[a] + cut_.extent(rank)[a] + far};
      const int n = cut_.cells[a];
      near = overlap(mine, other) ||
             (periodic_[a] && (overlap(mine, {other.first - n, other.last - n}) ||
                               overlap(mine, {other.first + n, other.last + n})));
    }
    if (near) {
      neighbours_.push_back({rank, {}});
    }
  }
}

void SphereSet::distribute(std::span<const Ball> owned) {
  Real largest = 0;
  for (const Ball& ball : owned) {
    largest = std::max(largest, ball.radius);
  }
  find_neighbours(std::max(reach_, comm_.max(largest)));
  balls_.assign(owned.begin(), owned.end());
  owned_ = owned.size();
  std::vector<int> ranks;
  std::vector<std::vector<Ball>> out(neighbours_.size());
  std::vector<const std::vector<Ball>*> pointers;
  for (std::size_t q = 0; q < neighbours_.size(); ++q) {
    ranks.push_back(neighbours_[q].rank);
    for (const Ball& ball : owned) {
      if (meets(neighbours_[q].rank, ball)) {
        out[q].push_back(ball);
      }
    }
    pointers.push_back(&out[q]);
  }
  for (const std::vector<Ball>& arrived : swap_with<Ball>(comm_.handle(), ranks, pointers)) {
    balls_.insert(balls_.end(), arrived.begin(), arrived.end());
  }
  by_id_.clear();
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    by_id_.emplace_back(balls_[b].id, static_cast<int>(b));
  }
  std::sort(by_id_.begin(), by_id_.end());
  for (Neighbour& neighbour : neighbours_) {
    neighbour.shared.clear();
    for (const auto& entry : by_id_) {
      const int b = entry.second;
      if (meets(neighbour.rank, balls_[b])) {
        neighbour.shared.push_back(b);
      }
    }
  }
  find_images();
}

void SphereSet::find_images() {
  images_.clear();
  for (std::size_t b = 0; b < balls_.size(); ++b) {
    Int3 wraps{};
    for (int a = 0; a < 3; ++a) {
      wraps[a] = periodic_[a] ? 1 + block_.ghost[a] / block_.global[a] : 0;
    }
    for (int k = -wraps[2]; k <= wraps[2]; ++k) {
      for (int j = -wraps[1]; j <= wraps[1]; ++j) {
        for (int i = -wraps[0]; i <= wraps[0]; ++i) {
          const Int3 shift{i, j, k};
          bool inside = true;
          Vec3 centre = balls_[b].centre;
          for (int a = 0; a < 3; ++a) {
            const Span cells = cells_of(balls_[b], spacing_, a);
            const int move = shift[a] * block_.global[a];
            inside = inside && overlap({cells.first + move, cells.last + move},
                                       {block_.start[a] - block_.ghost[a],
                                        block_.start[a] + block_.n[a] + block_.ghost[a] + 1});
            centre[a] += move * spacing_[a];
          }
          if (inside) {
            images_.push_back({static_cast<int>(b), centre});
          }
        }
      }
    }
  }
}

template <std::size_t count>
void SphereSet::sum(std::vector<std::array<Real, count>>& parts) {
  constexpr int tag = 72;
  const std::size_t n = neighbours_.size();
  std::vector<std::vector<Real>> out(n);
  std::vector<std::vector<Real>> in(n);
  std::vector<MPI_Request> requests(2 * n, MPI_REQUEST_NULL);
  for (std::size_t q = 0; q < n; ++q) {
    const Neighbour& neighbour = neighbours_[q];
    const int values = static_cast<int>(neighbour.shared.size() * count);
    if (values == 0) {
      continue;
    }
    out[q].reserve(static_cast<std::size_t>(values));
    for (const int b : neighbour.shared) {
      out[q].insert(out[q].end(), parts[b].begin(), parts[b].end());
    }
    in[q].resize(static_cast<std::size_t>(values));
    MPI_Irecv(in[q].data(), values, MPI_DOUBLE, neighbour.rank, tag, comm_.handle(),
              &requests[2 * q]);
    MPI_Isend(out[q].data(), values, MPI_DOUBLE, neighbour.rank, tag, comm_.handle(),
              &requests[2 * q + 1]);
  }
  MPI_Waitall(static_cast<int>(2 * n), requests.data(), MPI_STATUSES_IGNORE);
  if (n == 0) {
    return;
  }
  const std::vector<std::array<Real, count>> own = parts;
  for (auto& part : parts) {
    part.fill(0);
  }
  bool own_added = false;
  const auto add_own = [&] {
    for (std::size_t b = 0; b < parts.size(); ++b) {
      for (std::size_t v = 0; v < count; ++v) {
        parts[b][v] += own[b][v];
      }
    }
    own_added = true;
  };
  for (std::size_t q = 0; q < n; ++q) {  // in the order of ranks
    if (!own_added && neighbours_[q].rank > comm_.rank()) {
      add_own();
    }
    const Real* from = in[q].data();
    for (const int b : neighbours_[q].shared) {
      for (std::size_t v = 0; v < count; ++v) {
        parts[b][v] += *from++;
      }
    }
  }
  if (!own_added) {
    add_own();
  }
}

template void SphereSet::sum<6>(std::vector<std::array<Real, 6>>&);
template void SphereSet::sum<36>(std::vector<std::array<Real, 36>>&);

template <typename Record>
std::vector<Record> SphereSet::gather_near(const std::vector<Record>& mine) const {
  std::vector<int> ranks;
  for (const Neighbour& neighbour : neighbours_) {
    ranks.push_back(neighbour.rank);
  }
  const std::vector<const std::vector<Record>*> out(ranks.size(), &mine);
  const auto in = swap_with<Record>(comm_.handle(), ranks, out);
  std::vector<Record> all;
  bool own_added = false;
  for (std::size_t q = 0; q <= in.size(); ++q) {
    if (!own_added && (q == in.size() || ranks[q] > comm_.rank())) {
      all.insert(all.end(), mine.begin(), mine.end());
      own_added = true;
    }
    if (q < in.size()) {
      all.insert(all.end(), in[q].begin(), in[q].end());
    }
  }
  return all;
}

template std::vector<CellShare> SphereSet::gather_near(const std::vector<CellShare>&) const;

int SphereSet::find(std::uint64_t id) const {
  const auto at = std::lower_bound(by_id_.begin(), by_id_.end(), std::pair{id, 0});
  return at != by_id_.end() && at->first == id ? at->second : -1;
}

}  // namespace porefines::flow
