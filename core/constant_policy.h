// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/policy.h"

namespace pacer {

/// Asks for the same command whatever it sees: what any learned policy has to beat. With the
/// demonstrations' mean it is the best guess of one who does not look.
class ConstantPolicy : public Policy {
 public:
  explicit ConstantPolicy(const Command& command) noexcept : command_(clamped(command)) {}
  [[nodiscard]] Command act(const Observation&, Annotations&) override { return command_; }

 private:
  Command command_;
};

/// Hands off the sticks.
class NeutralPolicy final : public ConstantPolicy {
 public:
  NeutralPolicy() noexcept : ConstantPolicy(Command{}) {}
};

}  // namespace pacer
