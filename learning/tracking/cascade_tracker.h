// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "learning/tracking/appearance.h"
#include "learning/tracking/appearance_memory.h"
#include "learning/tracking/cascade_config.h"
#include "learning/tracking/correlation_filter.h"
#include "learning/tracking/gradient_features.h"
#include "learning/tracking/patch.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LP-CASCADE: predictors of several ranges in sequence. A correlation filter over the region
/// around the target finds it wherever it went; the affine predictor of the aspect that is seen
/// then proposes a better position, scale and rotation, and the filter,
/// which knows the background too, has to agree (docs/design/cascade.md).
class CascadeTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  CascadeTracker(const CascadeConfig& config, std::uint64_t seed);

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;

  /// `pose`, moved to where its box touches the image.
  [[nodiscard]] Similarity placed(const cv::Mat1b& image, Similarity pose) const;
  /// Pixels of a cell of the region, at scale 1.
  [[nodiscard]] double cell() const { return search_unit_ * GradientFeatures::kCell; }
  /// Features of the region around `pose`, transformed.
  void look_around(const cv::Mat1b& image, const Similarity& pose, FeatureMap& spectrum);
  /// The target itself at `pose`, in `aspect_patch_`.
  void look_at(const cv::Mat1b& image, const Similarity& pose);
  /// Where the filter finds the target in the region around `pose`, and how well.
  struct Sighting {
    Similarity pose;
    double answer = 0.0;  ///< of the filter
  };
  [[nodiscard]] Sighting locate(const cv::Mat1b& image, const Similarity& pose,
                                FeatureMap& spectrum);
  /// The same around the last pose, and beside that region where the answer is a doubtful one.
  [[nodiscard]] Sighting search(const cv::Mat1b& image);
  /// Is the filter's answer one that it gives on the target?
  [[nodiscard]] bool recognised(double answer) const;
  /// By how much the aspect's predictor, where that makes it more alike, would change the pose.
  [[nodiscard]] PoseChange refine();
  /// How far what the aspect says is to be believed, in [0, 1].
  [[nodiscard]] double trust() const;
  /// Is it enough of a change that the filter might like it better? Hardly any smaller one is
  /// liked better, and each costs a look.
  [[nodiscard]] bool worth_trying(const Similarity& proposed, const Similarity& found) const;
  /// From where the filter found the target to its pose, by predictors of shorter ranges.
  [[nodiscard]] Similarity choose(const cv::Mat1b& image, const Sighting& found);
  /// Moves `pose_` to where the target is, and leaves in `centred_` what the filter may learn: the
  /// region with the target in the middle. Returns the filter's answer where it was found.
  [[nodiscard]] double settle(const cv::Mat1b& image, const Sighting& sighted);
  /// Do both filter and aspect know the target in the region around `where`? `pose_` then is there,
  /// and the target no longer lost.
  [[nodiscard]] bool is_back(const cv::Mat1b& image, const Similarity& where);
  /// Looks for a lost target where it was, and in the next places of the picture.
  [[nodiscard]] bool look_elsewhere(const cv::Mat1b& image);
  /// Takes the picture into the filter's memory, and a new aspect into that of aspects, where the
  /// filter's answer says that it is the target's.
  void learn(const cv::Mat1b& image, double answer);
  /// How probable it is that the box is right, in (0, 1), or 0 when the target is lost.
  [[nodiscard]] double judge(double answer);

  CascadeConfig config_;
  const Random random_;  // copied at every start, so that starts repeat

  double width_ = 0.0, height_ = 0.0;  // of the first target, pixels
  double side_ = 0.0;                  // the root of its area
  double search_unit_ = 1.0;           // pixels from sample to sample of search_patch_
  double aspect_unit_ = 1.0;           // and of aspect_patch_
  Similarity pose_;                    // of the target; scale 1 is the first one's
  std::optional<CorrelationFilter> filter_;
  std::optional<AspectTrainer> trainer_;
  AppearanceMemory memory_;

  RegionPyramid pyramid_;
  Patch search_patch_;
  Patch aspect_patch_;
  GradientFeatures features_;
  FeatureMap spectrum_;  // of what is looked at on the way
  FeatureMap centred_;   // of the region around the target
  Eigen::VectorXf seen_;
  std::size_t matched_ = 0;    // aspect
  double first_answer_ = 1.0;  // of the filter
  double usual_ = 1.0;         // answer of the filter
  int doubtful_ = 0;           // pictures in a row
  bool lost_ = false;
  bool larger_ = false;    // which of the two it was last looked for as
  std::size_t place_ = 0;  // that is searched next
  float likeness_ = 1.0F;  // of what was seen with it, at its most in the last rounds
};

}  // namespace pacer::tracking
