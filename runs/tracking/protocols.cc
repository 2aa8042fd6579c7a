// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/protocols.h"

#include <chrono>
#include <exception>

#include "core/check.h"

namespace pacer {
namespace {

/// Adds what `work` takes to `seconds`.
template <class Work>
auto timed(double& seconds, const Work& work) {
  struct Clock {
    double& seconds;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    ~Clock() {
      seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    }
  };
  const Clock clock{seconds};
  return work();
}

}  // namespace

OnePass::OnePass(const tracking::TrackerKind& kind, std::uint64_t seed, std::size_t first,
                 const Box& box)
    : first_(first), box_(box), tracker_(kind.make(seed)) {}

void OnePass::see(std::size_t at, const tracking::Picture& picture) try {
  if (at < first_ || !error_.empty()) return;
  check(at - first_ == tracks_.size(), "pictures come one after the other");
  if (at == first_) {
    timed(start_s_, [&] { tracker_->start(picture, box_); });
    tracks_.push_back({.box = box_, .confidence = 1.0});
  } else {
    tracks_.push_back(timed(update_s_, [&] { return tracker_->update(picture); }));
  }
} catch (const std::exception& failure) {  // OpenCV's own are among them
  error_ = failure.what();
  if (error_.empty()) error_ = "it threw an exception";
}

const tracking::Track* OnePass::track(std::size_t at) const noexcept {
  return at >= first_ && at - first_ < tracks_.size() ? &tracks_[at - first_] : nullptr;
}

void Supervised::see(std::size_t at, const tracking::Picture& picture,
                     const tracking::Track* one_pass) {
  const bool annotated = at < truth_.size() && truth_[at] && is_proper(*truth_[at]);
  std::optional<tracking::Track> track;
  if (failures_.empty()) {
    if (one_pass != nullptr) track = *one_pass;
  } else if (tracker_) {
    try {
      track = tracker_->update(picture);
    } catch (const std::exception&) {  // it has lost the target, in its way
      failures_.push_back(at);
      tracker_.reset();
      return;
    }
  } else {
    if (annotated && at >= failures_.back() + kPause) start(picture, *truth_[at]);
    return;
  }
  if (!annotated || (track && overlap(track->box, *truth_[at]) > 0.0)) return;
  failures_.push_back(at);
  tracker_.reset();
}

void Supervised::start(const tracking::Picture& picture, const Box& box) {
  tracker_ = kind_.make(seed_);
  try {
    tracker_->start(picture, box);
  } catch (const std::exception&) {  // e.g. outside of the picture: the next one, then
    tracker_.reset();
  }
}

std::vector<TrackingStart> temporal_starts(Truth truth, std::size_t first) {
  constexpr std::size_t kStarts = 20;
  std::vector<TrackingStart> annotated;
  for (std::size_t at = first; at < truth.size(); ++at) {
    if (truth[at] && is_proper(*truth[at])) annotated.push_back({.first = at, .box = *truth[at]});
  }
  std::vector<TrackingStart> starts;
  if (annotated.empty()) return starts;
  const std::size_t count = std::min(kStarts, annotated.size());  // none twice
  for (std::size_t i = 0; i < count; ++i) starts.push_back(annotated[i * annotated.size() / count]);
  return starts;
}

std::vector<TrackingStart> spatial_starts(const Box& box, std::size_t first) {
  std::vector<TrackingStart> starts;
  for (const int across : {-1, 0, 1}) {
    for (const int down : {-1, 0, 1}) {
      if (across == 0 && down == 0) continue;
      Box moved = box;
      moved.x += 0.1 * across * box.width;
      moved.y += 0.1 * down * box.height;
      starts.push_back({.first = first, .box = moved});
    }
  }
  for (const double scale : {0.8, 0.9, 1.1, 1.2}) {
    starts.push_back(
        {.first = first, .box = {box.x, box.y, scale * box.width, scale * box.height}});
  }
  return starts;
}

}  // namespace pacer
