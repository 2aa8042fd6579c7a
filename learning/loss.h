// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>

#include "core/check.h"
#include "core/command.h"
#include "core/units.h"

namespace pacer {

/// What a policy does where it sees nothing to act on (6.7.1).
struct LossConfig {
  std::string strategy = "continue";  ///< "stop" or "continue"
  Seconds hold{0.4};                  ///< how long "continue" holds the last action
  double stop_throttle = 0.0;         ///< stick, [-1, 0]; below 0 brakes

  /// Throws std::invalid_argument, naming the field.
  void validate() const {
    require(strategy == "stop" || strategy == "continue", "lost: must be 'stop' or 'continue'");
    require(hold.count() >= 0.0, "hold_s: must not be negative");
    require(stop_throttle >= -1.0 && stop_throttle <= 0.0, "stop_throttle: must lie in [-1, 0]");
  }
};

/// Remembers the last action that came from something seen, and answers when nothing is.
class Loss {
 public:
  explicit Loss(LossConfig config) : config_(std::move(config)) {}

  /// Something was seen at `time`, and answered with `action`.
  void saw(Seconds time, const Command& action) noexcept {
    action_ = action;
    seen_at_ = time;
    seen_ = true;
  }

  /// What to do at `time`, when nothing is seen; says so in `label`.
  [[nodiscard]] Command respond(Seconds time, std::string& label) const {
    const bool holding = seen_ && config_.strategy == "continue" && time - seen_at_ <= config_.hold;
    label = holding ? "lost: last action" : "lost: stop";
    return holding ? action_ : Command{.steering = 0.0, .throttle = config_.stop_throttle};
  }

 private:
  LossConfig config_;
  Command action_;
  Seconds seen_at_{};
  bool seen_ = false;
};

}  // namespace pacer
