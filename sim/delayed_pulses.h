// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "core/check.h"
#include "core/command.h"

namespace pacer::sim {

/// Pulses on their way from the sender to the servos, counted in time steps. What arrives holds
/// until the next arrives. Before the first there is no pulse: both widths 0.
class DelayedPulses {
 public:
  explicit DelayedPulses(std::int64_t delay_steps) : delay_(delay_steps) {}

  /// Sent at time step `now`, which never falls. Pulses sent in the same step replace each other.
  void send(std::int64_t now, const Pulses& pulses) noexcept {
    if (count_ == 0 || newest().due != now + delay_) {
      check(count_ < kMost, "fewer pulses under way than DelayedPulses holds");
      ++count_;
    }
    newest() = {.due = now + delay_, .pulses = pulses};
  }

  /// What the servos see at time step `now`, which never falls.
  [[nodiscard]] const Pulses& arrived(std::int64_t now) noexcept {
    while (count_ > 0 && under_way_[first_].due <= now) {
      here_ = under_way_[first_].pulses;
      first_ = (first_ + 1) % kMost;
      --count_;
    }
    return here_;
  }

 private:
  struct Sent {
    std::int64_t due = 0;
    Pulses pulses;
  };
  static constexpr std::size_t kMost = 256;  // above any delay in steps

  [[nodiscard]] Sent& newest() noexcept { return under_way_[(first_ + count_ - 1) % kMost]; }

  std::int64_t delay_;
  std::array<Sent, kMost> under_way_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  Pulses here_;
};

}  // namespace pacer::sim
