// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "core/drive.h"

namespace pacer {

struct FollowingResult;
struct KeepingResult;
struct ReachingResult;

/// How one episode went, by what it was to do. runs/score.h has what can be done with it.
using EpisodeScore = std::variant<FollowingResult, ReachingResult, KeepingResult>;

/// Scores an episode, and asks for its end as soon as its outcome is known.
class Scorer : public StepSink {
 public:
  /// The episode so far.
  [[nodiscard]] virtual EpisodeScore score() const = 0;
};

}  // namespace pacer
