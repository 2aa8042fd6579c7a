// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

#include "core/frame.h"
#include "learning/exemplar/config.h"
#include "learning/exemplar/hierarchy.h"
#include "learning/sealed_file.h"

namespace pacer::exemplar {

/// What exemplar learning keeps: the exemplars, and the hierarchy over them. Constant once made;
/// policies on any number of threads share one.
struct Model {
  ExemplarConfig config;
  ImageSize image_size;     ///< of the demonstration; frames of another size are refused
  std::string scenario;     ///< that the demonstration was recorded in, as text
  std::string fingerprint;  ///< of the demonstration, and of those that it grew by
  Eigen::Matrix2d drift;    ///< action_drift() of the demonstrations
  Hierarchy hierarchy;      ///< by `config.hierarchy`

  /// The number in the file that a change of its format or meaning raises.
  static constexpr std::uint32_t kVersion = 1;
  static constexpr SealedKind kFile{"PACEREXE", kVersion, "an exemplar model"};
};

/// The file's bytes. The same model: the same bytes. The exemplars and the settings are kept, and
/// the hierarchy is built anew on reading. That gives the same one, unless it has learnt online
/// since it was built: then it is another, the one that training on all exemplars gives, with their
/// units and their prior where it had those of the first.
[[nodiscard]] std::string to_bytes(const Model& model);

/// Reads what to_bytes() wrote. `bytes` are not trusted. Throws std::runtime_error naming `source`:
/// not a model, another version, truncated, damaged, or senseless.
[[nodiscard]] Model from_bytes(std::string_view bytes, std::string_view source);

/// Writes aside and renames: `path` is never half a model. Throws std::runtime_error.
void save(const Model& model, const std::filesystem::path& path);

/// Throws std::runtime_error as from_bytes(), or std::system_error when `path` cannot be read.
[[nodiscard]] Model load(const std::filesystem::path& path);

}  // namespace pacer::exemplar
