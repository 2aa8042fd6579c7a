// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "learning/tracking/lucas_kanade.h"
#include "learning/tracking/smat.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LK-SMAT: registers the median template of the aspect that the last picture matched (4.3.1).
class LkSmatTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  explicit LkSmatTracker(const TrackingConfig& config = {});

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;

  TrackingConfig config_;
  TemplateGrid grid_;
  std::vector<std::uint8_t> template_;  // G of the last picture
  std::optional<LucasKanade> registration_;
  std::optional<Smat> aspects_;
  int matched_ = 0;  // m*
  Box box_;
  Eigen::Vector2d offset_;  // of the box's centre from the templates'
};

}  // namespace pacer::tracking
