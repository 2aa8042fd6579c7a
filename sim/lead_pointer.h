// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/marking.h"
#include "sim/sight.h"

namespace pacer::sim {

/// Points at the lead once: a person's finger on the picture.
class LeadPointer final : public TargetPointer {
 public:
  /// `sight` must outlive it, and must tell of the very frame that the policy is shown.
  explicit LeadPointer(const LeadSight& sight) : sight_(sight) {}

  /// The box of what can be seen of the lead, in the first frame in which that is most of it.
  [[nodiscard]] std::optional<Box> point() override {
    if (pointed_ || !sight_.seen || sight_.visible < kMarkedFrom) return std::nullopt;
    const Eigen::Vector2d middle = 0.5 * (sight_.low + sight_.high);
    const Eigen::Vector2d extent = sight_.high - sight_.low;
    const Box box{.x = middle.x(), .y = middle.y(), .width = extent.x(), .height = extent.y()};
    if (!is_proper(box)) return std::nullopt;
    pointed_ = true;
    return box;
  }

 private:
  const LeadSight& sight_;
  bool pointed_ = false;
};

}  // namespace pacer::sim
