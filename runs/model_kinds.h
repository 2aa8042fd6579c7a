// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "core/policy_model.h"
#include "learning/sealed_file.h"

namespace pacer {

/// What is in a model.
struct ModelDescription;

/// A kind of model file. All that there are stand in one table, in model_kinds.cc: what a new kind
/// adds to the program is a line there.
struct ModelKind {
  SealedKind file;
  /// Reads one; `bytes` are not trusted. Throws as unsealed().
  std::shared_ptr<const PolicyModel> (*read)(std::string_view bytes, std::string_view source);
  /// Of what read() gave.
  ModelDescription (*describe)(const PolicyModel& model);
  /// The scenario that it was learnt in, as text. Of what read() gave, and valid while that is.
  const std::string& (*scenario)(const PolicyModel& model);
};

/// A model that was read, with the kind of file that it came from.
struct LoadedModel {
  const ModelKind* kind = nullptr;
  std::shared_ptr<const PolicyModel> model;
};

/// Reads a model of whichever kind its first bytes say. `bytes` are not trusted. Throws
/// std::runtime_error, naming `source`, where it is none or is damaged.
[[nodiscard]] LoadedModel read_model(std::string_view bytes, std::string_view source);

/// The same from a file; std::system_error where it cannot be read.
[[nodiscard]] LoadedModel load_model(const std::filesystem::path& file);

}  // namespace pacer
