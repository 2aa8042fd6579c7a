// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/demonstration.h"
#include "core/training.h"
#include "learning/exemplar/model.h"

namespace pacer::exemplar {

/// What training did, for a person to judge the model by.
struct TrainingReport {
  std::uint64_t episodes = 0;
  std::uint64_t frames = 0;      ///< read
  std::uint64_t exemplars = 0;   ///< impulses, each with the picture before it
  std::uint64_t disturbed = 0;   ///< impulses left out: interference in that picture
  std::uint64_t red_seen = 0;    ///< exemplars with the red balloon in view
  std::uint64_t green_seen = 0;  ///< with the green one
  std::uint64_t nodes = 0;       ///< of the hierarchy
  int depth = 0;                 ///< of its deepest node; the root's is 0
  double seconds = 0.0;          ///< measured, so never the same twice
};

struct Training {
  Model model;
  TrainingReport report;
};

/// The impulses of a demonstration, as percepts and actions.
struct DemonstratedExemplars {
  Exemplars exemplars;
  std::vector<std::size_t> first;  ///< of each episode that has any, the number of its first one
  TrainingReport report;           ///< as far as reading goes
};

/// Reads every episode of a demonstration in impulses (core/impulse.h). Throws UsageError when
/// there is no impulse in it; std::invalid_argument when `config` is not valid; TrainingStopped;
/// and whatever the demonstration throws.
[[nodiscard]] DemonstratedExemplars exemplars_of(const Demonstration& demonstration,
                                                 const PerceptConfig& config,
                                                 const TrainingOptions& options = {});

/// Learns the percept-action hierarchy (5.2.1) from `demonstration`. The same demonstration and
/// config: the same model. Throws as exemplars_of().
[[nodiscard]] Training train(const Demonstration& demonstration, const ExemplarConfig& config,
                             const TrainingOptions& options = {});

/// `model` with the exemplars of another demonstration learnt online (Hierarchy::learn): a
/// teacher's corrections. Its settings stay; its drift becomes the mean of both, weighted by
/// exemplars; what reading the model from a file changes stands at to_bytes(). Throws as train();
/// UsageError where the pictures have another size.
[[nodiscard]] Training grow(Model model, const Demonstration& demonstration,
                            const TrainingOptions& options = {});

}  // namespace pacer::exemplar
