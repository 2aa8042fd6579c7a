// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/evidence.h"

#include <algorithm>
#include <cmath>

namespace pacer::affordance {

Consensus ConsensusFinder::find(std::span<const Vote> votes, std::span<const float> x,
                                std::span<const float> y) {
  Consensus found;
  if (votes.empty()) return found;
  const auto median_of = [&](const auto& value) {
    values_.clear();
    for (std::size_t v = 0; v < votes.size(); ++v) {
      if (v > 0 && votes[v].centre == votes[v - 1].centre) continue;
      values_.push_back({static_cast<double>(value(votes[v])), 1.0});
    }
    return static_cast<float>(weighted_median(values_));
  };
  found.x = median_of([&](const Vote& vote) { return x[vote.centre]; });
  found.y = median_of([&](const Vote& vote) { return y[vote.centre]; });
  found.grid = 3.0F * median_of([](const Vote& vote) { return vote.tile_side; });
  found.configurations = static_cast<int>(values_.size());
  const SearchRegion near{.x = found.x, .y = found.y, .range = found.grid};
  rules_.clear();
  for (const Vote& vote : votes) {
    if (near.holds(x[vote.centre], y[vote.centre])) rules_.push_back(vote.rule);
  }
  std::sort(rules_.begin(), rules_.end());
  const auto end = std::unique(rules_.begin(), rules_.end());
  found.witnesses = static_cast<int>(end - rules_.begin());
  return found;
}

bool Evidence::add(Seconds time, int witnesses) noexcept {
  const double past = first_ ? 0.0 : std::max(0.0, (time - before_) / config_.memory);
  first_ = false;
  before_ = time;
  value_ += (1.0 - std::exp(-past)) * (witnesses - value_);
  enough_ = value_ >= least();
  return enough_;
}

double typical_witnesses(std::span<const FeatureLog> episodes,
                         std::span<const EpisodeMatches> matches, std::span<const char> kept,
                         const GridConfig& grid) {
  ConsensusFinder finder;
  std::vector<Vote> votes;
  std::vector<Weighted> witnesses;
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    const EpisodeMatches& found = matches[e];
    std::size_t m = 0;
    for (std::size_t f = 0; f < episodes[e].frame_count(); ++f) {
      const LabelledFeatures frame = episodes[e].frame(f);
      votes.clear();
      for (; m < found.rules.size() && found.frame_of[m] == f; ++m) {
        if (kept[found.rules[m]] == 0) continue;
        const std::uint16_t centre = found.centres[m];
        votes.push_back({.rule = found.rules[m],
                         .centre = centre,
                         .tile_side = static_cast<float>(grid.tile) * frame.size[centre],
                         .action = {}});
      }
      witnesses.push_back({static_cast<double>(finder.find(votes, frame.x, frame.y).witnesses)});
    }
  }
  return witnesses.empty() ? 0.0 : weighted_median(witnesses);
}

}  // namespace pacer::affordance
