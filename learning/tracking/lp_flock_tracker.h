// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "learning/tracking/flock.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// LP-FLOCK: predictors learnt on the first picture, which move together (3.1.4).
class LpFlockTracker final : public Tracker {
 public:
  /// Throws std::invalid_argument for a config that makes no sense.
  explicit LpFlockTracker(std::uint64_t seed, const TrackingConfig& config = {});

  void annotate(Annotations& annotations) const override;

 private:
  void begin(const Picture& picture, const Box& target) override;
  [[nodiscard]] Track follow(const Picture& picture) override;

  TrackingConfig config_;
  Random random_;
  std::optional<Flock> flock_;
  Box box_;
};

}  // namespace pacer::tracking
