// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/policy.h"

#include <algorithm>
#include <array>

namespace pacer::affordance {

AffordancePolicy::AffordancePolicy(std::shared_ptr<const Model> model)
    : model_(std::move(model)), perception_(*model_), loss_(model_->config.response.when_lost()) {}

Command AffordancePolicy::act(const Observation& observation, Annotations& annotations) {
  perception_.look(observation.frame);
  std::span<const Vote> votes = perception_.match(target_);
  // Nothing near the last target: the whole image, in the same frame.
  if (!enough(votes) && target_.range >= 0.0F) votes = perception_.match();
  if (!enough(votes)) return lost(observation, annotations);
  const Command action = respond(votes);
  loss_.saw(observation.frame.time, action);
  remember_target(votes);
  annotate(votes, annotations);
  return action;
}

bool AffordancePolicy::enough(std::span<const Vote> votes) {
  configurations_ = 0;
  for (std::size_t v = 0; v < votes.size(); ++v) {
    if (v == 0 || votes[v].centre != votes[v - 1].centre) ++configurations_;
  }
  return configurations_ >= model_->config.response.least_configurations;
}

Command AffordancePolicy::respond(std::span<const Vote> votes) {
  weights_.assign(votes.size(), 1.0);
  if (model_->config.response.vote == "configuration") {
    for (std::size_t first = 0; first < votes.size();) {
      std::size_t last = first;
      while (last < votes.size() && votes[last].centre == votes[first].centre) ++last;
      for (std::size_t v = first; v < last; ++v)
        weights_[v] = 1.0 / static_cast<double>(last - first);
      first = last;
    }
  }
  const auto median_of = [&](double Command::*component) {
    values_.clear();
    for (std::size_t v = 0; v < votes.size(); ++v) {
      values_.push_back({votes[v].action.*component, weights_[v]});
    }
    return weighted_median(values_);
  };
  return clamped({median_of(&Command::steering), median_of(&Command::throttle)});
}

void AffordancePolicy::remember_target(std::span<const Vote> votes) {
  const Poses& poses = perception_.features().poses;
  const auto median_of = [&](const auto& value) {
    values_.clear();
    for (std::size_t v = 0; v < votes.size(); ++v) {
      if (v > 0 && votes[v].centre == votes[v - 1].centre) continue;
      values_.push_back({static_cast<double>(value(votes[v])), 1.0});
    }
    return static_cast<float>(weighted_median(values_));
  };
  target_.x = median_of([&](const Vote& vote) { return poses.x[vote.centre]; });
  target_.y = median_of([&](const Vote& vote) { return poses.y[vote.centre]; });
  target_grid_ = 3.0F * median_of([](const Vote& vote) { return vote.tile_side; });
  const auto range = static_cast<float>(model_->config.response.search_range);
  target_.range = range > 0.0F ? range * target_grid_ : -1.0F;
}

Command AffordancePolicy::lost(const Observation& observation, Annotations& annotations) {
  target_.range = -1.0F;
  return loss_.respond(observation.frame.time, annotations.label);
}

void AffordancePolicy::annotate(std::span<const Vote> votes, Annotations& annotations) {
  const Poses& poses = perception_.features().poses;
  std::array<double, 256> type_weight{};
  marked_.assign(poses.count(), 0);
  for (std::size_t v = 0; v < votes.size(); ++v) {
    const Vote& vote = votes[v];
    type_weight[model_->rules[vote.rule].type] += weights_[v];
    named_features(*model_, perception_, vote, scratch_, named_);
    const PixelPoint centre{poses.x[vote.centre], poses.y[vote.centre]};
    for (const std::uint16_t feature : named_) {
      if (marked_[feature] != 0) continue;
      marked_[feature] = 1;
      const PixelPoint at{poses.x[feature], poses.y[feature]};
      annotations.points.push_back({at, 0.5F * poses.size[feature], Tone::kMatched});
      annotations.lines.push_back({centre, at, Tone::kMatched});
    }
  }
  const float half = 0.5F * target_grid_;
  annotations.boxes.push_back(
      {{target_.x - half, target_.y - half}, {target_.x + half, target_.y + half}, Tone::kTarget});
  const auto types = static_cast<std::ptrdiff_t>(model_->actions.names.size());
  const auto most =
      std::max_element(type_weight.begin(), type_weight.begin() + types) - type_weight.begin();
  annotations.label = model_->actions.names[static_cast<std::size_t>(most)] + ", " +
                      std::to_string(votes.size()) + " rules in " +
                      std::to_string(configurations_) + " places";
}

}  // namespace pacer::affordance
