// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/frame.h"
#include "learning/affordance/action_clusters.h"
#include "learning/affordance/apriori.h"
#include "learning/affordance/config.h"
#include "learning/affordance/mapping.h"
#include "learning/affordance/matcher.h"
#include "learning/affordance/vocabulary.h"
#include "learning/sealed_file.h"

namespace pacer::affordance {

/// What affordance mining learns: a few hundred configurations for each action type, and for each
/// how its features' poses become an action. Constant once made; policies on any number of threads
/// share one.
struct Model {
  AffordanceConfig config;
  ImageSize image_size;              ///< of the demonstration; frames of another size are refused
  double frame_rate_hz = 0.0;        ///< of the demonstration
  std::string scenario;              ///< that the demonstration was recorded in, as text
  std::string fingerprint;           ///< of the demonstration
  std::uint64_t frames_learnt = 0;   ///< pictures of it
  std::uint64_t frames_matched = 0;  ///< of them, with a match of at least one rule
  ActionClusters actions;
  Vocabulary vocabulary;
  std::vector<std::uint32_t> frequency;  ///< transactions that held each item
  std::vector<Rule> rules;               ///< by action type, then items
  std::vector<Mapping> mappings;         ///< one a rule
  double typical_witnesses = 0.0;        ///< rules that agree on a place, the median of its frames
  RuleMatcher matcher;                   ///< of `rules`; made anew on reading

  /// The number in the file that a change of its format or meaning raises.
  static constexpr std::uint32_t kVersion = 2;
  static constexpr SealedKind kFile{"PACERAFF", kVersion, "an affordance model"};
};

/// The file's bytes. The same model: the same bytes.
[[nodiscard]] std::string to_bytes(const Model& model);

/// Reads what to_bytes() wrote. `bytes` are not trusted. Throws std::runtime_error naming `source`:
/// not a model, another version, truncated, damaged, or senseless.
[[nodiscard]] Model from_bytes(std::string_view bytes, std::string_view source);

/// Writes aside and renames: `path` is never half a model. Throws std::system_error.
void save(const Model& model, const std::filesystem::path& path);

/// Throws std::runtime_error as from_bytes(), or std::system_error when `path` cannot be read.
[[nodiscard]] Model load(const std::filesystem::path& path);

}  // namespace pacer::affordance
