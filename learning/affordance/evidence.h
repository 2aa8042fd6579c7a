// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/units.h"
#include "learning/affordance/median.h"
#include "learning/affordance/perception.h"
#include "learning/affordance/response.h"
#include "learning/affordance/rule_matches.h"

namespace pacer::affordance {

/// Where the matches of one frame agree that the target is.
struct Consensus {
  float x = 0.0F, y = 0.0F;  ///< pixels, median of the centres of the configurations that matched
  float grid = 0.0F;         ///< pixels, median side of their grids
  int configurations = 0;    ///< that matched, distinct
  int witnesses = 0;         ///< different rules that matched within a grid's side of (x, y)
};

/// Finds it. Holds buffers: one a thread.
class ConsensusFinder {
 public:
  /// `votes` are ordered by centre, which index `x` and `y`, pixels. Without votes: all zeros.
  [[nodiscard]] Consensus find(std::span<const Vote> votes, std::span<const float> x,
                               std::span<const float> y);

 private:
  std::vector<Weighted> values_;
  std::vector<std::uint32_t> rules_;
};

/// Whether what matches is the target. A patch of background matches one rule or a few; the target
/// matches many different ones at one place, in frame after frame. So the evidence is the number
/// of witnesses, averaged over time; enough is a share of what is typical of the demonstration, but
/// never less than two that agree.
/// Who acts needs less of it to go on. No frame without a target is needed to learn it from.
class Evidence {
 public:
  /// `typical` is the demonstration's; see typical_witnesses().
  Evidence(const EvidenceConfig& config, double typical) noexcept
      : config_(config), typical_(typical) {}

  /// The frame taken at `time` has so many witnesses; whether that is enough to act on.
  bool add(Seconds time, int witnesses) noexcept;

  /// Witnesses, on average, that are enough now.
  [[nodiscard]] double least() const noexcept {
    if (config_.caution == 0.0) return 0.0;
    constexpr double kAgreement = 2.0;  // of rules: one alone agrees with none
    return std::max(kAgreement, config_.caution * typical_) * (enough_ ? config_.keep : 1.0);
  }
  [[nodiscard]] double value() const noexcept { return value_; }

 private:
  EvidenceConfig config_;
  double typical_;
  double value_ = 0.0;
  Seconds before_{};  // time of the frame before
  bool first_ = true;
  bool enough_ = false;
};

/// The median number of witnesses over the frames that `episodes` log; of rules that are `kept`.
[[nodiscard]] double typical_witnesses(std::span<const FeatureLog> episodes,
                                       std::span<const EpisodeMatches> matches,
                                       std::span<const char> kept, const GridConfig& grid);

}  // namespace pacer::affordance
