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

TrainingOptions options_of(const Scenario& scenario, const RunControl& control) {
  TrainingOptions options;
  options.jobs = control.jobs;
  options.scenario = to_yaml(scenario);
  options.stop = control.stop;
  options.progress = [&control](std::string_view stage, double share) {
    constexpr double kWhole = 100.0;
    control.progress(static_cast<std::uint64_t>(share * kWhole), 100, stage);
  };
  return options;
}

}  // namespace

affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control) {
  require_whole(folder);
  const affordance::Training training =
      affordance::train(dataset::RecordedDemonstration(folder), scenario.affordance,
                        Random(scenario.seed).fork("train"), options_of(scenario, control));
  affordance::save(training.model, file);
  return training.report;
}

exemplar::TrainingReport train_exemplar(const Scenario& scenario,
                                        const std::filesystem::path& folder,
                                        const std::filesystem::path& onto,
                                        const std::filesystem::path& file,
                                        const RunControl& control) {
  require_whole(folder);
  const dataset::RecordedDemonstration demonstration(folder);
  const TrainingOptions options = options_of(scenario, control);
  const exemplar::Training training =
      onto.empty() ? exemplar::train(demonstration, scenario.exemplar, options)
                   : exemplar::grow(exemplar::load(onto), demonstration, options);
  exemplar::save(training.model, file);
  return training.report;
}

}  // namespace pacer
