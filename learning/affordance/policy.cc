// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/policy.h"

#include <algorithm>
#include <array>

namespace pacer::affordance {

AffordancePolicy::AffordancePolicy(std::shared_ptr<const Model> model)
    : model_(std::move(model)),
      perception_(*model_),
      evidence_(model_->config.response.evidence, model_->typical_witnesses),
      loss_(model_->config.response.loss) {}

Command AffordancePolicy::act(const Observation& observation, Annotations& annotations) {
  const Frame& frame = observation.frame;
  perception_.look(frame);
  const std::span<const Vote> votes = match();
  if (!evidence_.add(frame.time, consensus_.witnesses) || votes.empty()) {
    acted_on_ = 0;
    target_.range = -1.0F;
    annotations.label = label_of(loss_.phase(frame.time));
    return loss_.act(frame.time);
  }
  const Command action = respond(votes);
  acted_on_ = consensus_.configurations;
  const auto range = static_cast<float>(model_->config.response.search_range);
  target_ = {.x = consensus_.x,
             .y = consensus_.y,
             .range = range > 0.0F ? range * consensus_.grid : -1.0F};
  const double middle = 0.5 * (frame.size.width - 1);
  loss_.saw(frame.time, action, middle - static_cast<double>(consensus_.x));
  annotate(votes, annotations);
  return action;
}

/// Near the last target first; where nothing matches there, the whole image in the same frame
/// (6.6.2).
std::span<const Vote> AffordancePolicy::match() {
  const Poses& poses = perception_.features().poses;
  std::span<const Vote> votes = perception_.match(target_);
  if (votes.empty() && target_.range >= 0.0F) votes = perception_.match();
  consensus_ = finder_.find(votes, poses.x, poses.y);
  return votes;
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
  const float half = 0.5F * consensus_.grid;
  annotations.boxes.push_back({{consensus_.x - half, consensus_.y - half},
                               {consensus_.x + half, consensus_.y + half},
                               Tone::kTarget});
  const auto types = static_cast<std::ptrdiff_t>(model_->actions.names.size());
  const auto most =
      std::max_element(type_weight.begin(), type_weight.begin() + types) - type_weight.begin();
  annotations.label = model_->actions.names[static_cast<std::size_t>(most)] + ", " +
                      std::to_string(votes.size()) + " rules in " +
                      std::to_string(consensus_.configurations) + " places";
}

}  // namespace pacer::affordance
