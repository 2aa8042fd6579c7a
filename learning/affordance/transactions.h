// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/command.h"
#include "core/frame.h"
#include "learning/affordance/configuration.h"
#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// The longest lag between picture and answer: what a person and a display take together.
inline constexpr Seconds kLongestLag{0.8};

/// Which frames, and how many of their configurations, become transactions (6.5.2).
struct TransactionConfig {
  int wanted = 150000;      ///< about so many transactions, of evenly thinned frames
  int most_frames = 30000;  ///< that are learnt from: of more, evenly thinned ones, so that
                            ///< memory hardly grows with the recording (40 bytes a frame)
  double common_item_percent = 12.0;  ///< of transactions: an item that more of them hold tells
                                      ///< nothing apart and swamps the search; it is left out
  double picture_change = 1.5;        ///< grey levels; see ChangeDetector
  double action_change = 0.05;        ///< of full stick; see ChangeDetector
  Seconds stretch{3.0};  ///< frames within one such stretch of an episode are one witness
  /// By how much a command comes later than the picture it answers (7.2.2): seconds, taken to the
  /// nearest whole frame, or "found", from the data. A picture is learnt with its answer.
  std::string lag = "0";

  /// The lag in seconds; nothing when it is to be found.
  [[nodiscard]] std::optional<Seconds> given_lag() const;
  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("wanted", wanted);
    visit("most_frames", most_frames);
    visit("common_item_percent", common_item_percent);
    visit("picture_change", picture_change);
    visit("action_change", action_change);
    visit("stretch_s", stretch);
    visit("lag_s", lag);
  }
};

/// Tells frames that say something new from copies: a standing car repeats one picture 25 times a
/// second, and at a few copies every subset of its items would look like a perfect rule.
///
/// The picture is averaged over kColumns x kRows blocks (mean of its three channels); it has
/// changed when the mean absolute difference of the blocks from those of the last frame that
/// counted exceeds `picture_change` grey levels. The action has changed when either stick moved
/// by more than `action_change` since then. A frame counts when either has; the first does.
class ChangeDetector {
 public:
  explicit ChangeDetector(const TransactionConfig& config) noexcept : config_(config) {}

  /// Whether `frame` and `command` count; if so, later ones are compared with them.
  [[nodiscard]] bool counts(const Frame& frame, const Command& command);

 private:
  static constexpr int kColumns = 20;
  static constexpr int kRows = 15;

  TransactionConfig config_;
  bool first_ = true;
  std::array<float, kColumns * kRows> blocks_{};
  Command command_;
};

/// Which of `count` things to take for an even thinning to `most` of them: exactly so many, the
/// first among them; all when there are fewer.
[[nodiscard]] constexpr bool taken(std::uint64_t index, std::uint64_t count, std::uint64_t most) {
  return count <= most || index == 0 || index * most / count != (index - 1) * most / count;
}

/// What training keeps of one episode: the features of the frames it learns from, as words.
struct FeatureLog {
  std::vector<std::uint32_t> offsets = {0};  ///< frame f has features offsets[f] .. offsets[f + 1]
  Poses poses;
  Words words;
  std::vector<Command> commands;         ///< one a frame
  std::vector<ActionType> types;         ///< one a frame
  std::vector<std::uint32_t> stretches;  ///< one a frame, from 0 in each episode

  [[nodiscard]] std::size_t frame_count() const noexcept { return commands.size(); }
  [[nodiscard]] LabelledFeatures frame(std::size_t f) const {
    return {poses, words, offsets[f], offsets[f + 1] - offsets[f]};
  }
  void add(const Features& features, const Words& labels, const Command& command, ActionType type,
           std::uint32_t stretch);
};

/// The transactions of evenly thinned frames of `episodes`, about `config.wanted` of them, in the
/// order of the recording, without the items that are too common. Configurations of a single
/// neighbour or none are left out: no rule could be drawn from them. Stretches are numbered through
/// all episodes.
[[nodiscard]] TransactionDatabase build_transactions(std::span<const FeatureLog> episodes,
                                                     const ItemLayout& layout,
                                                     const GridConfig& grid,
                                                     const TransactionConfig& config,
                                                     int type_count);

}  // namespace pacer::affordance
