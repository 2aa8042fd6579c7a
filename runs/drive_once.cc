// SPDX-License-Identifier: Apache-2.0
#include "runs/drive_once.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "core/drive.h"
#include "dataset/replay_car.h"
#include "runs/film.h"
#include "runs/named_policy.h"
#include "runs/pace.h"
#include "sim/sim_car.h"

namespace pacer {
namespace {

/// Tells how far the episode is.
class DriveProgress final : public StepSink {
 public:
  DriveProgress(const RunControl& control, std::uint64_t total)
      : control_(control), total_(total) {}
  [[nodiscard]] bool write(const Frame&, const Step&) override {
    ++done_;
    control_.progress(done_, std::max(done_, total_), "frames driven");
    return true;
  }

 private:
  const RunControl& control_;
  std::uint64_t total_;
  std::uint64_t done_ = 0;
};

/// Scores on, but never asks for the end.
class Unhurried final : public StepSink {
 public:
  explicit Unhurried(StepSink& sink) : sink_(sink) {}
  [[nodiscard]] bool write(const Frame& frame, const Step& step) override {
    (void)sink_.write(frame, step);
    return true;
  }

 private:
  StepSink& sink_;
};

}  // namespace

DriveReport drive_once(const Scenario& scenario, const PolicySource& source,
                       const DriveOptions& options, const RunControl& control) {
  const Purpose purpose = options.demonstrated_rooms ? Purpose::kCollect : Purpose::kEvaluate;
  const Random random = scenario.episode_random(purpose, options.episode);
  const sim::SimCarConfig config = scenario.simulated_for(purpose);

  std::unique_ptr<Car> car;
  std::optional<dataset::Dataset> recorded;
  const sim::SimCar* simulated = nullptr;
  double rate_hz = config.camera.frame_rate_hz;
  auto expected = static_cast<std::uint64_t>(config.duration.count() * rate_hz);
  if (scenario.car == "replayed") {
    const auto episode = static_cast<std::size_t>(scenario.replayed.episode);
    recorded.emplace(scenario.replayed.dataset);
    car = std::make_unique<dataset::ReplayCar>(*recorded, episode);
    rate_hz = recorded->info().rate_hz;
    source.check_rate(rate_hz);
    expected = static_cast<std::uint64_t>(recorded->episodes().at(episode).length);
  } else {
    source.check_rate(rate_hz);
    auto made = std::make_unique<sim::SimCar>(config, random.fork("car"));
    simulated = made.get();
    car = std::move(made);
  }
  const std::unique_ptr<Policy> policy = source.make(scenario, simulated, random.fork("policy"));
  NamedPolicy named(source.name(), *policy);
  Pace pace(scenario, named);

  DriveProgress progress(control, expected);
  std::vector<StepSink*> sinks = {&progress};
  std::unique_ptr<Scorer> scorer;
  std::optional<Unhurried> unhurried;
  if (simulated != nullptr) {
    scorer = make_scorer(scenario, car->signal_columns());
    unhurried.emplace(*scorer);
    sinks.push_back(options.until_the_end ? static_cast<StepSink*>(&*unhurried) : scorer.get());
  }
  std::optional<Film> film;
  if (!options.video.empty()) {
    film.emplace(options.video, static_cast<int>(rate_hz), Seconds{3600.0}, source.name());
    sinks.push_back(&*film);
  }
  Sinks all(sinks);
  DriveReport report;
  report.frames = drive(*car, pace.driver(), scenario.limits, scenario.channels, all, control.stop);
  report.whole = !control.stop.stop_requested();
  if (film) film->close();
  if (scorer) report.score = scorer->score();
  return report;
}

}  // namespace pacer
