// SPDX-License-Identifier: Apache-2.0
#include "core/loss.h"

#include "core/check.h"

namespace pacer {

void LossConfig::validate() const {
  require(strategy == "stop" || strategy == "continue" || strategy == "search",
          "strategy: must be 'stop', 'continue' or 'search'");
  require(hold.count() >= 0.0 && hold.count() <= 3600.0, "hold_s: must lie in [0, 3600]");
  require(search.count() >= 0.0 && search.count() <= 3600.0, "search_s: must lie in [0, 3600]");
  require(search_throttle >= 0.0 && search_throttle <= 1.0, "search_throttle: must lie in [0, 1]");
  require(stop_throttle >= -1.0 && stop_throttle <= 0.0, "stop_throttle: must lie in [-1, 0]");
}

LossStrategy::LossStrategy(const LossConfig& config) : config_(config) { config_.validate(); }

void LossStrategy::saw(Seconds time, const Command& action, double side) noexcept {
  last_ = clamped(action);
  seen_at_ = time;
  side_ = side;
  seen_ = true;
}

LossStrategy::Phase LossStrategy::phase(Seconds time) const noexcept {
  if (!seen_ || config_.strategy == "stop") return Phase::kStop;
  const Seconds gone = time - seen_at_;
  if (gone <= config_.hold) return Phase::kHold;
  const bool searches = config_.strategy == "search" && (side_ > 0.0 || side_ < 0.0);
  return searches && gone <= config_.hold + config_.search ? Phase::kSearch : Phase::kStop;
}

Command LossStrategy::act(Seconds time) const noexcept {
  switch (phase(time)) {
    case Phase::kHold:
      return last_;
    case Phase::kSearch:
      return {.steering = side_ > 0.0 ? 1.0 : -1.0, .throttle = config_.search_throttle};
    case Phase::kStop:
      break;
  }
  return {.steering = 0.0, .throttle = config_.stop_throttle};
}

const char* label_of(LossStrategy::Phase phase) noexcept {
  switch (phase) {
    case LossStrategy::Phase::kHold:
      return "lost: last action";
    case LossStrategy::Phase::kSearch:
      return "lost: search";
    case LossStrategy::Phase::kStop:
      break;
  }
  return "lost: stop";
}

}  // namespace pacer
