// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "core/marking.h"
#include "core/parallel.h"
#include "core/training.h"

namespace pacer {

/// The steps of one episode as training reads them, plain or marked.
template <class Stream>
class TrainingSteps {
 public:
  TrainingSteps(std::unique_ptr<Stream> stream, std::size_t episode, ImageSize size,
                const std::stop_token& stop)
      : stream_(std::move(stream)), episode_(episode), size_(size), stop_(stop) {}

  /// As the stream's. Throws TrainingStopped, and std::runtime_error where a frame's size is not
  /// the recording's.
  [[nodiscard]] auto next() {
    const auto* const step = stream_->next();
    if (step == nullptr) return step;
    if (stop_.stop_requested()) throw TrainingStopped();
    if (frame_of(*step).size != size_) {
      throw std::runtime_error("episode " + std::to_string(episode_) +
                               ": a frame's size is not the recording's");
    }
    return step;
  }

 private:
  static const Frame& frame_of(const DemonstratedStep& step) { return *step.frame; }
  static const Frame& frame_of(const MarkedStep& step) { return *step.step.frame; }

  std::unique_ptr<Stream> stream_;
  std::size_t episode_;
  ImageSize size_;
  const std::stop_token& stop_;
};

/// Reads every episode of `demonstration`: read(episode, steps), with the TrainingSteps of the
/// stream that open(episode) returns. They are dealt round to `lanes`, each of which reads its own
/// in order, on one thread; up to `options.jobs` at a time. Tells of each that is done.
template <class Open, class Read>
void read_episodes(const Demonstration& demonstration, const TrainingOptions& options,
                   std::string_view stage, std::size_t lanes, const Open& open, const Read& read) {
  const std::size_t episodes = demonstration.episode_count();
  std::mutex telling;
  std::size_t done = 0;
  parallel_for(lanes, options.jobs, [&](std::size_t lane) {
    for (std::size_t episode = lane; episode < episodes; episode += lanes) {
      TrainingSteps steps(open(episode), episode, demonstration.image_size(), options.stop);
      read(episode, steps);
      const std::scoped_lock lock(telling);
      ++done;
      if (options.progress) {
        options.progress(stage, static_cast<double>(done) / static_cast<double>(episodes));
      }
    }
  });
}

/// The same for plain steps, each episode on a thread of its own.
template <class Read>
void read_episodes(const Demonstration& demonstration, const TrainingOptions& options,
                   std::string_view stage, const Read& read) {
  read_episodes(
      demonstration, options, stage, demonstration.episode_count(),
      [&](std::size_t episode) { return demonstration.open(episode); }, read);
}

/// How about `most` pictures are taken from episodes, as many from each.
struct PictureShares {
  std::size_t stride = 1;  ///< of the episodes, every so many-th is looked at
  std::size_t each = 2;    ///< pictures of one of those, at most
};

/// At least two from each that is looked at, and never more than `most`, which is 2 or more, in
/// all.
[[nodiscard]] constexpr PictureShares picture_shares(std::size_t episodes, std::size_t most) {
  const std::size_t fit = most / 2;  // episodes
  const std::size_t stride = std::max<std::size_t>(1, (episodes + fit - 1) / fit);
  const std::size_t looked_at = std::max<std::size_t>(1, (episodes + stride - 1) / stride);
  return {.stride = stride, .each = most / looked_at};
}

}  // namespace pacer
