// SPDX-License-Identifier: MPL-2.0
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "vision/guide.hpp"

namespace porefines::vision {

enum class LinkMethod { assignment, thesis };

struct LinkSettings {
  LinkMethod method = LinkMethod::assignment;
  Real range = 0;        ///< [pixels a frame] nothing moves farther
  int memory = 3;        ///< frames that a particle may be out of sight
  cv::Point2d flow;      ///< thesis: direction of the flow, y down; zero: none
  Real least_slope = 1;  ///< thesis: |across / along| of a step against the flow
  Real noise = 0.3;      ///< [pixels] standard deviation of a centre along one axis
};

/// What was learnt about the motion; see Linker.
struct Motion {
  Real persistence = 0.5;  ///< how much of its deviation from the guide a particle keeps
  Real deviation = 2;      ///< [pixels] of a step from its prediction, along one axis
  Real spread = 0;         ///< [pixels] of the steps of particles from the guide, along one axis
};

/// Gives the particles of each frame the numbers of those that they continue.
///
/// Assignment: every live track predicts where it is now,
///
///     prediction = x + guide's step + persistence * (last step - guide's step there)
///
/// (in a steady flow a particle that lags behind the mean goes on doing so: then the guide is
/// followed at its own pace), the squared deviations in units of their expected variance are the
/// costs, and one assignment for the whole frame has the least sum; a track may stay alone at the
/// cost of `gate` deviations and waits for `memory` frames. A new track does not know its pace yet:
/// its costs also ask whether the next frame continues the step (Malik et al. 1993).
/// Persistence and deviation follow the links made, so the range adapts itself.
///
/// Thesis: candidates within the range; a step against the flow needs a least slope; the least
/// displacement wins, each particle once.
/// Source: Crocker & Grier 1996; Ouellette, Xu & Bodenschatz, Exp. Fluids 40 (2006) 301.
/// Tests: vision/link.
class Linker {
 public:
  Linker(const LinkSettings& settings, const Guide& guide, const Motion& motion)
      : settings_(settings), guide_(guide), motion_(motion) {}

  /// @param spots  of the next frame
  /// @param after  of the frame after it; empty at the end
  /// @return       the track of every spot, numbered from 0 in the order of appearance
  [[nodiscard]] std::vector<Index> next(const Spots& spots, const Spots& after);

  /// Keeps the steps of tracks that were followed before.
  void record(std::vector<SeenStep>* steps) { record_ = steps; }

  [[nodiscard]] const Motion& motion() const { return motion_; }
  [[nodiscard]] Index tracks() const { return next_id_; }
  /// Minus the logarithm of how likely all of this was, per particle: what is least explains best.
  [[nodiscard]] Real surprise() const { return surprise_ / std::max<Real>(counted_, 1); }

 private:
  struct Live {
    Index id = 0;
    cv::Point2d at;
    cv::Point2d excess;  ///< last step a frame less the guide's, [pixels]
    Real pace = 1;       ///< along the guide
    int links = 0;
    int missed = 0;
  };
  struct Prediction {
    cv::Point2d at;
    Step about;  ///< covariance
  };

  [[nodiscard]] Prediction predict(const Live& track) const;
  [[nodiscard]] std::vector<int> assign_spots(const Spots& spots, const Spots& after) const;
  [[nodiscard]] std::vector<int> nearest_spots(const Spots& spots) const;
  [[nodiscard]] Real continuation(const Live& track, const cv::Point2d& to,
                                  const Spots& after) const;
  void follow(Live& track, const cv::Point2d& to);
  void learn(const Prediction& prediction, const Live& track, const cv::Point2d& to);

  LinkSettings settings_;
  const Guide& guide_;
  Motion motion_;
  Index next_id_ = 0;
  std::vector<Live> live_;
  Real sum_squares_ = 0;  ///< of deviations, forgetting
  Real sum_weights_ = 0;
  Real sum_kept_ = 0;  ///< excess times next excess, forgetting
  Real sum_excess_ = 0;
  Real surprise_ = 0;
  Real counted_ = 0;
  std::vector<SeenStep>* record_ = nullptr;
};

/// What linking starts with.
struct Learnt {
  Guide guide;
  Motion motion;
  Real surprise = 0;
};

/// Runs over some frames before it counts: with particles that follow the guide, that keep directions of
/// their own, and that keep nothing; goes on with what explains them best. A guide that comes from the
/// positions is made finer with the steps so found, as long as that explains more.
[[nodiscard]] Learnt learn_motion(const LinkSettings& settings, const Guide& guide,
                                  std::span<const Spots> frames, cv::Size size, bool refine);

}  // namespace porefines::vision
