// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/demonstration.h"
#include "core/random.h"
#include "core/training.h"
#include "learning/affordance/config.h"

namespace pacer::affordance {

/// A demonstration in which each picture stands beside the command that answers it, which was sent
/// `lag` frames later (7.2.2). The last pictures of an episode, which nobody answered, are left
/// out.
class AnsweredDemonstration final : public Demonstration {
 public:
  /// `demonstration` must outlive it. `lag` is not negative.
  AnsweredDemonstration(const Demonstration& demonstration, int lag);

  [[nodiscard]] std::size_t episode_count() const override {
    return demonstration_.episode_count();
  }
  [[nodiscard]] double frame_rate_hz() const override { return demonstration_.frame_rate_hz(); }
  [[nodiscard]] ImageSize image_size() const override { return demonstration_.image_size(); }
  [[nodiscard]] std::string fingerprint() const override { return demonstration_.fingerprint(); }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override;

 private:
  const Demonstration& demonstration_;
  int lag_;
};

/// A lag between pictures and the commands that answer them, as found in a demonstration.
struct FoundLag {
  int frames = 0;
  /// By lag in frames, from 0 on: how much of the commands' variance the best multiple of what the
  /// pictures call for explains; the mean of steering and throttle, [0, 1].
  std::vector<double> explained;
  std::uint64_t pictures = 0;  ///< it was measured on; each with all lags
  int rounds = 0;              ///< of learning and measuring
  bool settled = false;        ///< whether the last round found the lag that it had learnt with
};

/// kLongestLag in whole frames.
[[nodiscard]] std::size_t longest_lag(double frame_rate_hz);

/// Finds how much later than the pictures the commands of `demonstration` come
/// (docs/design/lag.md), up to kLongestLag: learns a model from every other episode, lets it answer
/// the pictures of the rest, and takes the lag at which these answers explain most of the commands;
/// then learns with that lag and measures again, until it stays, four times at most.
///
/// The same demonstration, config and random: the same lag. Throws UsageError when there are fewer
/// than two episodes, or too little in them to learn from; and like train().
[[nodiscard]] FoundLag find_lag(const Demonstration& demonstration, const AffordanceConfig& config,
                                const Random& random, const TrainingOptions& options = {});

/// The lag to learn with: what the config gives, or what the demonstration shows.
struct SettledLag {
  int frames = 0;
  std::optional<FoundLag> found;  ///< where it was not given
  AffordanceConfig config;        ///< with the lag in seconds
};

/// Takes the lag from `config`, or finds it. Throws like find_lag(), and std::invalid_argument when
/// `config` is not valid.
[[nodiscard]] SettledLag settle_lag(const Demonstration& demonstration,
                                    const AffordanceConfig& config, const Random& random,
                                    const TrainingOptions& options);

}  // namespace pacer::affordance
