// SPDX-License-Identifier: MPL-2.0
#include "geom/throat_opening.hpp"

#include <algorithm>

#include "geom/nearest.hpp"
#include "geom/thinning.hpp"

namespace porefines::geom {

namespace {

/// Twice the resolution in the plane of a 2D image, so that odd and even widths count alike.
VoxelView refine(const VoxelView& image, Voxels& store) {
  store = make_voxels({2 * image.n[0], 2 * image.n[1], 1}, 0);
  for (int j = 0; j < store.n[1]; ++j) {
    for (int i = 0; i < store.n[0]; ++i) {
      store.at(i, j, 0) = image.at(i / 2, j / 2, 0) ? 1 : 0;
    }
  }
  return store.view();
}

/// Squared distance from each voxel centre to the nearest grain voxel centre, `none` beyond reach.
std::vector<int> squared_distance(const VoxelView& image, const Surroundings& beyond, int reach,
                                  int none) {
  const bool flat = image.n[2] == 1;
  const int rz = flat ? 0 : reach;
  const Int3 n{image.n[0] + 2 * reach, image.n[1] + 2 * reach, image.n[2] + 2 * rz};
  std::vector<std::uint8_t> grain(static_cast<std::size_t>(product(n)));
  std::size_t v = 0;
  for (int k = -rz; k < image.n[2] + rz; ++k) {
    for (int j = -reach; j < image.n[1] + reach; ++j) {
      for (int i = -reach; i < image.n[0] + reach; ++i, ++v) {
        grain[v] = is_pore(image, beyond, i, j, k) ? 0 : 1;
      }
    }
  }
  std::vector<int> out(static_cast<std::size_t>(product(image.n)));
  for_each_nearest(grain, n, reach, [&](int j, int k, const std::vector<Offset>& row) {
    int* const to = &out[static_cast<std::size_t>(voxel_index(image.n, 0, j, k))];
    for (std::size_t i = 0; i < row.size(); ++i) {
      const Offset& o = row[i];
      to[i] = o.dx == Offset::nothing ? none : o.dx * o.dx + o.dy * o.dy + o.dz * o.dz;
    }
  });
  return out;
}

/// Per voxel a distance that orders the thinning, and whether it belongs to the core.
struct Depth {
  std::vector<int> square;
  std::vector<std::uint8_t> core;
};

Depth measure_depth(const VoxelView& image, const Surroundings& beyond, Real width) {
  Depth out;
  constexpr int none = INT32_MAX;
  if (image.n[2] > 1) {  // 2 distance >= width
    out.square = squared_distance(image, beyond, static_cast<int>(width) + 2, none);
    for (const int d2 : out.square) {
      out.core.push_back(4.0 * d2 >= width * width ? 1 : 0);
    }
    return out;
  }
  Voxels fine;
  const auto d2 =
      squared_distance(refine(image, fine), beyond, static_cast<int>(std::ceil(width)) + 2, none);
  out.square.resize(static_cast<std::size_t>(product(image.n)));
  out.core.resize(out.square.size());
  for (int j = 0; j < image.n[1]; ++j) {
    for (int i = 0; i < image.n[0]; ++i) {
      int deepest = 0;
      for (const Index quarter : {Index{0}, Index{1}, Index{fine.n[0]}, Index{fine.n[0]} + 1}) {
        deepest = std::max(
            deepest, d2[static_cast<std::size_t>(voxel_index(fine.n, 2 * i, 2 * j, 0) + quarter)]);
      }
      const auto v = static_cast<std::size_t>(voxel_index(image.n, i, j, 0));
      out.square[v] = deepest;
      out.core[v] = deepest >= width * width ? 1 : 0;
    }
  }
  return out;
}

/// Whether pore voxel v is at least as deep as its neighbours within the face normal to `axis`.
bool is_deepest_on_face(const Int3& n, const Depth& depth, Index v, const Int3& x,
                        std::size_t axis) {
  const std::array<Index, 3> stride{1, n[0], Index{n[0]} * n[1]};
  for (std::size_t t = 0; t < 3; ++t) {
    for (const int side : {-1, 1}) {
      const bool inside = t != axis && x[t] + side >= 0 && x[t] + side < n[t];
      if (inside && depth.square[static_cast<std::size_t>(v + side * stride[t])] >
                        depth.square[static_cast<std::size_t>(v)]) {
        return false;
      }
    }
  }
  return true;
}

/// Keep the middle of every stretch of pore on a box face that is not periodic: a way out.
void anchor_faces(const VoxelView& image, const Surroundings& beyond, const Depth& depth,
                  std::vector<std::uint8_t>& anchor) {
  const Int3 n = image.n;
  for (Index v = 0; v < product(n); ++v) {
    const Int3 x = position(n, v);
    for (std::size_t axis = 0; axis < (n[2] == 1 ? 2U : 3U); ++axis) {
      const bool on_face =
          beyond[axis] != Beyond::periodic && (x[axis] == 0 || x[axis] == n[axis] - 1);
      if (on_face && image.pore[v] != 0 && is_deepest_on_face(n, depth, v, x, axis)) {
        anchor[static_cast<std::size_t>(v)] = 1;
      }
    }
  }
}

/// Set the voxels within `radius` of voxel v to pore. @return voxels opened
Index open_ball(Voxels& voxels, Index v, Real radius, const Surroundings& beyond) {
  const Int3 n = voxels.n;
  const int r = static_cast<int>(radius);
  const int rz = n[2] == 1 ? 0 : r;
  const auto [i, j, k] = position(n, v);
  Index opened = 0;
  for (int c = -rz; c <= rz; ++c) {
    for (int b = -r; b <= r; ++b) {
      for (int a = -r; a <= r; ++a) {
        if (a * a + b * b + c * c > radius * radius) {
          continue;
        }
        const Int3 x{fold(i + a, n[0], beyond[0]), fold(j + b, n[1], beyond[1]),
                     fold(k + c, n[2], beyond[2])};
        if (x[0] >= 0 && x[1] >= 0 && x[2] >= 0) {
          std::uint8_t& voxel = voxels.at(x[0], x[1], x[2]);
          opened += 1 - voxel;
          voxel = 1;
        }
      }
    }
  }
  return opened;
}

/// A pore without core and without a way out shrinks to one voxel: not a link.
bool is_lone(const std::vector<std::uint8_t>& lines, const Voxels& voxels, Index v,
             const Surroundings& beyond) {
  const Int3 n = voxels.n;
  const auto [i, j, k] = position(n, v);
  for (int a = 0; a < 27; ++a) {
    const Int3 x{fold(i + a % 3 - 1, n[0], beyond[0]), fold(j + a / 3 % 3 - 1, n[1], beyond[1]),
                 fold(k + a / 9 - 1, n[2], beyond[2])};
    const bool inside = x[0] >= 0 && x[1] >= 0 && x[2] >= 0;
    const Index u = inside ? voxel_index(n, x[0], x[1], x[2]) : v;
    if (u != v && lines[static_cast<std::size_t>(u)] != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

Index open_throats(Voxels& voxels, Real width, const Surroundings& beyond) {
  Index opened = 0;
  for (int round = 0; round < 3 && width > 1; ++round) {
    const Depth depth = measure_depth(voxels.view(), beyond, width);
    std::vector<std::uint8_t> anchor = depth.core;
    anchor_faces(voxels.view(), beyond, depth, anchor);
    const auto lines = thin(voxels.view(), beyond, depth.square, anchor);
    Index now = 0;
    for (Index v = 0; v < product(voxels.n); ++v) {
      const auto u = static_cast<std::size_t>(v);
      if (lines[u] != 0 && depth.core[u] == 0 && !is_lone(lines, voxels, v, beyond)) {
        now += open_ball(voxels, v, 0.5 * width, beyond);
      }
    }
    opened += now;
    if (now == 0) {
      break;
    }
  }
  return opened;
}

}  // namespace porefines::geom
