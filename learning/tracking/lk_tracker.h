// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "learning/tracking/lucas_kanade.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LK: registers the first picture's template with every other.
class LkTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  explicit LkTracker(const TrackingConfig& config = {});

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;

  TrackingConfig config_;
  TemplateGrid grid_;
  std::vector<std::uint8_t> template_;
  std::optional<LucasKanade> registration_;
  Box box_;
  Eigen::Vector2d offset_;  // of the box's centre from the template's
};

}  // namespace pacer::tracking
