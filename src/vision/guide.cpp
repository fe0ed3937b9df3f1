// SPDX-License-Identifier: MPL-2.0
#include "vision/guide.hpp"

#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace porefines::vision {
namespace {

Step blend(const Step& a, const Step& b, Real t) {
  return {a.mean * (1 - t) + b.mean * t, a.xx * (1 - t) + b.xx * t, a.xy * (1 - t) + b.xy * t,
          a.yy * (1 - t) + b.yy * t};
}

/// Histogram of displacements over the square [-range, range]^2.
struct Displacements {
  Real range = 0;
  Real bin = 1;
  cv::Mat counts;   // [float]
  Real starts = 0;  // particles that pairs started from

  Displacements(Real reach, Real width)
      : range(reach),
        bin(width),
        counts(2 * static_cast<int>(std::ceil(reach / width)) + 1,
               2 * static_cast<int>(std::ceil(reach / width)) + 1, CV_32F, cv::Scalar(0)) {}

  void add(const cv::Point2d& d) {
    const int middle = counts.rows / 2;
    const auto i = middle + static_cast<int>(std::lround(d.x / bin));
    const auto j = middle + static_cast<int>(std::lround(d.y / bin));
    counts.at<float>(j, i) += 1;
  }
};

/// Bins that belong to the pile: connected to the highest and above a third of it.
cv::Mat pile_of(const cv::Mat& excess, const cv::Point& top) {
  constexpr Real share = 0.33;
  const cv::Mat high = excess > share * excess.at<float>(top);
  cv::Mat labels;
  cv::connectedComponents(high, labels, 8);
  return labels == labels.at<int>(top);
}

/// Mean and covariance of the pile; false when it does not stand out.
bool step_of(const Displacements& d, Real density, Step& out) {
  constexpr Real significance = 5;
  cv::Mat smooth;
  cv::GaussianBlur(d.counts, smooth, {}, 1.0, 1.0, cv::BORDER_CONSTANT);
  const Real chance = d.starts * density * d.bin * d.bin;
  const cv::Mat excess = smooth - chance;
  double highest = 0;
  cv::Point top;
  cv::minMaxLoc(excess, nullptr, &highest, nullptr, &top);
  constexpr Real blurred = 0.28;  // deviation of a count after the blur / before
  if (highest < significance * (blurred * std::sqrt(chance) + 0.4)) {
    return false;
  }
  const cv::Mat pile = pile_of(excess, top);
  const int middle = d.counts.rows / 2;
  Real sum = 0;
  Real x = 0;
  Real y = 0;
  Real xx = 0;
  Real xy = 0;
  Real yy = 0;
  for (int j = 0; j < pile.rows; ++j) {
    for (int i = 0; i < pile.cols; ++i) {
      if (pile.at<std::uint8_t>(j, i) != 0) {
        const Real w = excess.at<float>(j, i);
        const Real dx = d.bin * (i - middle);
        const Real dy = d.bin * (j - middle);
        sum += w;
        x += w * dx;
        y += w * dy;
        xx += w * dx * dx;
        xy += w * dx * dy;
        yy += w * dy * dy;
      }
    }
  }
  x /= sum;
  y /= sum;
  // The pile is cut at a third of its height: a Gaussian so cut has 0.56 of its variance in each
  // direction. A quarter of a pixel is what centres are known to.
  constexpr Real cut = 1 / 0.56;
  constexpr Real least = 0.0625;
  out = {{x, y},
         cut * (xx / sum - x * x) + least,
         cut * (xy / sum - x * y),
         cut * (yy / sum - y * y) + least};
  return true;
}

/// Calls visit(start, displacement) for every pair of consecutive frames within range.
template <typename Visit>
void for_pairs(std::span<const Spots> frames, const std::vector<bool>& breaks, Real range,
               const Visit& visit) {
  for (std::size_t f = 0; f + 1 < frames.size(); ++f) {
    if (f < breaks.size() && breaks[f]) {
      continue;
    }
    for (const Spot& a : frames[f]) {
      auto b = std::lower_bound(frames[f + 1].begin(), frames[f + 1].end(), a.y - range,
                                [](const Spot& s, Real y) { return s.y < y; });
      for (; b != frames[f + 1].end() && b->y < a.y + range; ++b) {
        if (std::abs(b->x - a.x) < range) {
          visit(cv::Point2d(a.x, a.y), cv::Point2d(b->x - a.x, b->y - a.y));
        }
      }
    }
  }
}

/// The histograms of a cell and its neighbours within `reach` cells.
Displacements gathered(const std::vector<Displacements>& local, const Guide& g, int i, int j,
                       int reach) {
  Displacements sum = local[static_cast<std::size_t>(j * g.nx + i)];
  sum.counts = cv::Mat::zeros(sum.counts.size(), CV_32F);
  sum.starts = 0;
  for (int b = std::max(j - reach, 0); b <= std::min(j + reach, g.ny - 1); ++b) {
    for (int a = std::max(i - reach, 0); a <= std::min(i + reach, g.nx - 1); ++a) {
      const Displacements& d = local[static_cast<std::size_t>(b * g.nx + a)];
      sum.counts += d.counts;
      sum.starts += d.starts;
    }
  }
  return sum;
}

/// Mean and covariance of steps, drawn to what was thought before as by `prior` further steps.
Step moments(const std::vector<cv::Point2d>& steps, const Step& before) {
  constexpr Real prior = 4;
  Real n = prior;
  cv::Point2d mean = prior * before.mean;
  for (const cv::Point2d& s : steps) {
    mean += s;
    n += 1;
  }
  mean = mean * (1 / n);
  Step out{mean, prior * before.xx, prior * before.xy, prior * before.yy};
  for (const cv::Point2d& s : steps) {
    const cv::Point2d d = s - mean;
    out.xx += d.x * d.x;
    out.xy += d.x * d.y;
    out.yy += d.y * d.y;
  }
  out.xx /= n;
  out.xy /= n;
  out.yy /= n;
  return out;
}

}  // namespace

