// SPDX-License-Identifier: MPL-2.0
#include "geom/nearest.hpp"

#include <algorithm>

namespace porefines::geom {

namespace {

/// How distance and offsets share the bits of a key: [distance^2 | dz | dy | dx].
/// "None" is a large distance that still leaves room for two more squares.
template <class Key>
struct Packing {
  int code;  ///< bits per offset
  Key none;
  [[nodiscard]] Key pack(int d, int axis) const {
    const auto bias = static_cast<Key>(1) << (code - 1);
    return (static_cast<Key>(d * d) << (3 * code)) +
           ((static_cast<Key>(d) + bias) << (axis * code));
  }
  [[nodiscard]] int offset(Key key, int axis) const {
    const auto mask = (static_cast<Key>(1) << code) - 1;
    return static_cast<int>((key >> (axis * code)) & mask) - (1 << (code - 1));
  }
};

constexpr Packing<std::uint32_t> small_packing{6, std::uint32_t{8191} << 18};        // reach <= 31
constexpr Packing<std::uint64_t> large_packing{10, (std::uint64_t{1} << 32) << 30};  // reach <= 500

/// Pass along x by two scans: distance to the nearest mark of the row, lower offset first.
template <class Key>
void scan_row(const std::uint8_t* mark, int count, int reach, const Packing<Key>& packing,
              Key* out) {
  for (int x = 0; x < count; ++x) {
    Key best = packing.none;
    const std::uint8_t* centre = mark + x + reach;
    for (int d = 0; d <= reach; ++d) {
      if (centre[-d] != 0) {
        best = packing.pack(-d, 0);
        break;
      }
      if (centre[d] != 0) {
        best = packing.pack(d, 0);
        break;
      }
    }
    out[x] = best;
  }
}

/// out[x] = min over d of rows[d][x] + pack(d).
template <class Key>
void min_rows(const Key* first, Index stride, int count, int reach, int axis,
              const Packing<Key>& packing, Key* out) {
  std::fill(out, out + count, packing.none);
  for (int d = -reach; d <= reach; ++d) {
    const Key* in = first + (d + reach) * stride;
    const Key step = packing.pack(d, axis);
    for (int x = 0; x < count; ++x) {
      out[x] = std::min(out[x], static_cast<Key>(in[x] + step));
    }
  }
}

template <class Key>
void transform(const std::vector<std::uint8_t>& mark, const Int3& n, int reach,
               const Packing<Key>& packing, const VisitRow& visit) {
  const bool flat = n[2] == 1;
  const int nx = n[0] - 2 * reach;
  const int ny = n[1] - 2 * reach;
  const int nz = flat ? 1 : n[2] - 2 * reach;
  std::vector<Key> along_x(static_cast<std::size_t>(nx) * n[1]);
  std::vector<Key> along_y(static_cast<std::size_t>(nx) * ny * n[2]);
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      scan_row(&mark[static_cast<std::size_t>(Index{n[0]} * (j + Index{n[1]} * k))], nx, reach,
               packing, &along_x[static_cast<std::size_t>(nx) * j]);
    }
    for (int j = 0; j < ny; ++j) {
      min_rows(&along_x[static_cast<std::size_t>(nx) * j], nx, nx, reach, 1, packing,
               &along_y[static_cast<std::size_t>(nx) * (j + static_cast<std::size_t>(ny) * k)]);
    }
  }
  std::vector<Key> key(static_cast<std::size_t>(nx));
  std::vector<Offset> row(static_cast<std::size_t>(nx));
  const Index plane = Index{nx} * ny;
  for (int k = 0; k < nz; ++k) {
    for (int j = 0; j < ny; ++j) {
      const Key* first = &along_y[static_cast<std::size_t>(Index{nx} * j + plane * k)];
      min_rows(first, plane, nx, flat ? 0 : reach, 2, packing, key.data());
      for (std::size_t x = 0; x < row.size(); ++x) {
        row[x] = key[x] >= packing.none
                     ? Offset{}
                     : Offset{static_cast<std::int16_t>(packing.offset(key[x], 0)),
                              static_cast<std::int16_t>(packing.offset(key[x], 1)),
                              static_cast<std::int16_t>(packing.offset(key[x], 2))};
      }
      visit(j, k, row);
    }
  }
}

}  // namespace

void for_each_nearest(const std::vector<std::uint8_t>& mark, const Int3& n, int reach,
                      const VisitRow& visit) {
  if (reach <= 31) {
    transform(mark, n, reach, small_packing, visit);
  } else {
    transform(mark, n, reach, large_packing, visit);
  }
}

}  // namespace porefines::geom
