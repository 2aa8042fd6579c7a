// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/marked_reading.h"

#include <vector>

#include "core/check.h"
#include "learning/baselines/tally.h"
#include "learning/read_episodes.h"

namespace pacer::baselines {
namespace {

/// Whether there is something to see in `target`.
bool is_worth(const Box& target) { return target.height >= kLowest && target.width >= kNarrowest; }

}  // namespace

MarkedReading read_marked(const MarkedDemonstration& demonstration, const TrainingOptions& options,
                          std::string_view stage,
                          const std::function<EpisodeVisit(std::size_t episode)>& visit) {
  const std::size_t episodes = demonstration.episode_count();
  std::vector<Tally> tallies(episodes);
  std::vector<std::uint64_t> marked(episodes);
  read_episodes(
      demonstration, options, stage, episodes,
      [&](std::size_t episode) { return demonstration.open_marked(episode); },
      [&](std::size_t episode, auto& steps) {
        const EpisodeVisit take = visit(episode);
        while (const MarkedStep* step = steps.next()) {
          MarkedStep shown = *step;
          if (shown.target && !is_worth(*shown.target)) shown.target.reset();
          tallies[episode].add(shown.step.command);
          marked[episode] += shown.target ? 1 : 0;
          take(shown);
        }
      });
  MarkedReading reading{.episodes = episodes, .frames = 0, .marked = 0, .mean = {}};
  Tally all;
  for (std::size_t episode = 0; episode < episodes; ++episode) {
    all.merge(tallies[episode]);
    reading.marked += marked[episode];
  }
  all.require_something();
  if (reading.marked == 0) {
    throw UsageError("the target is in no frame of the demonstration; record it in view");
  }
  reading.frames = all.frames();
  reading.mean = all.mean();
  return reading;
}

}  // namespace pacer::baselines
