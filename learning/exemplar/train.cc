// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/train.h"

#include <fmt/format.h>

#include <chrono>
#include <utility>
#include <vector>

#include "core/check.h"
#include "core/impulse.h"

namespace pacer::exemplar {
namespace {

using Clock = std::chrono::steady_clock;

Training finished(Model model, TrainingReport report, Clock::time_point began) {
  report.nodes = model.hierarchy.tree().nodes().size();
  report.depth = model.hierarchy.tree().depth();
  report.seconds = std::chrono::duration<double>(Clock::now() - began).count();
  return {.model = std::move(model), .report = report};
}

/// How the demonstrated actions changed from one impulse to the next.
Eigen::Matrix2d drift_of(const DemonstratedExemplars& demonstrated) {
  std::vector<std::vector<Action>> episodes;
  for (std::size_t n = 0, next = 0; n < demonstrated.exemplars.size(); ++n) {
    if (next < demonstrated.first.size() && demonstrated.first[next] == n) {
      episodes.emplace_back();
      ++next;
    }
    const std::span<const double> action = demonstrated.exemplars.action(n);
    episodes.back().emplace_back(action[0], action[1]);
  }
  return action_drift(episodes);
}

}  // namespace

DemonstratedExemplars exemplars_of(const Demonstration& demonstration, const PerceptConfig& config,
                                   const TrainingOptions& options) {
  TrainingReport report;
  std::vector<double> percepts;
  std::vector<double> actions;
  std::vector<std::size_t> first;
  BalloonFinder finder(of_videos(config));  // which is what demonstrations are recorded as
  report.episodes = demonstration.episode_count();
  for (std::size_t episode = 0; episode < report.episodes; ++episode) {
    if (options.stop.stop_requested()) throw TrainingStopped();
    ImpulseStream impulses(demonstration.open(episode));
    const std::uint64_t before = report.exemplars;
    while (const ImpulseExemplar* impulse = impulses.next()) {
      const Balloons& seen = finder.find(*impulse->frame);
      if (!finder.whole()) {
        ++report.disturbed;
        continue;
      }
      if (report.exemplars == before) first.push_back(report.exemplars);
      ++report.exemplars;
      report.red_seen += seen.red ? 1 : 0;
      report.green_seen += seen.green ? 1 : 0;
      const Percept values = percept(seen);
      percepts.insert(percepts.end(), values.begin(), values.end());
      actions.insert(actions.end(), {impulse->command.steering, impulse->command.throttle});
    }
    report.frames += impulses.frames();
    if (options.progress) {
      options.progress("exemplars",
                       static_cast<double>(episode + 1) / static_cast<double>(report.episodes));
    }
  }
  if (actions.empty()) {
    throw UsageError(
        "the dataset has no impulse (drive, then stand) to learn from; collect it with a scenario "
        "such as scenarios/balloon.yaml");
  }
  return {
      .exemplars = Exemplars(kPerceptSize, kActionSize, std::move(percepts), std::move(actions)),
      .first = std::move(first),
      .report = report};
}

Training train(const Demonstration& demonstration, const ExemplarConfig& config,
               const TrainingOptions& options) {
  const Clock::time_point began = Clock::now();
  config.validate();
  DemonstratedExemplars demonstrated = exemplars_of(demonstration, config.percept, options);
  const Eigen::Matrix2d drift = drift_of(demonstrated);
  const TrainingReport report = demonstrated.report;
  Model model{.config = config,
              .image_size = demonstration.image_size(),
              .scenario = options.scenario,
              .fingerprint = demonstration.fingerprint(),
              .drift = drift,
              .hierarchy = Hierarchy(std::move(demonstrated.exemplars), config.hierarchy)};
  return finished(std::move(model), report, began);
}

Training grow(Model model, const Demonstration& demonstration, const TrainingOptions& options) {
  const Clock::time_point began = Clock::now();
  const ImageSize size = demonstration.image_size();
  if (size != model.image_size) {
    throw UsageError(
        fmt::format("the dataset's pictures are {} x {}, and the model was learnt from {} x {}; "
                    "collect it with "
                    "the scenario that the model was learnt in",
                    size.width, size.height, model.image_size.width, model.image_size.height));
  }
  const DemonstratedExemplars more = exemplars_of(demonstration, model.config.percept, options);
  // Exemplars stand for changes of the action: the model does not know how many episodes it is of.
  if (more.exemplars.size() > more.first.size()) {
    const auto had = static_cast<double>(model.hierarchy.exemplars().size());
    const auto gained = static_cast<double>(more.exemplars.size());
    model.drift = (had * model.drift + gained * drift_of(more)) / (had + gained);
  }
  for (std::size_t n = 0; n < more.exemplars.size(); ++n) {
    model.hierarchy.learn(more.exemplars.percept(n), more.exemplars.action(n));
  }
  model.fingerprint += " " + demonstration.fingerprint();
  return finished(std::move(model), more.report, began);
}

}  // namespace pacer::exemplar