Step expected(const Guide& g, const cv::Point2d& at) {
  const Real x = std::clamp(at.x / g.cell - 0.5, 0.0, g.nx - 1.0);
  const Real y = std::clamp(at.y / g.cell - 0.5, 0.0, g.ny - 1.0);
  const auto i = std::min(static_cast<int>(x), std::max(g.nx - 2, 0));
  const auto j = std::min(static_cast<int>(y), std::max(g.ny - 2, 0));
  const int right = std::min(i + 1, g.nx - 1);
  const int below = std::min(j + 1, g.ny - 1);
  const auto cell = [&](int column, int row) -> const Step& {
    return g.steps[static_cast<std::size_t>(row * g.nx + column)];
  };
  return blend(blend(cell(i, j), cell(right, j), x - i),
               blend(cell(i, below), cell(right, below), x - i), y - j);
}

cv::Point2d advect(const Guide& guide, cv::Point2d at, Real frames) {
  constexpr Real share = 0.7;  // of a cell a substep
  constexpr Real slowest = 1e-9;
  constexpr int most = 200;
  Real left = frames;
  for (int k = 0; k < most && left > 0; ++k) {
    const cv::Point2d first = expected(guide, at).mean;
    const Real h = std::min(
        left, std::max(share * guide.cell / std::max(std::hypot(first.x, first.y), slowest),
                       frames / most));
    const cv::Point2d second = expected(guide, at + h * first).mean;
    at += 0.5 * h * (first + second);
    left -= h;
  }
  return at;
}

Real spacing(std::span<const Spots> frames, cv::Size size) {
  Real count = 0;
  for (const Spots& spots : frames) {
    count += static_cast<Real>(spots.size());
  }
  const Real per_frame = std::max(count / std::max<Real>(1, static_cast<Real>(frames.size())), 1.0);
  return std::sqrt(size.area() / per_frame);
}

