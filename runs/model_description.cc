// SPDX-License-Identifier: Apache-2.0
#include "runs/model_description.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <utility>

#include "core/counted.h"
#include "learning/affordance/knowledge.h"

namespace pacer {
namespace {

/// What every baseline's file says first.
std::string head(const std::string& what, const baselines::Origin& origin) {
  return fmt::format("{}, for {} x {}\nlearnt from {}\n", what, origin.image_size.width,
                     origin.image_size.height, origin.fingerprint);
}

/// How a policy with boxes turns them into commands.
std::string driving_text(const baselines::BoxDriving& driving) {
  std::string text;
  for (const auto& [name, row] : {std::pair("steering", 0), {"throttle", 1}}) {
    const auto map = driving.action.map.row(row);
    text += fmt::format("{} = {:+.5f} x {:+.5f} y {:+.5f} height {:+.5f} width {:+.3f}\n", name,
                        map[0], map[1], map[2], map[3], map[4]);
  }
  return text + fmt::format("lost: {}, holds the last action for {} s\n",
                            driving.when_lost.strategy, driving.when_lost.hold.count());
}

nlohmann::ordered_json map_json(const baselines::BoxAction& action) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::object();
  for (const auto& [name, row] : {std::pair("steering", 0), {"throttle", 1}}) {
    for (Eigen::Index i = 0; i < action.map.cols(); ++i) rows[name].push_back(action.map(row, i));
  }
  return rows;
}

}  // namespace

ModelDescription describe(const affordance::Model& model) {
  ModelDescription about;
  about.text = fmt::format("affordance model, format {}, {} rules, for {} x {} at {} Hz\n",
                           affordance::Model::kVersion, model.rules.size(), model.image_size.width,
                           model.image_size.height, model.frame_rate_hz);
  about.text += fmt::format("learnt from {}\n", model.fingerprint);
  const affordance::Knowledge knowledge = affordance::knowledge_of(model);
  about.text += affordance::to_text(knowledge) + "\n";
  about.text +=
      fmt::format("features {}; commands answer pictures {} s old\n",
                  fmt::join(model.config.features.kinds, ", "), model.config.transactions.lag);
  nlohmann::ordered_json types = nlohmann::ordered_json::array();
  for (int type = 0; type < model.actions.count(); ++type) {
    const auto index = static_cast<affordance::ActionType>(type);
    const Command centre = model.actions.centre(index);
    std::size_t rules = 0;
    for (const affordance::Rule& rule : model.rules) rules += rule.type == index ? 1 : 0;
    const std::string& name = model.actions.names[index];
    about.text += fmt::format("{:<16} steering {:+.2f}, throttle {:+.2f}: {} rules\n", name,
                              centre.steering, centre.throttle, rules);
    types.push_back({{"name", name},
                     {"steering", centre.steering},
                     {"throttle", centre.throttle},
                     {"rules", rules}});
  }
  about.json = {{"fingerprint", model.fingerprint},
                {"rules", model.rules.size()},
                {"features", model.config.features.kinds},
                {"lag_s", model.config.transactions.given_lag().value_or(Seconds{}).count()},
                {"frames_learnt", model.frames_learnt},
                {"frames_matched", model.frames_matched},
                {"knows_little", knowledge.little()},
                {"action_types", types}};
  return about;
}

ModelDescription describe(const exemplar::Model& model) {
  const exemplar::Hierarchy& hierarchy = model.hierarchy;
  std::size_t inner = 0;
  for (exemplar::NodeId node = 0; node < hierarchy.tree().nodes().size(); ++node) {
    inner += hierarchy.has_model(node) ? 1 : 0;
  }
  ModelDescription about;
  about.text =
      fmt::format("exemplar model, format {}, {}, for {} x {}\n", exemplar::Model::kVersion,
                  counted(hierarchy.exemplars().size(), "exemplar"), model.image_size.width,
                  model.image_size.height);
  about.text += fmt::format("learnt from {}\n", model.fingerprint);
  about.text += fmt::format("{}, {} of them with models, {} deep; tau {}\n",
                            counted(hierarchy.tree().nodes().size(), "node"), inner,
                            hierarchy.tree().depth(), hierarchy.config().tau);
  for (const auto& [name, i] : {std::pair("turn", 0), {"drive", 1}}) {
    about.text +=
        fmt::format("{:<6} {:+.2f}", name, hierarchy.action_mean(0)[static_cast<std::size_t>(i)]);
    if (hierarchy.has_model(0)) {  // of one exemplar there is none
      about.text += fmt::format(", standard deviation {:.2f}",
                                std::sqrt(hierarchy.action_model(0).covariance(i, i)));
    }
    about.text += "\n";
  }
  about.json = {
      {"fingerprint", model.fingerprint},         {"exemplars", hierarchy.exemplars().size()},
      {"nodes", hierarchy.tree().nodes().size()}, {"models", inner},
      {"depth", hierarchy.tree().depth()},        {"tau", hierarchy.config().tau}};
  return about;
}

ModelDescription describe(const baselines::SupervisedModel& model) {
  const baselines::WaldBoost& detector = model.detector;
  ModelDescription about;
  about.text = head(fmt::format("supervised model, format {}, {} weak classifiers, given boxes",
                                baselines::SupervisedModel::kVersion, detector.weak.size()),
                    model.origin);
  about.text += fmt::format("the target is {:.2f} times as wide as it is high\n", detector.aspect);
  about.text += driving_text(model.driving);
  about.json = {{"fingerprint", model.origin.fingerprint},
                {"given_boxes", to_text(GivenBoxes::kInTraining)},
                {"weak_classifiers", detector.weak.size()},
                {"aspect", detector.aspect},
                {"map", map_json(model.driving.action)}};
  return about;
}

ModelDescription describe(const baselines::NearestModel& model) {
  ModelDescription about;
  about.text =
      head(fmt::format("nearest-neighbour model, format {}, {} pictures of {} x {}, {} neighbours",
                       baselines::NearestModel::kVersion, model.commands.size(), model.size.width,
                       model.size.height, model.neighbours),
           model.origin);
  about.json = {{"fingerprint", model.origin.fingerprint},
                {"pictures", model.commands.size()},
                {"width", model.size.width},
                {"height", model.size.height},
                {"neighbours", model.neighbours}};
  return about;
}

ModelDescription describe(const baselines::RidgeModel& model) {
  ModelDescription about;
  about.text = head(fmt::format("ridge model, format {}, {}, {} inputs, ridge {}",
                                baselines::RidgeModel::kVersion, model.features.text(),
                                model.action.steering.size(), model.ridge),
                    model.origin);
  about.json = {{"fingerprint", model.origin.fingerprint},
                {"features", model.features.text()},
                {"inputs", model.action.steering.size()},
                {"ridge", model.ridge}};
  return about;
}

ModelDescription describe(const baselines::TrackerModel& model) {
  ModelDescription about;
  about.text = head(fmt::format("tracker model, format {}, {}, given boxes",
                                baselines::TrackerModel::kVersion, model.tracker),
                    model.origin);
  about.text += driving_text(model.driving);
  about.json = {{"fingerprint", model.origin.fingerprint},
                {"given_boxes", to_text(GivenBoxes::kAtTheStart)},
                {"tracker", model.tracker},
                {"map", map_json(model.driving.action)}};
  return about;
}

std::string to_text(GivenBoxes given) {
  switch (given) {
    case GivenBoxes::kInTraining:
      return "in training";
    case GivenBoxes::kAtTheStart:
      return "in training and at the start";
    case GivenBoxes::kNone:
      break;
  }
  return "none";
}

}  // namespace pacer
