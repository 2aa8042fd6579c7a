// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "studies/study.h"

namespace pacer {

/// The study called `name`; throws UsageError, listing the names, when there is none.
[[nodiscard]] const Study& find_study(const std::string& name);

/// Runs one study; its page goes to `context.out` where that is given. Returns what `--json`
/// writes (see to_json in study.h).
[[nodiscard]] nlohmann::ordered_json run_study(const Study& study, const StudyContext& context);

/// Runs every study on what `set_scenes` makes its context's scenarios, going on where an earlier
/// run into the same folder was interrupted, and draws one page of all claims, those that fall
/// short first, with the same as Markdown beside it.
[[nodiscard]] nlohmann::ordered_json run_all_studies(
    StudyContext context, const std::function<void(const Study&, StudyContext&)>& set_scenes);

/// A study's figures and claims as a few lines of text.
[[nodiscard]] std::string to_text(const nlohmann::ordered_json& result);

}  // namespace pacer
