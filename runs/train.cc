// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>

#include "core/check.h"
#include "dataset/demonstration.h"
#include "dataset/inspect.h"
#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/supervised_model.h"
#include "learning/baselines/tracker_model.h"
#include "learning/exemplar/policy_model.h"
#include "runs/model_kinds.h"

namespace pacer {
namespace {

/// A dataset whose files are not as they were written teaches something else.
void require_whole(const std::filesystem::path& folder) {
  for (const dataset::Finding& finding :
       dataset::inspect(folder, dataset::Depth::kFiles).findings) {
    if (!finding.harms) continue;
    const std::string fault =
        fmt::format("{}: {}", (folder / finding.where).string(), finding.what);
    if (finding.lost) throw std::runtime_error(fault);
    throw std::runtime_error(
        fmt::format("{}; `pacer inspect {} --repair` keeps what is whole", fault, folder.string()));
  }
}

TrainingOptions options_of(const Scenario& scenario, const RunControl& control) {
  TrainingOptions options;
  options.jobs = control.jobs;
  options.scenario = to_yaml(scenario);
  options.stop = control.stop;
  options.progress = [&control](std::string_view stage, double share) {
    constexpr double kWhole = 100.0;
    control.progress(static_cast<std::uint64_t>(share * kWhole), 100, fmt::format("{}, %", stage));
  };
  return options;
}

/// A baseline, and how it is learnt: the bytes of its file.
struct Baseline {
  std::string method;
  std::string (*learn)(const Scenario& scenario, const std::filesystem::path& folder,
                       const TrainingOptions& options, baselines::TrainingReport& report);
};

template <baselines::PictureKind kKind>
std::string learn_ridge(const Scenario& /*scenario*/, const std::filesystem::path& folder,
                        const TrainingOptions& options, baselines::TrainingReport& report) {
  return baselines::to_bytes(
      baselines::train_ridge(dataset::RecordedDemonstration(folder), kKind, options, report));
}

std::string learn_nearest(const Scenario& /*scenario*/, const std::filesystem::path& folder,
                          const TrainingOptions& options, baselines::TrainingReport& report) {
  return baselines::to_bytes(
      baselines::train_nearest(dataset::RecordedDemonstration(folder), options, report));
}

std::string learn_supervised(const Scenario& scenario, const std::filesystem::path& folder,
                             const TrainingOptions& options, baselines::TrainingReport& report) {
  return baselines::to_bytes(baselines::train_supervised(
      dataset::MarkedRecording(folder), scenario.affordance.response.loss,
      chances_of_training(scenario), options, report));
}

std::string learn_tracker(const Scenario& scenario, const std::filesystem::path& folder,
                          const TrainingOptions& options, baselines::TrainingReport& report) {
  return baselines::to_bytes(
      baselines::train_tracker(dataset::MarkedRecording(folder), scenario.affordance.response.loss,
                               chances_of_training(scenario), options, report));
}

const std::vector<Baseline>& all_baselines() {
  static const std::vector<Baseline> all = {
      {.method = "supervised", .learn = learn_supervised},
      {.method = "nearest", .learn = learn_nearest},
      {.method = "ridge", .learn = learn_ridge<baselines::PictureKind::kGrey>},
      {.method = "ridge-hog", .learn = learn_ridge<baselines::PictureKind::kHog>},
      {.method = "tracker", .learn = learn_tracker}};
  return all;
}

/// The model in `file`, which is to learn from `more`. Throws UsageError where it cannot.
exemplar::Model growing(const std::filesystem::path& file, const Demonstration& more,
                        const std::filesystem::path& folder) {
  const LoadedModel loaded = load_model(file);
  const auto* found = dynamic_cast<const exemplar::ExemplarPolicyModel*>(loaded.model.get());
  if (found == nullptr) {
    throw UsageError(
        fmt::format("--onto {}: not an exemplar model, and only those grow", file.string()));
  }
  if (found->model()->fingerprint.find(more.fingerprint()) != std::string::npos) {
    throw UsageError(
        fmt::format("--onto {}: has learnt from {} already; collect another dataset, "
                    "with another seed",
                    file.string(), folder.string()));
  }
  return *found->model();
}

}  // namespace

Random chances_of_training(const Scenario& scenario) { return Random(scenario.seed).fork("train"); }

affordance::TrainingReport train_affordance(const Scenario& scenario,
                                            const std::filesystem::path& folder,
                                            const std::filesystem::path& file,
                                            const RunControl& control) {
  require_whole(folder);
  const affordance::Training training =
      affordance::train(dataset::RecordedDemonstration(folder), scenario.affordance,
                        chances_of_training(scenario), options_of(scenario, control));
  affordance::save(training.model, file);
  return training.report;
}

ExemplarTraining train_exemplar(const Scenario& scenario, const std::filesystem::path& folder,
                                const std::filesystem::path& onto,
                                const std::filesystem::path& file, const RunControl& control) {
  require_whole(folder);
  const dataset::RecordedDemonstration demonstration(folder);
  const TrainingOptions options = options_of(scenario, control);
  if (onto.empty()) {
    const exemplar::Training training = exemplar::train(demonstration, scenario.exemplar, options);
    exemplar::save(training.model, file);
    return {.report = training.report};
  }
  exemplar::Model model = growing(onto, demonstration, folder);
  const std::uint64_t before = model.hierarchy.exemplars().size();
  const exemplar::Training training = exemplar::grow(std::move(model), demonstration, options);
  exemplar::save(training.model, file);
  return {.report = training.report, .onto = before};
}

const std::vector<std::string>& baseline_methods() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all;
    for (const Baseline& baseline : all_baselines()) all.push_back(baseline.method);
    return all;
  }();
  return names;
}

baselines::TrainingReport train_baseline(const Scenario& scenario, const std::string& method,
                                         const std::filesystem::path& folder,
                                         const std::filesystem::path& file,
                                         const RunControl& control) {
  const auto& all = all_baselines();
  const auto baseline = std::ranges::find(all, method, &Baseline::method);
  check(baseline != all.end(), "train_baseline: one of baseline_methods()");
  require_whole(folder);
  const auto began = std::chrono::steady_clock::now();
  baselines::TrainingReport report;
  write_model_file(baseline->learn(scenario, folder, options_of(scenario, control), report), file);
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  return report;
}

}  // namespace pacer
