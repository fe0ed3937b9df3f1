// SPDX-License-Identifier: MPL-2.0
#include "geom/edit.hpp"

#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"
#include "geom/nearest.hpp"

namespace porefines::geom {

namespace {

constexpr std::uint8_t opens = 255;
constexpr std::uint8_t closes = 0;

std::string text(const Int3& n) {
  return fmt::format("{} x {} x {}", n[0], n[1], n[2]);
}

void require_sensible(const Voxels& voxels, const GreyVolume& mask, const std::string& name) {
  if (mask.n != voxels.n) {
    throw InputError(
        fmt::format("{}: the edit mask has {} voxels, the image {}.\nThe mask must be as large as "
                    "the image: paint it over a copy of the image.",
                    name, text(mask.n), text(voxels.n)));
  }
  Index edits = 0;
  for (const std::uint8_t grey : mask.grey) {
    edits += grey == opens || grey == closes ? 1 : 0;
  }
  if (edits == 0 || edits == product(mask.n)) {
    throw InputError(
        fmt::format("{}: {} voxel of the edit mask is black or white.\nPaint on grey: white (255) "
                    "opens, black (0) closes, any other grey leaves the image as it is.",
                    name, edits == 0 ? "no" : "every"));
  }
}

}  // namespace

Index erode_grains(Voxels& voxels, Real depth, const Surroundings& beyond) {
  if (depth <= 0.5) {
    return 0;
  }
  Surroundings closed = beyond;
  for (Beyond& side : closed) {
    side = side == Beyond::pore ? Beyond::mirror : side;
  }
  const int reach = static_cast<int>(std::ceil(depth + 0.5));
  const int deep = voxels.n[2] == 1 ? 0 : reach;
  const Int3 grown{voxels.n[0] + 2 * reach, voxels.n[1] + 2 * reach, voxels.n[2] + 2 * deep};
  std::vector<std::uint8_t> pore(static_cast<std::size_t>(product(grown)));
  std::size_t at = 0;
  for (int k = -deep; k < voxels.n[2] + deep; ++k) {
    for (int j = -reach; j < voxels.n[1] + reach; ++j) {
      for (int i = -reach; i < voxels.n[0] + reach; ++i, ++at) {
        pore[at] = is_pore(voxels.view(), closed, i, j, k) ? 1 : 0;
      }
    }
  }
  const Real nearer = (depth + 0.5) * (depth + 0.5);
  Index opened = 0;
  for_each_nearest(pore, grown, reach, [&](int j, int k, const std::vector<Offset>& row) {
    for (int i = 0; i < voxels.n[0]; ++i) {
      const Offset& o = row[static_cast<std::size_t>(i)];
      const bool near = o.dx != Offset::nothing && o.dx * o.dx + o.dy * o.dy + o.dz * o.dz < nearer;
      std::uint8_t& voxel = voxels.at(i, j, k);
      opened += near ? 1 - voxel : 0;
      voxel = near ? 1 : voxel;
    }
  });
  return opened;
}

Index apply_edit_mask(Voxels& voxels, const GreyVolume& mask, const std::string& name) {
  require_sensible(voxels, mask, name);
  Index changed = 0;
  for (std::size_t at = 0; at < voxels.pore.size(); ++at) {
    if (mask.grey[at] == opens || mask.grey[at] == closes) {
      const std::uint8_t wanted = mask.grey[at] == opens ? 1 : 0;
      changed += wanted != voxels.pore[at] ? 1 : 0;
      voxels.pore[at] = wanted;
    }
  }
  return changed;
}

}  // namespace porefines::geom
