// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/command.h"

namespace pacer::baselines {

/// What one thread finds of the demonstrated commands.
class Tally {
 public:
  void add(const Command& command) noexcept {
    ++frames_;
    for (const auto stick : {&Command::steering, &Command::throttle}) {
      sum_.*stick += command.*stick;
      least_.*stick = std::min(least_.*stick, command.*stick);
      most_.*stick = std::max(most_.*stick, command.*stick);
    }
  }
  void merge(const Tally& other) noexcept {
    frames_ += other.frames_;
    for (const auto stick : {&Command::steering, &Command::throttle}) {
      sum_.*stick += other.sum_.*stick;
      least_.*stick = std::min(least_.*stick, other.least_.*stick);
      most_.*stick = std::max(most_.*stick, other.most_.*stick);
    }
  }

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] Command mean() const noexcept;
  /// Throws UsageError where there is no frame, or one action only: no stick moved by kTremor.
  void require_something() const;

 private:
  std::uint64_t frames_ = 0;
  Command sum_;
  Command least_{.steering = 1.0, .throttle = 1.0};
  Command most_{.steering = -1.0, .throttle = -1.0};
};

}  // namespace pacer::baselines
