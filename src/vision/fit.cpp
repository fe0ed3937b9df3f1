// SPDX-License-Identifier: MPL-2.0
#include "vision/fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "vision/gaussian.hpp"

namespace porefines::vision {
namespace {

/// A particle of the frame and its model.
struct Fitted {
  Gaussian model;
  bool sound = false;  ///< the model is a fit
  Real change = 1;     ///< of the model at its last fit, in heights
  std::vector<std::size_t> near;
};

class Frame {
 public:
  Frame(const cv::Mat& light, std::vector<Spot>& spots, int diameter)
      : light_(light), spots_(spots), radius_(diameter / 2 + 1) {
    // The image that was measured had been blurred by a pixel; see estimate.hpp for the diameter.
    const Real blurred = 0.28 * (diameter - 1);
    width_ = std::sqrt(std::max(blurred * blurred - 1, 0.25));
    for (const Spot& spot : spots) {
      all_.push_back({{spot.x, spot.y, spot.peak, width_, 0}, false, 1, {}});
    }
    find_neighbours(2.2 * radius_ + 1);
  }

  void fit_all() {
    constexpr int visits = 5;
    for (int visit = 0; visit < visits; ++visit) {
      for (std::size_t k = 0; k < all_.size(); ++k) {
        if (visit == 0 || neighbours_changed(k)) {
          fit_one(k);
        } else {
          all_[k].change = 0;
        }
      }
    }
    for (std::size_t k = 0; k < all_.size(); ++k) {
      const Gaussian& g = all_[k].model;
      if (all_[k].sound) {
        const Real mass = 2 * std::numbers::pi * g.height * g.width * g.width;
        spots_[k] = {g.x, g.y, mass, g.height};
      }
    }
  }

 private:
  void find_neighbours(Real reach) {
    for (std::size_t k = 0; k < spots_.size(); ++k) {
      for (std::size_t m = k + 1; m < spots_.size() && spots_[m].y - spots_[k].y < reach; ++m) {
        const Real dx = spots_[m].x - spots_[k].x;
        const Real dy = spots_[m].y - spots_[k].y;
        if (dx * dx + dy * dy < reach * reach) {
          all_[k].near.push_back(m);
          all_[m].near.push_back(k);
        }
      }
    }
  }

  /// By more than would move this one by a hundredth of a pixel.
  [[nodiscard]] bool neighbours_changed(std::size_t k) const {
    constexpr Real little = 5e-3;
    return std::any_of(all_[k].near.begin(), all_[k].near.end(),
                       [&](std::size_t m) { return all_[m].change > little; });
  }

  void fit_one(std::size_t k) {
    Fitted& mine = all_[k];
    mine.change = 0;
    constexpr int unknowns = 5;
    if (gather(k) < 2 * unknowns) {
      return;
    }
    if (!mine.sound) {
      mine.model.base = darkest();
    }
    const Gaussian g = fit_gaussian(patch_, mine.model, width_);
    const Spot& start = spots_[k];
    if (g.height > 0 && std::hypot(g.x - start.x, g.y - start.y) < 0.6 * radius_ + 0.5) {
      mine.change = mine.sound ? std::abs(g.height - mine.model.height) / g.height +
                                     std::hypot(g.x - mine.model.x, g.y - mine.model.y) / width_
                               : 1;
      mine.model = g;
      mine.sound = true;
    }
  }

  /// The disc around a particle without the light of its neighbours. @return its pixels
  int gather(std::size_t k) {
    const auto x = static_cast<int>(std::lround(spots_[k].x));
    const auto y = static_cast<int>(std::lround(spots_[k].y));
    patch_.x = std::max(x - radius_, 0);
    patch_.y = std::max(y - radius_, 0);
    patch_.columns = std::min(x + radius_ + 1, light_.cols) - patch_.x;
    patch_.left.clear();
    patch_.right.clear();
    patch_.light.clear();
    patch_.inside.clear();
    int pixels = 0;
    const auto stride = static_cast<std::size_t>(patch_.stride());
    for (int j = patch_.y; j <= std::min(y + radius_, light_.rows - 1); ++j) {
      const Real rest = static_cast<Real>(radius_ * (radius_ + 1) - (j - y) * (j - y));
      const auto half = static_cast<int>(std::sqrt(rest));
      patch_.left.push_back(std::max(x - half - patch_.x, 0));
      patch_.right.push_back(std::min(x + half + 1 - patch_.x, patch_.columns));
      pixels += patch_.right.back() - patch_.left.back();
      const auto* const line = light_.ptr<float>(j) + patch_.x;
      const std::size_t start = patch_.light.size();
      patch_.light.resize(start + stride, 0);
      patch_.inside.resize(start + stride, 0);
      std::fill_n(patch_.inside.begin() + static_cast<std::ptrdiff_t>(start) + patch_.left.back(),
                  patch_.right.back() - patch_.left.back(), 1);
      std::copy(line + patch_.left.back(), line + patch_.right.back(),
                patch_.light.begin() + static_cast<std::ptrdiff_t>(start) + patch_.left.back());
    }
    for (const std::size_t m : all_[k].near) {
      take_away(all_[m].model, patch_);
    }
    return pixels;
  }

  [[nodiscard]] Real darkest() const {
    Real least = patch_.light[static_cast<std::size_t>(patch_.left[0])];
    for (int j = 0; j < patch_.lines(); ++j) {
      const auto line = patch_.light.begin() + static_cast<std::ptrdiff_t>(j) * patch_.stride();
      const auto row = static_cast<std::size_t>(j);
      least = std::min(least, *std::min_element(line + patch_.left[row], line + patch_.right[row]));
    }
    return least;
  }

  const cv::Mat& light_;
  std::vector<Spot>& spots_;
  int radius_;
  Real width_ = 1;
  std::vector<Fitted> all_;
  Patch patch_;
};

}  // namespace

void fit_gaussians(const cv::Mat& light, std::vector<Spot>& spots, int diameter) {
  Frame(light, spots, diameter).fit_all();
}

}  // namespace porefines::vision
