// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <string>
#include <vector>

#include "geom/build.hpp"
#include "geom/metrics.hpp"

namespace porefines {

/// The options of `porefines inspect` as the user wrote them.
struct InspectArguments {
  std::string input;
  std::vector<std::string> overrides;
  std::string pixel_size;
  int pore_value = 255;
  std::string threshold;
  bool dark_pores = false;
  std::vector<int> raw_size;
  std::string depth;
  std::string fine_diameter;
  std::string erode_grains;
  std::string edit_mask;
  int reconnect_gap = 0;
  std::string minimum_throat;
  std::string flow = "x+";
  std::string stl;
  std::string output = "inspect";
};

/// What to look at and what is asked of it.
struct Inspection {
  geom::Spec spec;
  geom::Question question;
  BoxFace flow_to = BoxFace::x_high;
  Real simplify = 0.5;  ///< [pixels]
};

/// The binary volumes before and after cleaning.
struct Volumes {
  geom::SharedVoxels found;
  geom::SharedVoxels kept;
  Real pixel = 0;
  std::string warning;
};

/// From a case or from an image and its options.
/// @throws InputError
[[nodiscard]] Inspection understand(const InspectArguments& arguments);

/// Read and clean on this rank alone. Where no pore carries flow everything is kept and the
/// reason becomes the warning; lists of grains are made an image.
/// @throws InputError
[[nodiscard]] Volumes build_volumes(Inspection& inspection);

}  // namespace porefines
