// SPDX-License-Identifier: MPL-2.0
#include "vision/fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace porefines::vision {
namespace {

constexpr int unknowns = 5;  // x0, y0, a, s, b
using Vector = std::array<Real, unknowns>;
using Matrix = std::array<Vector, unknowns>;

struct Gaussian {
  Real x = 0;
  Real y = 0;
  Real height = 0;
  Real width = 1;
  Real base = 0;
  bool converged = false;

  [[nodiscard]] Real at(Real i, Real j) const {
    const Real r2 = (i - x) * (i - x) + (j - y) * (j - y);
    return height * std::exp(-0.5 * r2 / (width * width));
  }
};

/// A pixel of the disc with the light that is left for this particle.
struct Sample {
  Real i;
  Real j;
  Real light;
};

/// Gaussian elimination of a positive definite system; false when it is not one.
bool solve(Matrix a, Vector b, Vector& x) {
  for (std::size_t k = 0; k < unknowns; ++k) {
    if (!(a[k][k] > 0)) {
      return false;
    }
    for (std::size_t r = k + 1; r < unknowns; ++r) {
      const Real factor = a[r][k] / a[k][k];
      for (std::size_t c = k; c < unknowns; ++c) {
        a[r][c] -= factor * a[k][c];
      }
      b[r] -= factor * b[k];
    }
  }
  for (std::size_t k = unknowns; k-- > 0;) {
    Real sum = b[k];
    for (std::size_t c = k + 1; c < unknowns; ++c) {
      sum -= a[k][c] * x[c];
    }
    x[k] = sum / a[k][k];
  }
  return true;
}

/// Normal equations of one step; @return the sum of squares before it.
Real equations(const std::vector<Sample>& samples, const Gaussian& g, Matrix& a, Vector& b) {
  a = {};
  b = {};
  Real squares = 0;
  const Real w2 = g.width * g.width;
  for (const Sample& sample : samples) {
    const Real dx = sample.i - g.x;
    const Real dy = sample.j - g.y;
    const Real r2 = dx * dx + dy * dy;
    const Real shape = std::exp(-0.5 * r2 / w2);
    const Real model = g.height * shape;
    const Real rest = sample.light - model - g.base;
    const Vector slope{model * dx / w2, model * dy / w2, shape, model * r2 / (w2 * g.width), 1};
    squares += rest * rest;
    for (std::size_t r = 0; r < unknowns; ++r) {
      for (std::size_t c = 0; c <= r; ++c) {
        a[r][c] += slope[r] * slope[c];
      }
      b[r] += slope[r] * rest;
    }
  }
  for (std::size_t r = 0; r < unknowns; ++r) {
    for (std::size_t c = r + 1; c < unknowns; ++c) {
      a[r][c] = a[c][r];
    }
  }
  return squares;
}

Real squares_of(const std::vector<Sample>& samples, const Gaussian& g) {
  Real squares = 0;
  for (const Sample& sample : samples) {
    const Real rest = sample.light - g.at(sample.i, sample.j) - g.base;
    squares += rest * rest;
  }
  return squares;
}

/// Levenberg-Marquardt with the width within a factor of two of what is usual.
Gaussian fit(const std::vector<Sample>& samples, Gaussian g, Real usual_width) {
  constexpr int most_steps = 8;
  constexpr Real at_rest = 2e-3;  // [pixels]
  Real damping = 1e-3;
  Matrix a{};
  Vector b{};
  for (int step = 0; step < most_steps; ++step) {
    const Real before = equations(samples, g, a, b);
    for (std::size_t k = 0; k < unknowns; ++k) {
      a[k][k] *= 1 + damping;
    }
    Vector change{};
    if (!solve(a, b, change)) {
      break;
    }
    Gaussian next = g;
    next.x += change[0];
    next.y += change[1];
    next.height += change[2];
    next.width = std::clamp(g.width + change[3], 0.5 * usual_width, 2 * usual_width);
    next.base += change[4];
    if (squares_of(samples, next) <= before) {
      g = next;
      damping *= 0.1;
      if (std::hypot(change[0], change[1]) < at_rest) {
        break;
      }
    } else {
      damping *= 10;
    }
  }
  return g;
}

class Frame {
 public:
  Frame(const cv::Mat& light, std::vector<Spot>& spots, int diameter)
      : light_(light), spots_(spots), radius_(diameter / 2 + 1) {
    // The image that was measured had been blurred by a pixel; see estimate.hpp for the diameter.
    const Real blurred = 0.28 * (diameter - 1);
    width_ = std::sqrt(std::max(blurred * blurred - 1, 0.25));
    for (const Spot& spot : spots) {
      models_.push_back({spot.x, spot.y, spot.peak, width_, 0, false});
    }
    find_neighbours(2.2 * radius_ + 1);
  }

