// SPDX-License-Identifier: Apache-2.0
#include "runs/keeping_score.h"

#include <fmt/format.h>

#include <cmath>

#include "runs/score.h"

namespace pacer {

std::string KeepingResult::verdict() const {
  return fmt::format("{}{}{}{}", kept ? "kept" : "not kept", collided ? ", collided" : "",
                     left ? ", left the lane" : "", stuck ? ", stuck" : "");
}

std::string KeepingResult::summary() const {
  return fmt::format("{:.1f} s driven, {:.1f} m or {:.2f} laps, {:.2f} m off the middle on average",
                     driven_s, distance_m, laps, offset_m);
}

KeepingScore::KeepingScore(const KeepingConfig& config, std::span<const SignalColumn> columns)
    : config_(config),
      driven_(offset_of(columns, "privileged.lane_driven")),
      offset_(offset_of(columns, "privileged.lane_offset")),
      collision_(offset_of(columns, "privileged.collision")) {}

bool KeepingScore::write(const Frame& frame, const Step& step) {
  constexpr double kGotOn = 0.03;  // metres: less is a car that trembles
  if (frames_ == 0) first_ = got_on_ = frame.time;
  last_ = frame.time;
  ++frames_;
  result_.distance_m = static_cast<double>(step.signals[driven_]);
  result_.laps = static_cast<double>(step.signals[driven_ + 1]);
  const double offset = std::abs(static_cast<double>(step.signals[offset_]));
  offset_sum_ += offset;
  if (result_.distance_m > farthest_ + kGotOn) {
    farthest_ = result_.distance_m;
    got_on_ = frame.time;
  }
  result_.collided = step.signals[collision_] > 0.0F;
  result_.left = offset > config_.most_offset;
  result_.stuck = frame.time - got_on_ > config_.standstill;
  return !result_.collided && !result_.left && !result_.stuck;
}

KeepingResult KeepingScore::result() const {
  KeepingResult score = result_;
  if (frames_ == 0) return score;
  const double count = static_cast<double>(frames_);
  const double period = frames_ > 1 ? (last_ - first_).count() / (count - 1.0) : 0.0;
  score.driven_s = (last_ - first_).count() + period;
  score.offset_m = offset_sum_ / count;
  const bool whole = score.driven_s >= config_.duration.count() - period;
  score.kept = whole && !score.collided && !score.left && !score.stuck &&
               score.distance_m >= config_.least_distance;
  return score;
}

EpisodeScore KeepingScore::score() const { return result(); }

}  // namespace pacer
