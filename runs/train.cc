// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>

#include <stdexcept>

#include "dataset/demonstration.h"
#include "dataset/inspect.h"

namespace pacer {
namespace {

/// A dataset whose files are not as they were written teaches something else.
void require_whole(const std::filesystem::path& folder) {
  for (const dataset::Finding& finding :
       dataset::inspect(folder, dataset::Depth::kFiles).findings) {
    if (!finding.harms) continue;
    throw std::runtime_error(fmt::format("{}: {}; `pacer inspect {} --repair` keeps what is whole",
                                         (folder / finding.where).string(), finding.what,
                                         folder.string()));
  }
}

}  // namespace

affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control) {
  require_whole(folder);
  const dataset::RecordedDemonstration demonstration(folder);
  affordance::TrainingOptions options;
  options.jobs = control.jobs;
  options.scenario = to_yaml(scenario);
  options.stop = control.stop;
  options.progress = [&](std::string_view stage, double share) {
    constexpr double kWhole = 100.0;
    control.progress(static_cast<std::uint64_t>(share * kWhole), 100, stage);
  };
  const affordance::Training training = affordance::train(
      demonstration, scenario.affordance, Random(scenario.seed).fork("train"), options);
  affordance::save(training.model, file);
  return training.report;
}

}  // namespace pacer
