// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>

#include "core/command.h"
#include "core/units.h"

namespace pacer {

/// What a driver does while it does not see its target (thesis, 6.7.1).
struct LossConfig {
  /// "stop": stands at once. "continue": goes on with the last action for `hold`, then stands.
  /// "search": the same, but turns towards the side where the target left for `search` before it
  /// stands. The thesis sets no time to either of the last two, and ends in walls.
  std::string strategy = "continue";
  Seconds hold{0.4};             ///< of the last action: a picture or a few that show nothing
  Seconds search{1.6};           ///< of full lock
  double search_throttle = 0.2;  ///< stick, [0, 1]; a car that stands cannot turn
  double stop_throttle = 0.0;    ///< stick, [-1, 0]; below 0 brakes

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("strategy", strategy);
    visit("hold_s", hold);
    visit("search_s", search);
    visit("search_throttle", search_throttle);
    visit("stop_throttle", stop_throttle);
  }
};

/// Answers in the place of a policy that has lost its target, by times alone: however often it is
/// asked, and with whatever pauses. One an episode.
class LossStrategy {
 public:
  enum class Phase : std::uint8_t { kHold, kSearch, kStop };

  /// Throws std::invalid_argument when `config` is not valid.
  explicit LossStrategy(const LossConfig& config);

  /// The target was seen in the frame taken at `time` and answered with `action`. `side` is where:
  /// pixels to the left of the picture's middle, or anything else that is positive there.
  void saw(Seconds time, const Command& action, double side) noexcept;

  /// What to do in the frame taken at `time`, which does not show it.
  [[nodiscard]] Command act(Seconds time) const noexcept;
  /// Why. A target that was never seen, or last right in the middle, is not searched for.
  [[nodiscard]] Phase phase(Seconds time) const noexcept;

 private:
  LossConfig config_;
  Command last_;  // answered when it was last seen
  Seconds seen_at_{};
  double side_ = 0.0;
  bool seen_ = false;  // whether it ever was
};

/// For labels: "lost: last action", "lost: search", "lost: stop".
[[nodiscard]] const char* label_of(LossStrategy::Phase phase) noexcept;

}  // namespace pacer
