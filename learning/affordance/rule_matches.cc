// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/rule_matches.h"

namespace pacer::affordance {

std::uint64_t EpisodeMatches::frames(std::span<const char> kept) const {
  std::uint64_t frames = 0;
  std::int64_t last = -1;
  for (std::size_t m = 0; m < rules.size(); ++m) {
    if (kept[rules[m]] == 0 || last == frame_of[m]) continue;
    last = frame_of[m];
    ++frames;
  }
  return frames;
}

EpisodeMatches find_matches(const FeatureLog& episode, std::span<const Rule> rules,
                            const RuleMatcher& matcher, const ItemLayout& layout,
                            const GridConfig& grid) {
  EpisodeMatches matches;
  Configuration configuration;
  for (std::size_t f = 0; f < episode.frame_count(); ++f) {
    const LabelledFeatures frame = episode.frame(f);
    for (std::size_t centre = 0; centre < frame.count(); ++centre) {
      build_configuration(frame, layout, grid, centre, configuration);
      matcher.match(configuration, [&](std::size_t rule) {
        matches.rules.push_back(static_cast<std::uint32_t>(rule));
        matches.frame_of.push_back(static_cast<std::uint32_t>(f));
        matches.centres.push_back(static_cast<std::uint16_t>(centre));
        for (const Item item : rules[rule].items) {
          matches.features.push_back(configuration.feature(item));
        }
        matches.offsets.push_back(static_cast<std::uint32_t>(matches.features.size()));
      });
    }
  }
  return matches;
}

MatchIndex::MatchIndex(std::span<const EpisodeMatches> episodes, std::size_t rules)
    : first_(rules + 1, 0) {
  for (const EpisodeMatches& episode : episodes) {
    for (const std::uint32_t rule : episode.rules) ++first_[rule + 1];
  }
  for (std::size_t r = 0; r < rules; ++r) first_[r + 1] += first_[r];
  where_.resize(first_.back());
  std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t e = 0; e < episodes.size(); ++e) {
    for (std::size_t m = 0; m < episodes[e].rules.size(); ++m) {
      where_[next[episodes[e].rules[m]]++] = {static_cast<std::uint32_t>(e),
                                              static_cast<std::uint32_t>(m)};
    }
  }
}

MappingExamples gather_examples(std::span<const FeatureLog> logs,
                                std::span<const EpisodeMatches> matches, const MatchIndex& index,
                                std::size_t rule) {
  MappingExamples examples;
  for (const auto& [e, m] : index.of(rule)) {
    const EpisodeMatches& episode = matches[e];
    const FeatureLog& log = logs[e];
    const std::uint32_t frame = episode.frame_of[m];
    for (std::uint32_t i = episode.offsets[m]; i < episode.offsets[m + 1]; ++i) {
      const std::size_t feature = log.offsets[frame] + episode.features[i];
      examples.poses.push_back(log.poses.x[feature]);
      examples.poses.push_back(log.poses.y[feature]);
      examples.poses.push_back(log.poses.size[feature]);
      examples.poses.push_back(log.poses.angle[feature]);
    }
    examples.actions.push_back(log.commands[frame]);
    examples.stretches.push_back((static_cast<std::uint64_t>(e) << 32U) | log.stretches[frame]);
  }
  return examples;
}

}  // namespace pacer::affordance