Guide mean_flow(std::span<const Spots> frames, const std::vector<bool>& breaks, cv::Size size,
                Real range) {
  const Real gap = spacing(frames, size);
  const Real bin = std::max(1.0, range / 24);
  Guide g;
  g.cell = std::max(24.0, 0.8 * gap);
  g.nx = std::max(1, static_cast<int>(std::ceil(size.width / g.cell)));
  g.ny = std::max(1, static_cast<int>(std::ceil(size.height / g.cell)));
  const auto cells = static_cast<std::size_t>(g.nx) * static_cast<std::size_t>(g.ny);
  std::vector<Displacements> local(cells, Displacements(range, bin));
  for (auto& d : local) {
    d.counts = d.counts.clone();  // cv::Mat copies share their values
  }
  Displacements whole(range, bin);
  const auto cell_of = [&](const cv::Point2d& at) {
    const int i = std::clamp(static_cast<int>(at.x / g.cell), 0, g.nx - 1);
    const int j = std::clamp(static_cast<int>(at.y / g.cell), 0, g.ny - 1);
    return static_cast<std::size_t>(j * g.nx + i);
  };
  for (std::size_t f = 0; f + 1 < frames.size(); ++f) {
    if (f >= breaks.size() || !breaks[f]) {
      for (const Spot& s : frames[f]) {
        // Chance pairs lie about their start evenly, so their middles are spread like the starts.
        local[cell_of({s.x, s.y})].starts += 1;
        whole.starts += 1;
      }
    }
  }
  for_pairs(frames, breaks, range, [&](const cv::Point2d& at, const cv::Point2d& d) {
    local[cell_of(at + 0.5 * d)].add(d);  // a step belongs to its middle, to second order
    whole.add(d);
  });
  const Real density = 1 / (gap * gap);
  const Real wide = range * range / 9;
  Step everywhere{{0, 0}, wide, 0, wide};
  (void)step_of(whole, density, everywhere);
  g.steps.assign(cells, everywhere);
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      Step& step = g.steps[static_cast<std::size_t>(j * g.nx + i)];
      constexpr int widest = 2;
      for (int reach = 0; reach <= widest; ++reach) {
        if (step_of(gathered(local, g, i, j, reach), density, step)) {
          break;
        }
      }
    }
  }
  return g;
}

Guide refined(const Guide& coarse, cv::Size size, Real cell, std::span<const SeenStep> seen) {
  Guide g = known_flow(size, cell, 0, [](const cv::Point2d&) { return cv::Point2d(); });
  std::vector<std::vector<cv::Point2d>> steps(g.steps.size());
  for (const SeenStep& s : seen) {
    const int i = std::clamp(static_cast<int>(s.middle.x / cell), 0, g.nx - 1);
    const int j = std::clamp(static_cast<int>(s.middle.y / cell), 0, g.ny - 1);
    steps[static_cast<std::size_t>(j * g.nx + i)].push_back(s.step);
  }
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const auto k = static_cast<std::size_t>(j * g.nx + i);
      g.steps[k] = moments(steps[k], expected(coarse, {(i + 0.5) * cell, (j + 0.5) * cell}));
    }
  }
  return g;
}

Guide known_flow(cv::Size size, Real cell, Real spread,
                 const std::function<cv::Point2d(const cv::Point2d&)>& step) {
  Guide g;
  g.cell = cell;
  g.nx = std::max(1, static_cast<int>(std::ceil(size.width / cell)));
  g.ny = std::max(1, static_cast<int>(std::ceil(size.height / cell)));
  for (int j = 0; j < g.ny; ++j) {
    for (int i = 0; i < g.nx; ++i) {
      const cv::Point2d mean = step({(i + 0.5) * cell, (j + 0.5) * cell});
      constexpr Real least = 1;
      const Real s2 = spread * spread;
      g.steps.push_back(
          {mean, s2 * mean.x * mean.x + least, s2 * mean.x * mean.y, s2 * mean.y * mean.y + least});
    }
  }
  return g;
}

}  // namespace porefines::vision
