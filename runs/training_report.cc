// SPDX-License-Identifier: Apache-2.0
#include "runs/training_report.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/counted.h"

namespace pacer {

std::string to_text(const affordance::TrainingReport& report) {
  const std::string thinned = report.frames_learnt < report.frames_counted
                                  ? fmt::format(", {} of these learnt from", report.frames_learnt)
                                  : "";
  std::string text =
      fmt::format("{}, {}, {} of them new{}; {} features; {} transactions of {:.1f} items\n",
                  counted(report.episodes, "episode"), counted(report.frames, "frame"),
                  report.frames_counted, thinned, report.features, report.transactions,
                  static_cast<double>(report.items) / static_cast<double>(report.transactions));
  if (report.found) {
    const std::vector<double>& explained = report.found->explained;
    text += fmt::format(
        "commands answer pictures {:.2f} s old: seen so, {:.0f} % of them is explained, and {:.0f} "
        "% without a lag{}\n",
        report.lag.count(), 100.0 * explained[static_cast<std::size_t>(report.found->frames)],
        100.0 * explained.front(),
        report.found->settled ? "" : "; it still moved in the last round, so check it");
  }
  for (const affordance::TrainingReport::Type& type : report.types) {
    text += fmt::format(
        "  {:<16} steering {:+.2f} throttle {:+.2f}: {} frames, {} rules mined, {} chosen, {} kept",
        type.name, type.centre.steering, type.centre.throttle, type.frames, type.mined,
        type.selected, type.kept);
    text += type.capped.empty() ? "\n" : fmt::format(" ({})\n", type.capped);
  }
  for (const affordance::TrainingReport::Type& type : report.types) {
    if (type.kept > 0) continue;
    text += fmt::format("note: nothing was learnt of {}; demonstrate more of it\n", type.name);
  }
  text += to_text(report.knowledge) + "\n";
  double seconds = 0.0;
  for (const affordance::TrainingReport::Stage& stage : report.stages) {
    text += fmt::format("  {:<16} {:6.1f} s\n", stage.name, stage.seconds);
    seconds += stage.seconds;
  }
  return text + fmt::format("learnt in {:.1f} s\n", seconds);
}

nlohmann::ordered_json to_json(const affordance::TrainingReport& report) {
  nlohmann::ordered_json types = nlohmann::ordered_json::array();
  for (const affordance::TrainingReport::Type& type : report.types) {
    types.push_back({{"name", type.name},
                     {"steering", type.centre.steering},
                     {"throttle", type.centre.throttle},
                     {"frames", type.frames},
                     {"transactions", type.transactions},
                     {"support_percent", type.support_percent},
                     {"mined", type.mined},
                     {"chosen", type.selected},
                     {"kept", type.kept},
                     {"capped", type.capped}});
  }
  nlohmann::ordered_json seconds = nlohmann::ordered_json::object();
  for (const affordance::TrainingReport::Stage& stage : report.stages) {
    seconds[stage.name] = stage.seconds;
  }
  nlohmann::ordered_json json = {{"lag_s", report.lag.count()}};
  if (report.found) {
    json["lag_explained"] = report.found->explained;
    json["lag_settled"] = report.found->settled;
  }
  json.update({{"episodes", report.episodes},
               {"frames", report.frames},
               {"frames_counted", report.frames_counted},
               {"frames_learnt", report.frames_learnt},
               {"features", report.features},
               {"transactions", report.transactions},
               {"items", report.items},
               {"matches", report.matches},
               {"frames_matched", report.frames_matched},
               {"knows_little", report.knowledge.little()},
               {"action_types", types},
               {"seconds", seconds}});
  return json;
}

std::string to_text(const ExemplarTraining& training) {
  const exemplar::TrainingReport& report = training.report;
  std::string text =
      fmt::format("{}, {}: {}, the red balloon in view in {}, the green one in {}\n",
                  counted(report.episodes, "episode"), counted(report.frames, "frame"),
                  counted(report.exemplars, "exemplar"), report.red_seen, report.green_seen);
  if (report.disturbed > 0) {
    text += fmt::format("{} left out, since interference covered the picture\n",
                        counted(report.disturbed, "impulse"));
  }
  if (training.onto > 0) {
    text += fmt::format("added {} to {}\n", counted(report.exemplars, "exemplar"), training.onto);
  }
  return text + fmt::format("a hierarchy of {}, {} deep; learnt in {:.1f} s\n",
                            counted(report.nodes, "node"), report.depth, report.seconds);
}

nlohmann::ordered_json to_json(const ExemplarTraining& training) {
  const exemplar::TrainingReport& report = training.report;
  return {{"episodes", report.episodes},     {"frames", report.frames},
          {"exemplars", report.exemplars},   {"onto", training.onto},
          {"disturbed", report.disturbed},   {"red_seen", report.red_seen},
          {"green_seen", report.green_seen}, {"nodes", report.nodes},
          {"depth", report.depth},           {"seconds", {{"whole", report.seconds}}}};
}

std::string to_text(const baselines::TrainingReport& report) {
  std::string text = fmt::format("{} episodes, {} frames\n", report.episodes, report.frames);
  if (report.marked > 0) {
    text +=
        fmt::format("given the target's box, by the simulation, in {} of them\n", report.marked);
  }
  if (!report.trials.empty()) {
    const baselines::Trial& chosen = report.trials.at(report.chosen);
    text += fmt::format(
        "chosen of {} settings on held-out episodes: {}; its error {:.3f} of the "
        "commands' variance\n",
        report.trials.size(), chosen.setting, chosen.error);
  }
  for (const baselines::TrainingReport::Fact& fact : report.facts) {
    text += fmt::format("  {:<16} {:.6g}\n", fact.name, fact.value);
  }
  return text + fmt::format("learnt in {:.1f} s\n", report.seconds);
}

nlohmann::ordered_json to_json(const baselines::TrainingReport& report) {
  nlohmann::ordered_json trials = nlohmann::ordered_json::array();
  for (const baselines::Trial& trial : report.trials) {
    trials.push_back({{"setting", trial.setting}, {"error", trial.error}});
  }
  nlohmann::ordered_json json = {
      {"episodes", report.episodes}, {"frames", report.frames}, {"marked", report.marked}};
  if (!report.trials.empty()) {
    json["chosen"] = report.trials.at(report.chosen).setting;
    json["trials"] = std::move(trials);
  }
  for (const baselines::TrainingReport::Fact& fact : report.facts) json[fact.name] = fact.value;
  json["seconds"] = {{"whole", report.seconds}};
  return json;
}

}  // namespace pacer
