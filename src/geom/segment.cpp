// SPDX-License-Identifier: MPL-2.0
#include "geom/segment.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/error.hpp"

namespace porefines::geom {

namespace {

using Histogram = std::array<Index, 256>;

Histogram count_levels(const GreyVolume& image) {
  Histogram histogram{};
  for (const std::uint8_t grey : image.grey) {
    ++histogram[grey];
  }
  return histogram;
}

/// "0 (80.1 %), 255 (19.9 %)": the commonest grey levels.
std::string describe(const Histogram& histogram, std::size_t voxels) {
  std::vector<int> levels;
  for (int level = 0; level < 256; ++level) {
    if (histogram[static_cast<std::size_t>(level)] > 0) {
      levels.push_back(level);
    }
  }
  std::stable_sort(levels.begin(), levels.end(), [&](int a, int b) {
    return histogram[static_cast<std::size_t>(a)] > histogram[static_cast<std::size_t>(b)];
  });
  std::string text;
  for (std::size_t i = 0; i < std::min<std::size_t>(levels.size(), 4); ++i) {
    const auto count = static_cast<Real>(histogram[static_cast<std::size_t>(levels[i])]);
    text += fmt::format("{}{} ({:.1f} %)", i == 0 ? "" : ", ", levels[i],
                        100 * count / static_cast<Real>(voxels));
  }
  return text + (levels.size() > 4 ? ", ..." : "");
}

void require_binary(const Histogram& histogram, int pore_value, const GreyVolume& image,
                    const std::string& name) {
  constexpr int most_labels = 16;
  const auto levels =
      std::count_if(histogram.begin(), histogram.end(), [](Index n) { return n > 0; });
  const bool inside = pore_value >= 0 && pore_value < 256;
  if (!inside || histogram[static_cast<std::size_t>(pore_value)] == 0) {
    throw InputError(fmt::format(
        "{}: pore_value = {} does not occur in the image; found {}.\nSet pore_value to one of "
        "them, or give a threshold.",
        name, pore_value, describe(histogram, image.grey.size())));
  }
  if (levels > most_labels) {
    throw InputError(fmt::format(
        "{}: this is a grey image ({} grey levels: {}), not a binary one.\nGive a threshold: "
        "\"otsu\" or a grey level 0..255.",
        name, levels, describe(histogram, image.grey.size())));
  }
}

/// The level that half of the voxels of a class reach: what a voxel wholly of that class looks like.
Real middle_level(const Histogram& histogram, int first, int past) {
  Index total = 0;
  for (int level = first; level < past; ++level) {
    total += histogram[static_cast<std::size_t>(level)];
  }
  Index below = 0;
  int level = first;
  for (; level + 1 < past; ++level) {
    below += histogram[static_cast<std::size_t>(level)];
    if (2 * below >= total) {
      break;
    }
  }
  return level;
}

/// Pore share of a voxel of each grey level: linear from the middle level of each class to the cut,
/// which is midway between them where the threshold is Otsu's.
std::array<std::uint8_t, 256> shares_of_levels(const Histogram& histogram, int threshold,
                                               const Segmentation& how) {
  constexpr int half = full_share / 2;
  const Real dark = middle_level(histogram, 0, threshold);
  const Real bright = middle_level(histogram, threshold, 256);
  const Real cut = how.otsu ? 0.5 * (dark + bright) : threshold - 0.5;
  std::array<std::uint8_t, 256> share{};
  for (int level = 0; level < 256; ++level) {
    const Real full = level > cut ? bright - cut : cut - dark;
    const Real towards_bright = std::clamp((level - cut) / full, -1.0, 1.0);
    const auto of_half =
        static_cast<int>(std::lround(half * (how.pore_is_bright ? 1 : -1) * towards_bright));
    const bool pore = (level >= threshold) == how.pore_is_bright;
    share[static_cast<std::size_t>(level)] = static_cast<std::uint8_t>(
        pore ? std::max(half + of_half, half) : std::min(half + of_half, half - 1));
  }
  return share;
}

/// Voxels of one phase with all their neighbours are full: what varies there is noise. Forgets the
/// shares where then all are full.
void fill_inside(Voxels& voxels) {
  const Int3 n = voxels.n;
  const auto alone = [&](int i, int j, int k) {
    const bool pore = voxels.at(i, j, k);
    for (int c = std::max(k - 1, 0); c <= std::min(k + 1, n[2] - 1); ++c) {
      for (int b = std::max(j - 1, 0); b <= std::min(j + 1, n[1] - 1); ++b) {
        for (int a = std::max(i - 1, 0); a <= std::min(i + 1, n[0] - 1); ++a) {
          if (voxels.at(a, b, c) != pore) {
            return false;
          }
        }
      }
    }
    return true;
  };
  bool partial = false;
  for (int k = 0; k < n[2]; ++k) {
    for (int j = 0; j < n[1]; ++j) {
      for (int i = 0; i < n[0]; ++i) {
        std::uint8_t& share = voxels.share[static_cast<std::size_t>(voxel_index(n, i, j, k))];
        if (share != 0 && share != full_share && alone(i, j, k)) {
          share = voxels.at(i, j, k) ? full_share : 0;
        }
        partial = partial || (share != 0 && share != full_share);
      }
    }
  }
  if (!partial) {
    voxels.share.clear();
  }
}

}  // namespace

void keep_shares_of_unchanged(Voxels& voxels) {
  for (std::size_t v = 0; v < voxels.share.size(); ++v) {
    const bool pore = voxels.pore[v] != 0;
    if ((2 * voxels.share[v] >= full_share) != pore) {
      voxels.share[v] = pore ? full_share : 0;
    }
  }
}

int otsu_threshold(const GreyVolume& image, const std::string& name) {
  const Histogram histogram = count_levels(image);
  Real total = 0;
  for (std::size_t level = 0; level < histogram.size(); ++level) {
    total += static_cast<Real>(level) * static_cast<Real>(histogram[level]);
  }
  const auto count = static_cast<Real>(image.grey.size());
  Real below = 0;
  Real sum_below = 0;
  Real best = 0;
  int first = 0;
  int last = 0;
  for (int t = 1; t < 256; ++t) {
    const auto level = static_cast<std::size_t>(t - 1);
    below += static_cast<Real>(histogram[level]);
    sum_below += static_cast<Real>(level) * static_cast<Real>(histogram[level]);
    const Real above = count - below;
    if (below == 0 || above == 0) {
      continue;
    }
    const Real apart = sum_below / below - (total - sum_below) / above;
    const Real between = (below / count) * (above / count) * apart * apart;
    if (between > best) {
      best = between;
      first = t;
    }
    if (between == best) {
      last = t;
    }
  }
  if (first == 0) {
    throw InputError(name + ": the image has one grey level only; nothing to threshold.");
  }
  return (first + last + 1) / 2;
}

Voxels segment(GreyVolume image, const Segmentation& how, const std::string& name) {
  std::array<std::uint8_t, 256> is_pore{};
  std::array<std::uint8_t, 256> share{};
  const bool grey = how.otsu || how.threshold;
  if (grey) {
    const int t = how.otsu ? otsu_threshold(image, name) : *how.threshold;
    share = shares_of_levels(count_levels(image), t, how);
    for (int level = 0; level < 256; ++level) {
      is_pore[static_cast<std::size_t>(level)] = (level >= t) == how.pore_is_bright ? 1 : 0;
    }
  } else {
    const int value = how.pore_value == 65535 ? 255 : how.pore_value;  // 16-bit full scale
    require_binary(count_levels(image), value, image, name);
    is_pore[static_cast<std::size_t>(value)] = 1;
  }
  Voxels voxels{image.n, {}, {}};
  if (grey) {
    voxels.share.resize(image.grey.size());
    std::transform(image.grey.begin(), image.grey.end(), voxels.share.begin(),
                   [&](std::uint8_t level) { return share[level]; });
  }
  Index pores = 0;
  for (std::uint8_t& voxel : image.grey) {
    voxel = is_pore[voxel];
    pores += voxel;
  }
  if (pores == 0 || pores == product(image.n)) {
    throw InputError(
        fmt::format("{}: after thresholding everything is {}.\nTry another threshold, "
                    "or \"otsu\".",
                    name, pores == 0 ? "grain" : "pore"));
  }
  voxels.pore = std::move(image.grey);
  if (grey) {
    fill_inside(voxels);
  }
  return voxels;
}

GreyVolume crop(GreyVolume image, const Int3& first, const Int3& past, const std::string& name) {
  if (first == Int3{} && past == Int3{}) {
    return image;
  }
  Int3 to = past;
  for (std::size_t a = 0; a < 3; ++a) {
    to[a] = a == 2 && image.n[2] == 1 ? 1 : to[a];
    if (first[a] < 0 || first[a] >= to[a] || to[a] > image.n[a]) {
      throw InputError(
          fmt::format("{}: crop {}..{} along {} does not fit the image of {} x {} x {} voxels.",
                      name, first[a], to[a], "xyz"[a], image.n[0], image.n[1], image.n[2]));
    }
  }
  GreyVolume out{{to[0] - first[0], to[1] - first[1], to[2] - first[2]}, {}};
  out.grey.reserve(static_cast<std::size_t>(product(out.n)));
  for (int k = first[2]; k < to[2]; ++k) {
    for (int j = first[1]; j < to[1]; ++j) {
      const auto row = image.grey.begin() + voxel_index(image.n, first[0], j, k);
      out.grey.insert(out.grey.end(), row, row + out.n[0]);
    }
  }
  return out;
}

}  // namespace porefines::geom
