// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "core/annotation.h"
#include "core/box.h"
#include "core/frame.h"
#include "core/loss.h"
#include "learning/baselines/box_action.h"

namespace pacer::baselines {

/// How a policy that is told where the target is drives: by one linear map while it is there, and
/// by what is done about a loss where it is not.
struct BoxDriving {
  BoxAction action;
  LossConfig when_lost;

  void write(ByteWriter& out) const;
  /// Throws std::runtime_error where it makes no sense.
  [[nodiscard]] static BoxDriving read(ByteReader& in);
};

/// That, through one episode.
class BoxResponse {
 public:
  explicit BoxResponse(const BoxDriving& driving)
      : action_(driving.action), loss_(driving.when_lost) {}

  /// What to do about `frame`, with the target in `box`. Marks it.
  [[nodiscard]] Command respond(const std::optional<Box>& box, const Frame& frame,
                                Annotations& annotations);

 private:
  BoxAction action_;
  LossStrategy loss_;
};

}  // namespace pacer::baselines
