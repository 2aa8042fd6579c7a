// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/demonstration.h"
#include "core/random.h"
#include "core/training.h"
#include "learning/affordance/knowledge.h"
#include "learning/affordance/lag.h"
#include "learning/affordance/model.h"
#include "learning/affordance/transaction.h"

namespace pacer::affordance {

/// What training did, for a person to judge the model by.
struct TrainingReport {
  struct Type {
    std::string name;
    Command centre;
    std::uint64_t frames = 0;        ///< of this type, that are learnt from
    std::uint64_t transactions = 0;  ///< of this type
    double support_percent = 0.0;    ///< with which it was mined
    std::uint64_t mined = 0;         ///< rules
    std::uint64_t selected = 0;      ///< of them
    std::uint64_t kept = 0;          ///< of them, with matches enough for a mapping
    std::string capped;              ///< what limit cut the rules; empty when none did
  };
  Seconds lag{};                  ///< with which pictures were learnt with later commands
  std::optional<FoundLag> found;  ///< how it was found, where it was not given
  std::uint64_t episodes = 0;
  std::uint64_t frames = 0;          ///< read, that have an answer
  std::uint64_t frames_counted = 0;  ///< that differ from the ones before; see ChangeDetector
  std::uint64_t frames_learnt = 0;   ///< of those, learnt from: all, or an even thinning
  std::uint64_t features = 0;        ///< in those
  std::uint64_t word_samples = 0;    ///< features that the words were clustered from
  std::uint64_t transactions = 0;
  std::uint64_t items = 0;  ///< in all transactions
  std::uint64_t matches = 0;
  std::uint64_t frames_matched =
      0;                ///< of those learnt from, with at least one match of a kept rule
  Knowledge knowledge;  ///< of the model
  std::vector<Type> types;
  struct Stage {
    std::string name;
    double seconds = 0.0;
  };
  std::vector<Stage> stages;  ///< in order; measured, so never the same twice
};

struct Training {
  Model model;
  TrainingReport report;
};

/// No rule holds in the demonstration: it is too short, or too uniform.
struct NothingLearnt : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Learns a model from `demonstration` (chapter 6). Reads it twice, an episode a thread, and keeps
/// the command of every frame until they are clustered into action types, for which it takes about
/// 40 bytes a frame; and of the frames that count, at most `config.transactions.most_frames` of
/// them, the features as words. Where the lag is to be
/// found, that comes first and takes about twice as long again; the model's config has what was
/// found.
///
/// The same demonstration, config and random: the same model.
/// Throws UsageError when there is nothing to learn from: no frames, one action only, no features;
/// NothingLearnt; std::invalid_argument when `config` is not valid; TrainingStopped; and
/// whatever the demonstration throws.
[[nodiscard]] Training train(const Demonstration& demonstration, const AffordanceConfig& config,
                             const Random& random, const TrainingOptions& options = {});

/// The transactions that train() mines, and nothing more. Throws like it.
[[nodiscard]] TransactionDatabase transactions_of(const Demonstration& demonstration,
                                                  const AffordanceConfig& config,
                                                  const Random& random,
                                                  const TrainingOptions& options = {});

}  // namespace pacer::affordance