  void fit_all() {
    constexpr int visits = 5;
    for (int visit = 0; visit < visits; ++visit) {
      for (std::size_t k = 0; k < spots_.size(); ++k) {
        if (visit == 0 || !near_[k].empty()) {
          fit_one(k);
        }
      }
    }
    for (std::size_t k = 0; k < spots_.size(); ++k) {
      const Gaussian& g = models_[k];
      if (g.converged) {
        const Real mass = 2 * std::numbers::pi * g.height * g.width * g.width;
        spots_[k] = {g.x, g.y, mass, g.height};
      }
    }
  }

 private:
  void find_neighbours(Real reach) {
    near_.resize(spots_.size());
    for (std::size_t k = 0; k < spots_.size(); ++k) {
      for (std::size_t m = k + 1; m < spots_.size() && spots_[m].y - spots_[k].y < reach; ++m) {
        if (std::hypot(spots_[m].x - spots_[k].x, spots_[m].y - spots_[k].y) < reach) {
          near_[k].push_back(m);
          near_[m].push_back(k);
        }
      }
    }
  }

  void fit_one(std::size_t k) {
    gather(k);
    const Spot& start = spots_[k];
    if (samples_.size() < 2 * unknowns) {
      return;
    }
    if (!models_[k].converged) {
      models_[k].base =
          std::min_element(samples_.begin(), samples_.end(), [](const Sample& p, const Sample& q) {
            return p.light < q.light;
          })->light;
    }
    const Gaussian g = fit(samples_, models_[k], width_);
    const bool sound =
        g.height > 0 && std::hypot(g.x - start.x, g.y - start.y) < 0.6 * radius_ + 0.5;
    if (sound) {
      models_[k] = g;
      models_[k].converged = true;
    }
  }

  void gather(std::size_t k) {
    samples_.clear();
    const auto x = static_cast<int>(std::lround(spots_[k].x));
    const auto y = static_cast<int>(std::lround(spots_[k].y));
    for (int j = std::max(y - radius_, 0); j <= std::min(y + radius_, light_.rows - 1); ++j) {
      const auto* const line = light_.ptr<float>(j);
      for (int i = std::max(x - radius_, 0); i <= std::min(x + radius_, light_.cols - 1); ++i) {
        if ((i - x) * (i - x) + (j - y) * (j - y) <= radius_ * (radius_ + 1)) {
          Real rest = line[i];
          for (const std::size_t m : near_[k]) {
            rest -= models_[m].at(i, j);
          }
          samples_.push_back({static_cast<Real>(i), static_cast<Real>(j), rest});
        }
      }
    }
  }

  const cv::Mat& light_;
  std::vector<Spot>& spots_;
  int radius_;
  Real width_ = 1;
  std::vector<Gaussian> models_;
  std::vector<std::vector<std::size_t>> near_;
  std::vector<Sample> samples_;
};

}  // namespace

void fit_gaussians(const cv::Mat& light, std::vector<Spot>& spots, int diameter) {
  Frame(light, spots, diameter).fit_all();
}

}  // namespace porefines::vision
