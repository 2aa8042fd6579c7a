// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "learning/affordance/mapping.h"
#include "learning/affordance/matcher.h"
#include "learning/affordance/transactions.h"

namespace pacer::affordance {

/// Which rules matched where in one episode (6.6.1): flat, in the order of frames.
struct EpisodeMatches {
  std::vector<std::uint32_t> rules;       ///< one a match
  std::vector<std::uint32_t> frame_of;    ///< one a match
  std::vector<std::uint16_t> centres;     ///< one a match, of its configuration, within the frame
  std::vector<std::uint32_t> offsets{0};  ///< match m's features start here in `features`
  std::vector<std::uint16_t> features;    ///< within the frame, one an item of the rule

  /// How many frames have a match of a rule that is `kept`.
  [[nodiscard]] std::uint64_t frames(std::span<const char> kept) const;
};

[[nodiscard]] EpisodeMatches find_matches(const FeatureLog& episode, std::span<const Rule> rules,
                                          const RuleMatcher& matcher, const ItemLayout& layout,
                                          const GridConfig& grid);

/// Where each rule's matches are, through all episodes in order.
class MatchIndex {
 public:
  struct Where {
    std::uint32_t episode = 0;
    std::uint32_t match = 0;
  };
  MatchIndex(std::span<const EpisodeMatches> episodes, std::size_t rules);

  [[nodiscard]] std::size_t count(std::size_t rule) const noexcept {
    return first_[rule + 1] - first_[rule];
  }
  [[nodiscard]] std::span<const Where> of(std::size_t rule) const noexcept {
    return {where_.data() + first_[rule], count(rule)};
  }

 private:
  std::vector<std::size_t> first_;  // a rule, and one past the last
  std::vector<Where> where_;
};

/// A rule's training set: P and A of 6.6.1.
struct MappingExamples {
  std::vector<float> poses;  ///< matches x 4C
  std::vector<Command> actions;
  std::vector<std::uint64_t> stretches;  ///< which stretch of time of which episode; neighbours
};

[[nodiscard]] MappingExamples gather_examples(std::span<const FeatureLog> logs,
                                              std::span<const EpisodeMatches> matches,
                                              const MatchIndex& index, std::size_t rule);

}  // namespace pacer::affordance
