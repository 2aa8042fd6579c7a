// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "learning/tracking/component_associations.h"
#include "learning/tracking/flock.h"
#include "learning/tracking/smat.h"
#include "learning/tracking/target_template.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LP-SMAT: each aspect of the target has predictors of its own, which are weighted by how they
/// have done there, and replaced by better ones learnt on the way (4.3.2).
class LpSmatTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  explicit LpSmatTracker(std::uint64_t seed, const TrackingConfig& config = {});

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;
  void replace_worst(const cv::Mat1b& image, const Eigen::Vector2d& moved);

  TrackingConfig config_;
  Random random_;
  std::optional<MemberTrainer> trainer_;
  std::vector<FlockMember> predictors_;                // L
  FlockMember candidate_;                              // learnt on the last picture
  std::optional<ComponentAssociations> associations_;  // A
  TemplateGrid grid_;
  std::vector<std::uint8_t> template_;  // G of the last picture
  std::optional<Smat> aspects_;
  std::size_t active_ = 0;     // m*
  std::size_t predicted_ = 0;  // the component whose members predicted last
  Box box_;

  // Of those members in the last picture.
  std::vector<Eigen::Vector2d> displacements_;
  std::vector<double> errors_, weights_;
  Eigen::Vector2d worst_;  // the offset of phi
};

}  // namespace pacer::tracking
