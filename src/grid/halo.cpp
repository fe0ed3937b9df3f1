// SPDX-License-Identifier: MPL-2.0
#include "grid/halo.hpp"

#include <algorithm>
#include <cstring>
#include <utility>
#include <vector>

namespace porefines::grid {

namespace {

/// Index range [first, last) along each axis.
struct Region {
  Int3 first;
  Int3 last;
  [[nodiscard]] std::size_t count() const {
    return static_cast<std::size_t>(last[0] - first[0]) * (last[1] - first[1]) *
           (last[2] - first[2]);
  }
};

/// Layers [first, last) of `axis`; across it what is valid by now: ghosts of the axes before it.
Region layers(const Block& b, int axis, int first, int last, int depth) {
  Region r{};
  for (int a = 0; a < 3; ++a) {
    const int reach = a < axis ? std::min(depth, b.ghost[a]) : 0;
    r.first[a] = -reach;
    r.last[a] = b.n[a] + reach + 1;
  }
  r.first[axis] = first;
  r.last[axis] = last;
  return r;
}

template <typename Move>
void for_rows(const Region& r, const Move& move) {
  for (int k = r.first[2]; k < r.last[2]; ++k) {
    for (int j = r.first[1]; j < r.last[1]; ++j) {
      move(j, k);
    }
  }
}

void pack(const Block& b, const Region& r, std::span<float* const> fields,
          std::vector<float>& out) {
  out.resize(r.count() * fields.size());
  float* to = out.data();
  const int width = r.last[0] - r.first[0];
  for (const float* field : fields) {
    for_rows(r, [&](int j, int k) {
      std::memcpy(to, field + b.at(r.first[0], j, k), sizeof(float) * width);
      to += width;
    });
  }
}

void unpack(const Block& b, const Region& r, std::span<float* const> fields,
            const std::vector<float>& in) {
  const float* from = in.data();
  const int width = r.last[0] - r.first[0];
  for (float* field : fields) {
    for_rows(r, [&](int j, int k) {
      std::memcpy(field + b.at(r.first[0], j, k), from, sizeof(float) * width);
      from += width;
    });
  }
}

}  // namespace

Halo::Halo(const par::Communicator& comm, const par::Decomposition& decomposition,
           const Block& block, const std::array<bool, 3>& periodic)
    : comm_(comm.handle()), block_(block) {
  const Int3 here = decomposition.coordinates(comm.rank());
  for (int a = 0; a < 3; ++a) {
    const int parts = decomposition.ranks[a];
    wraps_[a] = periodic[a] && parts == 1;
    const auto neighbour = [&](int step) {
      Int3 there = here;
      there[a] += step;
      const bool outside = there[a] < 0 || there[a] >= parts;
      if (parts == 1 || (outside && !periodic[a])) {
        return MPI_PROC_NULL;
      }
      there[a] = (there[a] + parts) % parts;
      return decomposition.rank_at(there);
    };
    low_[a] = neighbour(-1);
    high_[a] = neighbour(+1);
  }
}

void Halo::exchange(std::span<float* const> fields, int depth) {
  for (int a = 0; a < 3; ++a) {
    if (wraps_[a]) {
      wrap_axis(fields, a, depth);
    } else if (low_[a] != MPI_PROC_NULL || high_[a] != MPI_PROC_NULL) {
      exchange_axis(fields, a, depth);
    }
  }
}

void Halo::wrap_axis(std::span<float* const> fields, int axis, int depth) {
  const int n = block_.n[axis];
  const std::ptrdiff_t step = block_.stride(axis);
  std::vector<std::pair<int, int>> copies;  // to a ghost layer, from the layer that it repeats
  for (int layer = -depth; layer <= n + depth; ++layer) {
    if (layer < 0 || layer >= n) {
      copies.emplace_back(layer, ((layer % n) + n) % n);
    }
  }
  for (float* field : fields) {
    if (axis == 0) {  // a few values per row: one pass over the rows
      for_rows(layers(block_, axis, 0, 1, depth), [&](int j, int k) {
        float* row = field + block_.at(0, j, k);
        for (const auto& [to, from] : copies) {
          row[to] = row[from];
        }
      });
      continue;
    }
    for (const auto& [to, from] : copies) {
      const Region r = layers(block_, axis, to, to + 1, depth);
      const int width = r.last[0] - r.first[0];
      for_rows(r, [&, way = (from - to) * step](int j, int k) {
        float* row = field + block_.at(r.first[0], j, k);
        std::memcpy(row, row + way, sizeof(float) * width);
      });
    }
  }
}

void Halo::exchange_axis(std::span<float* const> fields, int axis, int depth) {
  const int n = block_.n[axis];
  const Region to_low = layers(block_, axis, 0, depth + 1, depth);
  const Region to_high = layers(block_, axis, n - depth, n, depth);
  const Region from_low = layers(block_, axis, -depth, 0, depth);
  const Region from_high = layers(block_, axis, n, n + depth + 1, depth);
  auto& [send_low, send_high, get_low, get_high] = buffer_;
  std::array<MPI_Request, 4> requests{};
  get_low.resize(from_low.count() * fields.size());
  get_high.resize(from_high.count() * fields.size());
  const auto count = [](const std::vector<float>& v) { return static_cast<int>(v.size()); };
  MPI_Irecv(get_low.data(), count(get_low), MPI_FLOAT, low_[axis], 0, comm_, &requests[0]);
  MPI_Irecv(get_high.data(), count(get_high), MPI_FLOAT, high_[axis], 1, comm_, &requests[1]);
  pack(block_, to_low, fields, send_low);
  pack(block_, to_high, fields, send_high);
  MPI_Isend(send_low.data(), count(send_low), MPI_FLOAT, low_[axis], 1, comm_, &requests[2]);
  MPI_Isend(send_high.data(), count(send_high), MPI_FLOAT, high_[axis], 0, comm_, &requests[3]);
  MPI_Waitall(4, requests.data(), MPI_STATUSES_IGNORE);
  if (low_[axis] != MPI_PROC_NULL) {
    unpack(block_, from_low, fields, get_low);
    ++messages_, bytes_ += static_cast<Index>(send_low.size() * sizeof(float));
  }
  if (high_[axis] != MPI_PROC_NULL) {
    unpack(block_, from_high, fields, get_high);
    ++messages_, bytes_ += static_cast<Index>(send_high.size() * sizeof(float));
  }
}

}  // namespace porefines::grid
