// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include "dataset/demonstration.h"

namespace pacer {

affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control) {
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
