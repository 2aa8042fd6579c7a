// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/perception.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

namespace pacer::affordance {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kMostInputs = kPoseSize * kMaxItems;

std::string text(const ImageSize& size) {
  return std::to_string(size.width) + " x " + std::to_string(size.height);
}

}  // namespace

Perception::Perception(const Model& model)
    : model_(model), layout_(model.vocabulary), extractor_(model.config.features) {}

void Perception::look(const Frame& frame) {
  if (frame.size != model_.image_size) {
    throw std::runtime_error("the model was learnt from pictures of " + text(model_.image_size) +
                             " and this one has " + text(frame.size) +
                             "; use the camera's old size or learn again");
  }
  const auto start = Clock::now();
  extractor_.extract(frame, features_);
  const auto extracted = Clock::now();
  model_.vocabulary.label(features_, words_);
  times_ = {.features = extracted - start, .words = Clock::now() - extracted, .matching = {}};
}

void Perception::look(const Features& features) {
  features_ = features;
  model_.vocabulary.label(features_, words_);
  times_ = {};
}

std::span<const Vote> Perception::match(const SearchRegion& region) {
  const auto start = Clock::now();
  votes_.clear();
  const LabelledFeatures labelled(features_.poses, words_);
  for (std::size_t centre = 0; centre < labelled.count(); ++centre) {
    if (!region.holds(labelled.x[centre], labelled.y[centre])) continue;
    build_configuration(labelled, layout_, model_.config.grid, centre, configuration_);
    model_.matcher.match(configuration_, [&](std::size_t rule) { predict(configuration_, rule); });
  }
  times_.matching += Clock::now() - start;
  return votes_;
}

void Perception::predict(const Configuration& configuration, std::size_t rule) {
  std::array<float, kMostInputs> pose;
  std::size_t length = 0;
  for (const Item item : model_.rules[rule].items) {
    const std::size_t feature = configuration.feature(item);
    pose[length++] = features_.poses.x[feature];
    pose[length++] = features_.poses.y[feature];
    pose[length++] = features_.poses.size[feature];
    pose[length++] = features_.poses.angle[feature];
  }
  votes_.push_back(
      {static_cast<std::uint32_t>(rule), configuration.centre, configuration.tile_side,
       model_.mappings[rule].predict({pose.data(), length}, model_.config.mapping.clamp_sd)});
}

void named_features(const Model& model, const Perception& perception, const Vote& vote,
                    Configuration& scratch, std::vector<std::uint16_t>& named) {
  const LabelledFeatures labelled(perception.features().poses, perception.words());
  build_configuration(labelled, ItemLayout(model.vocabulary), model.config.grid, vote.centre,
                      scratch);
  named.clear();
  for (const Item item : model.rules[vote.rule].items) named.push_back(scratch.feature(item));
  std::sort(named.begin(), named.end());
  named.erase(std::unique(named.begin(), named.end()), named.end());
}

std::vector<MatchedRule> matched_rules(const Model& model, Perception& perception) {
  std::vector<MatchedRule> matched;
  const Poses& poses = perception.features().poses;
  Configuration scratch;
  std::vector<std::uint16_t> named;
  for (const Vote& vote : perception.match()) {
    MatchedRule& rule = matched.emplace_back();
    rule.rule = vote.rule;
    rule.type = model.rules[vote.rule].type;
    rule.centre = {poses.x[vote.centre], poses.y[vote.centre]};
    rule.tile_side = vote.tile_side;
    rule.action = vote.action;
    named_features(model, perception, vote, scratch, named);
    for (const std::uint16_t feature : named) {
      rule.points.push_back({poses.x[feature], poses.y[feature]});
    }
  }
  return matched;
}

}  // namespace pacer::affordance
