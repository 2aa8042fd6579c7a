// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <variant>

#include "learning/affordance/model.h"
#include "learning/exemplar/model.h"

namespace pacer {

/// A learnt model of either kind; shared by all policies that are made from it.
using AnyModel =
    std::variant<std::shared_ptr<const affordance::Model>, std::shared_ptr<const exemplar::Model>>;

/// Reads the model in `file`, of whichever kind its first bytes say. Throws std::runtime_error,
/// naming it, where it is neither or is damaged; std::system_error where it cannot be read.
[[nodiscard]] AnyModel load_model(const std::filesystem::path& file);

}  // namespace pacer
