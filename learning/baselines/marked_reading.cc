// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/marked_reading.h"

#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/check.h"
#include "core/parallel.h"
#include "learning/baselines/tally.h"

namespace pacer::baselines {

MarkedReading read_marked(const MarkedDemonstration& demonstration, const TrainingOptions& options,
                          std::string_view stage,
                          const std::function<EpisodeVisit(std::size_t episode)>& visit) {
  const std::size_t episodes = demonstration.episode_count();
  std::vector<Tally> tallies(episodes);
  std::vector<std::uint64_t> marked(episodes);
  std::mutex telling;
  std::size_t done = 0;
  parallel_for(episodes, options.jobs, [&](std::size_t episode) {
    const EpisodeVisit take = visit(episode);
    const auto stream = demonstration.open_marked(episode);
    while (const MarkedStep* step = stream->next()) {
      if (options.stop.stop_requested()) throw TrainingStopped();
      if (step->step.frame->size != demonstration.image_size()) {
        throw std::runtime_error("episode " + std::to_string(episode) +
                                 ": a frame's size is not the recording's");
      }
      tallies[episode].add(step->step.command);
      marked[episode] += step->target ? 1 : 0;
      take(*step);
    }
    const std::scoped_lock lock(telling);
    ++done;
    if (options.progress) {
      options.progress(stage, static_cast<double>(done) / static_cast<double>(episodes));
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
