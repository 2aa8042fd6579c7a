// SPDX-License-Identifier: Apache-2.0
#include "runs/collect.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>
#include <vector>

#include "core/check.h"
#include "core/drive.h"
#include "dataset/recorder.h"
#include "dataset/writer.h"
#include "runs/shared_counter.h"
#include "runs/worker_pool.h"
#include "sim/sim_car.h"
#include "sim/teacher.h"

namespace pacer {
namespace {

dataset::DatasetSpec spec_of(const Scenario& scenario) {
  dataset::DatasetSpec spec;
  spec.image_size = scenario.simulated.camera.size();
  spec.rate_hz = static_cast<int>(scenario.simulated.camera.frame_rate_hz);
  spec.task = scenario.task;
  spec.signals = sim::privileged_columns();
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
  sim::Teacher teacher(scenario.teacher, car.lead_sight(), random.fork("policy").fork("teacher"));
  dataset::EpisodeRecorder recorder(folder, spec, episode, scenario.video);
  StepCounter steps(counter);
  Sinks sinks({&recorder, &steps});
  const std::uint64_t frames = drive(car, teacher, scenario.limits, scenario.channels, sinks);
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
  const auto tick = [&] {
    control.progress(counter.value(), frames_each * missing.size(), "frames recorded");
  };
  tick();
  run_in_workers(
      control.jobs, missing,
      [&](std::uint32_t episode) {
        return record_episode(scenario, purpose, spec, folder, episode, counter);
      },
      [&](std::uint32_t, const std::string& result) {
        const nlohmann::json value = nlohmann::json::parse(result);
        report.frames += value["frames"].get<std::uint64_t>();
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
