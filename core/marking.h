// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>

#include "core/box.h"
#include "core/demonstration.h"

namespace pacer {

/// How much a learner was told about the target besides frames and commands. Whoever was told
/// something says so in every report.
enum class GivenBoxes : std::uint8_t {
  kNone,
  kInTraining,  ///< its box in the demonstration's frames
  kAtTheStart,  ///< and its box in the first frame of each drive in which it is seen
};

/// A person marks the target where at least this share of it can be seen.
inline constexpr double kMarkedFrom = 0.5;

/// A demonstrated step in which somebody marked the target.
struct MarkedStep {
  DemonstratedStep step;
  std::optional<Box> target;  ///< in `step.frame`; nothing where it is out of sight
};

/// One marked episode, read from its first step to its last.
class MarkedStream {
 public:
  virtual ~MarkedStream() = default;

  /// As DemonstrationStream::next().
  [[nodiscard]] virtual const MarkedStep* next() = 0;
};

/// A demonstration whose frames somebody went through and marked the target in: for the baselines
/// that need it. Everybody else is handed a Demonstration, which has no boxes.
class MarkedDemonstration : public Demonstration {
 public:
  /// As open(), with boxes.
  [[nodiscard]] virtual std::unique_ptr<MarkedStream> open_marked(std::size_t episode) const = 0;
};

/// A finger on the picture: shows a policy its target, once an episode.
class TargetPointer {
 public:
  virtual ~TargetPointer() = default;

  /// The target's box in the frame that the policy is shown now, in the first such frame in which
  /// it is seen; nothing before that, and nothing ever after.
  [[nodiscard]] virtual std::optional<Box> point() = 0;
};

}  // namespace pacer
