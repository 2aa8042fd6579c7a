// SPDX-License-Identifier: Apache-2.0
#include "runs/collect.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/check.h"
#include "core/drive.h"
#include "dataset/recorder.h"
#include "dataset/writer.h"
#include "runs/pace.h"
#include "runs/policy_source.h"
#include "runs/score.h"
#include "runs/shared_counter.h"
#include "runs/worker_pool.h"
#include "sim/sim_car.h"

namespace pacer {
namespace {

dataset::DatasetSpec spec_of(const Scenario& scenario) {
  dataset::DatasetSpec spec;
  spec.image_size = scenario.simulated.camera.size();
  spec.rate_hz = static_cast<int>(scenario.simulated.camera.frame_rate_hz);
  spec.task = scenario.task;
  spec.signals = sim::privileged_columns(sim::subject_of(scenario.simulated.world));
  spec.scenario = to_yaml(scenario);
  return spec;
}

/// The largest this process has been, in MB.
double peak_mb() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// The teacher drives one episode, which is recorded aside.
std::string record_episode(const Scenario& scenario, Purpose purpose,
                           const dataset::DatasetSpec& spec, const std::filesystem::path& folder,
                           std::uint32_t episode, SharedCounter& counter) {
  const Random random = scenario.episode_random(purpose, episode);
  sim::SimCar car(scenario.simulated_for(purpose), random.fork("car"));
  const std::unique_ptr<Policy> teacher =
      make_teacher(scenario, car, random.fork("policy").fork("teacher"));
  Pace pace(scenario, *teacher);
  dataset::EpisodeRecorder recorder(folder, spec, episode, scenario.video);
  StepCounter steps(counter);
  std::vector<StepSink*> sinks = {&recorder, &steps};
  // A drive to somewhere is over when it is there; one that follows is as long as it is.
  std::unique_ptr<Scorer> scorer;
  if (scenario.what_for() == Goal::kReach) {
    scorer = make_scorer(scenario, car.signal_columns());
    sinks.push_back(scorer.get());
  }
  Sinks all(sinks);
  const std::uint64_t frames = drive(car, pace.driver(), scenario.limits, scenario.channels, all);
  recorder.finish();
  return nlohmann::json{{"frames", frames}, {"peak_mb", peak_mb()}}.dump();
}

}  // namespace

CollectReport collect(const Scenario& scenario, Purpose purpose, std::uint64_t episodes,
                      const std::filesystem::path& folder, const RunControl& control) {
  const auto start = std::chrono::steady_clock::now();
  if (scenario.car != "simulated") {
    throw UsageError("car: the teacher is recorded in simulation only; set car=simulated");
  }
  const dataset::DatasetSpec spec = spec_of(scenario);
  dataset::DatasetWriter writer(folder, spec);
  CollectReport report;
  report.resumed_from = static_cast<std::uint64_t>(writer.episodes());
  writer.commit_finished();

  std::vector<std::uint32_t> missing;
  for (auto i = static_cast<std::uint64_t>(writer.episodes()); i < episodes; ++i) {
    if (!writer.is_finished(static_cast<std::int64_t>(i))) {
      missing.push_back(static_cast<std::uint32_t>(i));
    }
  }
  const auto frames_each = static_cast<std::uint64_t>(scenario.simulated.duration.count() *
                                                      scenario.simulated.camera.frame_rate_hz);
  SharedCounter counter;
  std::uint64_t left = missing.size();
  std::uint64_t expected = frames_each * left;
  const auto tick = [&] {
    if (missing.empty()) return;  // all was recorded before
    const std::uint64_t recorded = counter.value();
    control.progress(recorded, std::max(expected, recorded + left), "frames recorded");
  };
  tick();
  run_in_workers(
      control.jobs, missing,
      [&](std::uint32_t episode) {
        return record_episode(scenario, purpose, spec, folder, episode, counter);
      },
      [&](std::uint32_t, const std::string& result) {
        const nlohmann::json value = nlohmann::json::parse(result);
        const auto frames = value["frames"].get<std::uint64_t>();
        report.frames += frames;
        --left;  // and those to come may end early as those before did
        expected = report.frames + left * (report.frames / (missing.size() - left));
        report.worker_peak_mb = std::max(report.worker_peak_mb, value["peak_mb"].get<double>());
        writer.commit_finished();
      },
      control.stop, tick);
  tick();
  writer.commit_finished();
  report.episodes = static_cast<std::uint64_t>(writer.episodes());
  report.whole = report.episodes >= episodes;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace pacer
