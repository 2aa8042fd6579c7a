// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "learning/tracking/flock.h"
#include "learning/tracking/medoidshift.h"
#include "learning/tracking/target_template.h"
#include "learning/tracking/template_associations.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LP-MED: templates are clustered into aspects by medoidshift; predictors are weighted by how they
/// have done with the templates of the last one's aspect, and replaced by better ones learnt on the
/// way (4.3.3).
class LpMedTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  explicit LpMedTracker(std::uint64_t seed, const TrackingConfig& config = {});

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;
  void add_template(const cv::Mat1b& image);
  void replace_worst(const cv::Mat1b& image, const Eigen::Vector2d& origin,
                     const Eigen::Vector2d& moved);

  TrackingConfig config_;
  Random random_;
  std::optional<MemberTrainer> trainer_;
  std::vector<FlockMember> predictors_;               // L
  FlockMember candidate_;                             // learnt on the last picture
  std::optional<TemplateAssociations> associations_;  // A
  TemplateGrid grid_;
  std::vector<std::uint8_t> templates_;  // M, in the order of the clusters' points
  std::vector<double> distances_;        // from the newest to each
  std::optional<Medoidshift> clusters_;
  std::size_t newest_ = 0;  // of the templates
  Box box_;

  std::vector<Eigen::Vector2d> displacements_;  // of all predictors in the last picture
  std::vector<double> errors_, sums_, weights_;
  Eigen::Vector2d worst_;  // the offset of l*
};

}  // namespace pacer::tracking
