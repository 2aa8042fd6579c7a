// SPDX-License-Identifier: Apache-2.0
#include "runs/train.h"

#include <fmt/format.h>

#include <memory>
#include <stdexcept>
#include <string>

#include "core/check.h"
#include "dataset/demonstration.h"
#include "dataset/inspect.h"
#include "runs/model_file.h"

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

/// The model in `file`, which is to learn from `more`. Throws UsageError where it cannot.
exemplar::Model growing(const std::filesystem::path& file, const Demonstration& more,
                        const std::filesystem::path& folder) {
  const AnyModel model = load_model(file);
  const auto* found = std::get_if<std::shared_ptr<const exemplar::Model>>(&model);
  if (found == nullptr) {
    throw UsageError(
        fmt::format("--onto {}: not an exemplar model, and only those grow", file.string()));
  }
  if ((*found)->fingerprint.find(more.fingerprint()) != std::string::npos) {
    throw UsageError(
        fmt::format("--onto {}: has learnt from {} already; collect another dataset, "
                    "with another seed",
                    file.string(), folder.string()));
  }
  return **found;
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

}  // namespace pacer
