// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <optional>
#include <string>

#include "geom/image.hpp"
#include "geom/voxels.hpp"

namespace porefines::geom {

/// How grey levels become pore and grain.
struct Segmentation {
  int pore_value = 255;          ///< binary image: this value is pore, everything else grain
  std::optional<int> threshold;  ///< grey image: bright = grey level >= threshold
  bool otsu = false;             ///< threshold chosen by otsu_threshold
  bool pore_is_bright = true;
};

/// Grey level t that separates best: maximises the variance between the classes < t and >= t,
///
///     w0 w1 (m0 - m1)^2,
///
/// with the classes' shares w and means m; the middle of a plateau (Otsu 1979).
/// Error: InputError when the image has one grey level only.
[[nodiscard]] int otsu_threshold(const GreyVolume& image, const std::string& name);

/// Binary volume of a grey one. Reuses the memory of `image`.
///
/// With a threshold the voxels at the surface keep how much of them is pore: linear in their level, full
/// at the median level of each class, half at the threshold (Otsu's: midway between the medians).
/// Test: unit/geom_grey, discs to 0.02 pixel where the binary picture gives 0.18.
///
/// Errors: InputError when pore_value does not occur, or when an image with more than 16 grey
/// levels comes without a threshold; also when everything or nothing is pore.
[[nodiscard]] Voxels segment(GreyVolume image, const Segmentation& how, const std::string& name);

/// Shares where the pores have not been changed since; elsewhere voxels are full.
void keep_shares_of_unchanged(Voxels& voxels);

/// Part {first, past last} of a volume, in voxels with y upwards; all zeros: everything.
[[nodiscard]] GreyVolume crop(GreyVolume image, const Int3& first, const Int3& past,
                              const std::string& name);

}  // namespace porefines::geom
