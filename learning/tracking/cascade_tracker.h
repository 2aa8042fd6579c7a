// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "learning/tracking/appearance.h"
#include "learning/tracking/appearance_memory.h"
#include "learning/tracking/correlation_filter.h"
#include "learning/tracking/gradient_features.h"
#include "learning/tracking/patch.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// The tracker beyond the thesis's. Lengths are in sides of the target, the root of its area; a
/// region is never smaller than 1.15 times the longest side.
struct CascadeConfig {
  double search_side = 4.0;  ///< of the region that the filter looks at
  double aspect_side = 1.8;  ///< of the region that aspects are observed in
  CorrelationFilterConfig filter;
  PosePredictorConfig predictor;
  AppearanceMemoryConfig memory;
  int rounds = 2;         ///< of the pose predictor in a frame
  double gain = 0.6;      ///< share of a change of scale or angle that is followed at once
  double unlike = 0.5;    ///< likeness at which an aspect's predictor counts for nothing
  double alike = 0.85;    ///< likeness from which on it counts in full
  double better = 1.03;   ///< by which the filter must answer more for an aspect's change to stand
  double rescale = 1.02;  ///< step of scale, up and down in turn, that is tried where it does not
  double rescale_better = 1.005;  ///< by which the filter must answer more for such a step
  double doubtful = 0.8;  ///< of its usual answer below which the filter looks beside its region
  double beside = 1.25;   ///< by which it must answer more there
  double rate = 0.013;    ///< share of a new picture in the filter's memory
  double habit = 0.1;     ///< share of a new answer of the filter in what it usually answers
  /// Confidence is min(1, likeness / familiar) / (1 + exp(-(bias + by_answer answer))), the
  /// filter's answer relative to the first: how often, over ten sequences, half of the box was
  /// right.
  double familiar = 0.6;
  double bias = -3.3;
  double by_answer = 8.9;
  double lost_below = 0.3;  ///< confidence below which it may be lost
  int patience = 15;        ///< pictures in a row below it after which it is
  int probes = 2;  ///< places of the picture, one after another, that are searched while lost
  double recognised = 0.5;  ///< of its usual answer that the filter gives on the target at least
  double new_aspect_below = 0.65;  ///< likeness below which a new aspect is learnt
  double new_aspect_above = 0.5;   ///< but not below this one: it may be something else

  /// Throws std::invalid_argument, naming section and field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("search_side", search_side);
    visit("aspect_side", aspect_side);
    visit("filter", filter);
    visit("predictor", predictor);
    visit("memory", memory);
    visit("rounds", rounds);
    visit("gain", gain);
    visit("unlike", unlike);
    visit("alike", alike);
    visit("better", better);
    visit("rescale", rescale);
    visit("rescale_better", rescale_better);
    visit("doubtful", doubtful);
    visit("beside", beside);
    visit("rate", rate);
    visit("habit", habit);
    visit("familiar", familiar);
    visit("bias", bias);
    visit("by_answer", by_answer);
    visit("lost_below", lost_below);
    visit("patience", patience);
    visit("probes", probes);
    visit("recognised", recognised);
    visit("new_aspect_below", new_aspect_below);
    visit("new_aspect_above", new_aspect_above);
  }
};

/// LP-CASCADE: predictors of several ranges in sequence. A correlation filter over the region
/// around the target finds it wherever it went; the affine predictor of the aspect that is seen
/// then proposes its position to a fraction of a pixel, its scale and its rotation, and the filter,
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
  /// `pose_` in pixels a sample of a patch whose samples are `unit` apart on the first target.
  [[nodiscard]] Similarity in_samples(const Similarity& pose, double unit) const;
  /// Features of the region around `pose`, transformed, in `spectrum_`.
  void look_around(const cv::Mat1b& image, const Similarity& pose);
  /// The target itself at `pose`, in `aspect_patch_`.
  void look_at(const cv::Mat1b& image, const Similarity& pose);
  /// Where the filter finds the target in the region around `pose`, and how well.
  struct Sighting {
    Similarity pose;
    double answer = 0.0;  ///< of the filter
  };
  [[nodiscard]] Sighting locate(const cv::Mat1b& image, const Similarity& pose);
  /// The same around the last pose, and beside that region where the answer is a doubtful one.
  [[nodiscard]] Sighting search(const cv::Mat1b& image);
  /// Is the filter's answer one that it gives on the target?
  [[nodiscard]] bool recognised(double answer) const;
  /// By how much the aspect's predictor, where that makes it more alike, would change the pose.
  [[nodiscard]] PoseChange refine();
  /// How far what the aspect says is to be believed, in [0, 1].
  [[nodiscard]] double trust() const;
  /// From where the filter found the target to its pose, by predictors of shorter ranges. Returns
  /// the filter's answer where it was found.
  [[nodiscard]] double settle(const cv::Mat1b& image, const Sighting& sighted);
  /// Do both filter and aspect know the target in the region around `where`? `pose_` then is there.
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
  FeatureMap spectrum_;
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
