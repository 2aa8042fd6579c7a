// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "runs/report/page.h"
#include "runs/run_control.h"
#include "scenarios/scenario.h"

namespace pacer {

/// A figure held against what the thesis, or the project, claims of it.
struct Claim {
  std::string name;    ///< the figure's
  std::string thesis;  ///< what is claimed, in words
  std::string bound;   ///< e.g. ">= 0.75"
  double measured = 0.0;
  bool holds = false;
};

[[nodiscard]] Claim at_least(std::string name, std::string thesis, double measured, double bound);
[[nodiscard]] Claim above(std::string name, std::string thesis, double measured, double bound);
[[nodiscard]] Claim at_most(std::string name, std::string thesis, double measured, double bound);
[[nodiscard]] Claim below(std::string name, std::string thesis, double measured, double bound);
[[nodiscard]] Claim between(std::string name, std::string thesis, double measured, double low,
                            double high);

/// What a study measured.
struct StudyResult {
  nlohmann::ordered_json figures;
  std::vector<Claim> claims;
};

/// What a study may use.
struct StudyContext {
  Scenario scenario;
  std::optional<Scenario> also;  ///< where the study is of a second one
  RunControl control;
  std::filesystem::path cache;  ///< recordings, models and runs shared between studies
  std::filesystem::path out;    ///< where its page goes; empty: none
  std::optional<std::filesystem::path> transactions;  ///< a file to mine (`apriori`)
  std::optional<std::filesystem::path> images;     ///< pictures to try displacement estimators on
  std::optional<std::filesystem::path> sequences;  ///< with truth, to measure trackers on
};

/// A table or figure that is reproduced, or a comparison.
struct Study {
  std::string name;
  std::string about;     ///< one line
  std::string scenario;  ///< of scenarios/, that it is measured on
  /// Measures, and puts plots and tables on the page.
  StudyResult (*run)(const StudyContext& context, report::Page& page);
  std::string takes = {};  ///< which of a context's `transactions`, `images`, `sequences`, if any
  std::string also = {};   ///< a second of scenarios/ that it is measured on, if any
};

/// Every study, in the order in which `study all` runs them.
[[nodiscard]] const std::vector<Study>& studies();

/// {"study", "version", "seed", "machine", "seconds", "figures", "claims"}.
[[nodiscard]] nlohmann::ordered_json to_json(const Study& study, const StudyContext& context,
                                             const StudyResult& result, double seconds);

}  // namespace pacer
