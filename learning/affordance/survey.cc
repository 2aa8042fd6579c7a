// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/survey.h"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "learning/affordance/transactions.h"
#include "learning/read_episodes.h"

namespace pacer::affordance {

Survey survey(const Demonstration& demonstration, const AffordanceConfig& config,
              const Random& random, const TrainingOptions& options) {
  const auto stride = std::max<std::size_t>(
      1, static_cast<std::size_t>(std::round(config.words.every * demonstration.frame_rate_hz())));
  const auto samples = static_cast<std::size_t>(config.words.samples);
  Survey all;
  all.episodes.resize(demonstration.episode_count());
  all.sample = FeatureSample(samples);
  std::mutex merging;
  read_episodes(demonstration, options, "survey", [&](std::size_t number, auto& steps) {
    Survey::Episode& episode = all.episodes[number];
    ChangeDetector changes(config.transactions);
    FeatureExtractor extractor(config.features);
    Features features;
    FeatureSample sample(samples);
    Random dice = random.fork("word sample", number);
    while (const DemonstratedStep* step = steps.next()) {
      const bool counts = changes.counts(*step->frame, step->command);
      episode.commands.push_back(step->command);
      episode.counts.push_back(counts ? 1 : 0);
      if (!counts || episode.counted++ % stride != 0) continue;
      extractor.extract(*step->frame, features);
      for (std::size_t i = 0; i < features.count(); ++i) sample.offer(dice.next(), features, i);
    }
    const std::scoped_lock lock(merging);
    all.sample.merge(sample);
  });
  for (Survey::Episode& episode : all.episodes) {
    episode.before = all.counted;
    all.counted += episode.counted;
  }
  return all;
}

}  // namespace pacer::affordance
