// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "core/policy.h"
#include "core/random.h"
#include "sim/segmentation.h"

namespace pacer::sim {

/// How the scripted teacher clicks, and what becomes of a click.
struct ClickTeacherConfig {
  double scatter = 0.12;           ///< deviation of a click, of the balloon's width and height
  double hand = 2.5;               ///< pixels, deviation that comes on top
  double steering = 1.4;           ///< stick for a click at the picture's edge, cut at full lock
  double balloon_height = 0.3;     ///< metres, what it takes the balloon's height to be
  double near = 0.8;               ///< metres, and nearer: least drive
  double least = 0.3;              ///< stick
  double eagerness = 0.06;         ///< stick per metre beyond
  double most = 0.45;              ///< stick
  double throttle_scatter = 0.05;  ///< deviation of the drive, of itself
  std::string search = "left";     ///< side that it turns to as long as it has not seen it
  double search_steering = 0.92;   ///< stick, of turning until the balloon appears
  double search_scatter = 0.05;    ///< stick, deviation of that
  double search_throttle = 0.4;    ///< stick
  int patience = 30;               ///< impulses in a row without finding it; then it gives up
  int stuck = 4;  ///< impulses in a row that leave the picture as it was; then likewise

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("scatter", scatter);
    visit("hand_px", hand);
    visit("steering", steering);
    visit("balloon_height_m", balloon_height);
    visit("near_m", near);
    visit("least", least);
    visit("eagerness_per_m", eagerness);
    visit("most", most);
    visit("throttle_scatter", throttle_scatter);
    visit("search", search);
    visit("search_steering", search_steering);
    visit("search_scatter", search_scatter);
    visit("search_throttle", search_throttle);
    visit("patience", patience);
    visit("stuck", stuck);
  }
};

/// Points at the red balloon as a person before the picture would (thesis, 5.3.1): clicks on what
/// shows of it, and turns the car where nothing does. To be driven by impulses: each command is
/// one. Neutral, so asked again, while interference may cover the balloon, and from then on where
/// it gives up: when it has not found the balloon in more than a circle, or is stuck.
class ClickTeacher final : public Policy {
 public:
  /// `sights` must outlive it, and must tell of the very frame handed to act().
  ClickTeacher(const ClickTeacherConfig& config, const BalloonSights& sights, const Random& random);

  [[nodiscard]] Command act(const Observation& observation, Annotations& annotations) override;
  [[nodiscard]] Driver driver() const override { return Driver::kTeacher; }

 private:
  [[nodiscard]] Command click_on(const BalloonSight& balloon, ImageSize size,
                                 Annotations& annotations);
  [[nodiscard]] Command search(Annotations& annotations);
  [[nodiscard]] bool as_before(const BalloonSight& balloon) const;

  ClickTeacherConfig config_;
  const BalloonSights& sights_;
  Random random_;
  double side_;          // +1 left, -1 right: where the balloon is to be looked for
  BalloonSight before_;  // of the last impulse
  int searched_ = 0;     // impulses in a row
  int unmoved_ = 0;      // likewise
};

}  // namespace pacer::sim
