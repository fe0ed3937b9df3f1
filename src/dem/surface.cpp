// SPDX-License-Identifier: MPL-2.0
#include "dem/surface.hpp"

namespace porefines::dem {

void find_touches(const Surface& surface, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  std::visit([&](const auto& kind) { find_touches(kind, centre, radius, reach, out); }, surface);
}

void find_touches(const Surfaces& surfaces, const Vec3& centre, Real radius, Real reach,
                  TouchList& out) {
  out.clear();
  for (std::size_t part = 0; part < surfaces.size(); ++part) {
    const auto first = static_cast<std::size_t>(out.count);
    find_touches(surfaces[part], centre, radius, reach, out);
    for (std::size_t t = first; t < static_cast<std::size_t>(out.count); ++t) {
      out.touch[t].feature |= static_cast<std::uint32_t>(part) << surface_shift;
    }
  }
}

}  // namespace porefines::dem
