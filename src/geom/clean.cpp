// SPDX-License-Identifier: MPL-2.0
#include "geom/clean.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::geom {

namespace {

/// Set the voxels of all components that satisfy `condition` to `value`.
template <class Condition>
Index repaint(Voxels& voxels, const Components& components, std::uint8_t value,
              const Condition& condition) {
  Index changed = 0;
  for (std::size_t row = 0; row + 1 < components.row.size(); ++row) {
    std::uint8_t* const v = &voxels.pore[row * static_cast<std::size_t>(voxels.n[0])];
    for (std::size_t i = components.row[row]; i < components.row[row + 1]; ++i) {
      const auto& run = components.run[i];
      if (condition(components.component[static_cast<std::size_t>(run.component)])) {
        std::fill(v + run.first, v + run.past, value);
        changed += run.past - run.first;
      }
    }
  }
  return changed;
}

/// Component of every voxel of the phase, -1 elsewhere.
std::vector<std::int32_t> labels_of(const Components& components, const Int3& n) {
  std::vector<std::int32_t> label(static_cast<std::size_t>(product(n)), -1);
  for (std::size_t row = 0; row + 1 < components.row.size(); ++row) {
    const auto first = label.begin() + static_cast<std::ptrdiff_t>(row) * n[0];
    for (std::size_t i = components.row[row]; i < components.row[row + 1]; ++i) {
      const auto& run = components.run[i];
      std::fill(first + run.first, first + run.past, run.component);
    }
  }
  return label;
}

}  // namespace

Index remove_small(Voxels& voxels, Phase phase, Index fewest, const std::array<bool, 3>& periodic) {
  if (fewest <= 1) {
    return 0;
  }
  const auto components = find_components(voxels.view(), phase, periodic, 0);
  return repaint(voxels, components, phase == Phase::pore ? 0 : 1,
                 [&](const Component& part) { return part.voxels < fewest; });
}

Index keep_percolating(Voxels& voxels, const std::array<bool, 3>& periodic, int axis,
                       const std::string& name) {
  const bool around = periodic[static_cast<std::size_t>(axis)];
  const auto components = find_components(voxels.view(), Phase::pore, periodic, axis);
  Index largest = 0;
  bool any = false;
  for (const Component& part : components.component) {
    largest = std::max(largest, part.voxels);
    any = any || percolates(part, around);
  }
  if (!any) {
    const char letter = "xyz"[axis];
    const Index all = product(voxels.n);
    throw InputError(fmt::format(
        "{}: no pore path connects {}- and {}+{}; there are {} separate pores, the largest takes "
        "{:.1f} % of the image.\nCheck pore_value (are pore and grain swapped?) and the "
        "threshold, reopen throats (reconnect_gap opens thin walls; "
        "erode_grains, edit_mask), or set keep = \"all\".",
        name, letter, letter, around ? " around the period" : "", components.component.size(),
        100.0 * static_cast<Real>(largest) / static_cast<Real>(all)));
  }
  return repaint(voxels, components, 0,
                 [&](const Component& part) { return !percolates(part, around); });
}

Index reconnect(Voxels& voxels, int gap, const std::array<bool, 3>& periodic) {
  if (gap <= 0) {
    return 0;
  }
  const Int3 n = voxels.n;
  const auto label = labels_of(find_components(voxels.view(), Phase::pore, periodic, 0), n);
  const std::array<Index, 3> stride{1, n[0], Index{n[0]} * n[1]};
  Index opened = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (Index v = 0; v < product(n); ++v) {
      const Index at = v / stride[axis] % n[axis];
      const std::int32_t here = label[static_cast<std::size_t>(v)];
      for (int d = 1; here >= 0 && d <= gap + 1 && at + d < n[axis]; ++d) {
        const std::int32_t there = label[static_cast<std::size_t>(v + d * stride[axis])];
        if (there < 0) {
          continue;
        }
        for (int e = 1; there != here && e < d; ++e) {
          std::uint8_t& voxel = voxels.pore[static_cast<std::size_t>(v + e * stride[axis])];
          opened += 1 - voxel;
          voxel = 1;
        }
        break;
      }
    }
  }
  return opened;
}

}  // namespace porefines::geom
