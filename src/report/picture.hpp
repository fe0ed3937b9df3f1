// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/types.hpp"
#include "io/provenance.hpp"
#include "report/picture_colormap.hpp"

namespace porefines::report {

/// A plane of cell values that belongs to someone else; row 0 is drawn at the bottom.
struct Slice {
  std::span<const float> values = {};        ///< SI, [height][width] cells
  int width = 0;                             ///< cells
  int height = 0;                            ///< cells
  std::span<const std::uint8_t> grain = {};  ///< as values, nonzero: fixed solid; empty: no grains
  Real cell_width = 1;                       ///< [m]
  Real cell_height = 1;                      ///< [m]
  std::array<int, 2> axes = {0, 1};          ///< which axis runs to the right, which one up
  Real position = 0;                         ///< [m] along the third axis; shown beside composites
};

/// What the picture says and how.
struct PictureStyle {
  std::string title = {};
  std::string quantity = {};  ///< "speed", "pressure"
  std::string unit = {};      ///< SI: "m/s", "Pa"; prefixes are chosen here
  Colormap colormap = Colormap::speed;
  bool logarithmic = false;                       ///< at most four decades below the largest value
  std::optional<std::array<Real, 2>> range = {};  ///< SI; absent: from the values, see value_range
  bool smooth = true;                   ///< interpolate between cells; false: show the cells
  std::optional<BoxFace> flow_to = {};  ///< the face that the fluid flows to: draws an arrow
  int longer_side = 1200;               ///< [pixels] of the plot area, about
};

/// 8-bit colour, row 0 at the top.
struct Picture {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> rgb;  ///< 3 * width * height
};

/// Ends of the colour bar for these slices in SI: the fluid values without the outermost 0.1 % at
/// either end. From zero for values above it; symmetric about zero for the diverging map when
/// both signs occur; never empty, also when all values are the same or there are none.
[[nodiscard]] std::array<Real, 2> value_range(std::span<const Slice> slices,
                                              const PictureStyle& style);

/// One slice with title, colour bar, scale bar and flow arrow.
/// @throws RunError  when the sizes of the slice do not fit together
[[nodiscard]] Picture draw_slice(const Slice& slice, const PictureStyle& style);

/// Three orthogonal slices as a drawing in three views with shared axes and one colour bar:
/// x-y at the lower left, x-z above it, z-y to its right.
/// @param slices  normal to x, y, z in this order, as mid_slice makes them
[[nodiscard]] Picture draw_three_slices(const std::array<Slice, 3>& slices,
                                        const PictureStyle& style);

/// A slice that holds its values.
struct SliceValues {
  std::vector<float> values;
  std::vector<std::uint8_t> grain;
  Slice shape;  ///< without values and grain

  [[nodiscard]] Slice view() const;
};

/// The plane of cells nearest to the middle of a volume, normal to `axis`.
/// @param values, grain  x fastest, then y, z; grain may be empty
/// @param spacing        [m]
[[nodiscard]] SliceValues mid_slice(std::span<const float> values,
                                    std::span<const std::uint8_t> grain, const Int3& cells,
                                    const Vec3& spacing, int axis);

/// Saves as PNG with its provenance, whole or not at all; one rank. @throws RunError
void write_picture(const std::string& path, const Picture& picture,
                   const io::Provenance& provenance, const std::string& title = {});

}  // namespace porefines::report
