// SPDX-License-Identifier: Apache-2.0
#include "runs/evaluate.h"

#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <numeric>
#include <optional>

#include "core/check.h"
#include "core/drive.h"
#include "runs/film.h"
#include "runs/named_policy.h"
#include "runs/pace.h"
#include "runs/report/picture.h"
#include "runs/shared_counter.h"
#include "runs/timed_policy.h"
#include "runs/worker_pool.h"
#include "sim/sim_car.h"

namespace pacer {
namespace {

using nlohmann::json;

json to_json(const std::vector<Command>& commands) {
  json values = json::array();
  for (const Command& command : commands) {
    values.push_back(command.steering);
    values.push_back(command.throttle);
  }
  return values;
}

std::vector<Command> commands(const json& values) {
  std::vector<Command> commands;
  for (std::size_t i = 0; i + 1 < values.size(); i += 2) {
    commands.push_back({.steering = values[i], .throttle = values[i + 1]});
  }
  return commands;
}

json binary(const std::string& bytes) {
  return json::binary(std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
}

std::string bytes(const json& value) {
  const json::binary_t& binary = value.get_binary();
  return {binary.begin(), binary.end()};
}

/// What a worker sends home about one episode.
json to_json(const SignalTrace& trace) {
  json models = json::array();
  for (const SignalTrace::Model& model : trace.models) {
    models.push_back({{"name", model.name}, {"wanted", to_json(model.wanted)}});
  }
  return {{"time_s", trace.time_s}, {"teacher", to_json(trace.teacher)}, {"models", models}};
}

SignalTrace trace_from(const json& value) {
  SignalTrace trace;
  trace.time_s = value["time_s"].get<std::vector<double>>();
  trace.teacher = commands(value["teacher"]);
  for (const json& model : value["models"]) {
    trace.models.push_back({.name = model["name"], .wanted = commands(model["wanted"])});
  }
  return trace;
}

/// Drives one episode of one policy; everything that comes of it, as bytes.
std::string drive_episode(const Scenario& scenario, const std::vector<PolicySource>& sources,
                          const EvaluateOptions& options, std::size_t which, std::uint32_t episode,
                          SharedCounter& counter) {
  const PolicySource& source = sources[which];
  const Random random = scenario.episode_random(Purpose::kEvaluate, episode);
  const sim::SimCarConfig config = scenario.simulated_for(Purpose::kEvaluate);
  sim::SimCar car(config, random.fork("car"));
  const std::unique_ptr<Policy> policy = source.make(scenario, &car, random.fork("policy"));
  NamedPolicy named(source.name(), *policy);
  TimedPolicy timed(named);
  Pace pace(scenario, timed);
  const std::unique_ptr<Scorer> scorer = make_scorer(scenario, car.signal_columns());
  StepCounter steps(counter);
  std::vector<StepSink*> sinks = {scorer.get(), &steps};

  const TemporaryFile file(".mp4");
  std::optional<Film> film;
  if (episode < options.clips) {
    film.emplace(file.path(), static_cast<int>(config.camera.frame_rate_hz), options.clip_length,
                 source.name());
    sinks.push_back(&*film);
  }
  std::optional<Shadow> shadow;
  // Figure 6.15 is of models that answer every frame.
  if (source.name() == "teacher" && episode < options.traces &&
      scenario.what_for() != Goal::kReach) {
    shadow.emplace(sources, scenario, car, random.fork("shadow"));
    sinks.push_back(&*shadow);
  }

  Sinks all(sinks);
  drive(car, pace.driver(), scenario.limits, scenario.channels, all);

  json result = {{"score", to_json(scorer->score())}, {"response_ms", timed.milliseconds()}};
  if (film) {
    film->close();
    const std::vector<std::uint8_t> still = report::encode_jpeg(film->still());
    result["mp4"] = binary(file.bytes());
    result["jpg"] = binary(std::string(still.begin(), still.end()));
  }
  if (shadow) {
    result["trace"] = to_json(shadow->trace());
    result["pictures"] = json::array();
    for (const MatchGallery::Picture& picture : shadow->pictures()) {
      result["pictures"].push_back({{"action_type", picture.action_type},
                                    {"rules", picture.rules},
                                    {"jpg", binary(picture.jpg)}});
    }
  }
  const std::vector<std::uint8_t> packed = json::to_cbor(result);
  return {packed.begin(), packed.end()};
}

void take(const std::string& packed, const PolicySource& source, std::uint32_t episode,
          PolicyEvaluation& policy, EvaluationRun& run) {
  const json result = json::from_cbor(packed.begin(), packed.end());
  policy.episodes.push_back(score_from_json(run.evaluation.goal, result["score"]));
  const auto times = result["response_ms"].get<std::vector<float>>();
  policy.response_ms.insert(policy.response_ms.end(), times.begin(), times.end());
  if (result.contains("mp4")) {
    run.clips.push_back({.policy = source.name(),
                         .episode = episode,
                         .verdict = verdict(policy.episodes.back()),
                         .mp4 = bytes(result["mp4"]),
                         .jpg = bytes(result["jpg"])});
  }
  if (!result.contains("trace")) return;
  run.traces.push_back(trace_from(result["trace"]));
  if (!run.pictures.empty()) return;
  for (const json& picture : result["pictures"]) {
    run.pictures.push_back({.action_type = picture["action_type"],
                            .rules = picture["rules"],
                            .jpg = bytes(picture["jpg"])});
  }
}

}  // namespace

EvaluationRun evaluate(const Scenario& scenario, const std::vector<PolicySource>& policies,
                       const EvaluateOptions& options, const RunControl& control) {
  if (scenario.car != "simulated") {
    throw UsageError("car: policies are scored in simulation only; set car=simulated");
  }
  EvaluationRun run;
  run.evaluation.goal = scenario.what_for();
  for (const PolicySource& source : policies) {
    source.check_rate(scenario.simulated.camera.frame_rate_hz);
    run.evaluation.policies.push_back({.name = source.name(),
                                       .given_boxes = source.given_boxes(),
                                       .episodes = {},
                                       .response_ms = {}});
  }
  std::vector<std::uint32_t> indices(policies.size() * options.episodes);
  std::iota(indices.begin(), indices.end(), 0U);
  const auto policy_of = [&](std::uint32_t i) { return i / options.episodes; };
  const auto episode_of = [&](std::uint32_t i) { return i % options.episodes; };

  SharedCounter counter;
  std::uint64_t finished = 0;
  const auto tick = [&] { control.progress(finished, indices.size(), "episodes"); };
  tick();
  run.whole = run_in_workers(
      control.jobs, indices,
      [&](std::uint32_t i) {
        return drive_episode(scenario, policies, options, policy_of(i), episode_of(i), counter);
      },
      [&](std::uint32_t i, const std::string& packed) {
        take(packed, policies[policy_of(i)], episode_of(i), run.evaluation.policies[policy_of(i)],
             run);
        ++finished;
      },
      control.stop, tick);
  tick();
  return run;
}

}  // namespace pacer
