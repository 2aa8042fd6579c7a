// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "core/command.h"

namespace pacer::baselines {

/// What one thread finds of the demonstrated commands.
class Tally {
 public:
  void add(const Command& command) noexcept {
    if (frames_ == 0) first_ = command;
    varied_ = varied_ || command != first_;
    ++frames_;
    sum_.steering += command.steering;
    sum_.throttle += command.throttle;
  }
  void merge(const Tally& other) noexcept {
    if (other.frames_ == 0) return;
    if (frames_ == 0) first_ = other.first_;
    varied_ = varied_ || other.varied_ || other.first_ != first_;
    frames_ += other.frames_;
    sum_.steering += other.sum_.steering;
    sum_.throttle += other.sum_.throttle;
  }

  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  [[nodiscard]] Command mean() const noexcept;
  /// Throws UsageError where there is no frame, or one command only.
  void require_something() const;

 private:
  std::uint64_t frames_ = 0;
  Command sum_;
  Command first_;
  bool varied_ = false;
};

}  // namespace pacer::baselines
