// SPDX-License-Identifier: Apache-2.0
#include "runs/following_score.h"

#include <fmt/format.h>

#include <cmath>

#include "runs/score.h"

namespace pacer {

std::string FollowingResult::verdict() const {
  return fmt::format("{}{}{}{}", followed ? "followed" : "not followed",
                     collided ? ", collided" : "", lost ? ", lost the lead" : "",
                     out_of_range ? ", too near or too far" : "");
}

std::string FollowingResult::summary() const {
  return fmt::format("{:.1f} s driven, lead in view {:.1f} %, mean distance {:.2f} m", driven_s,
                     100.0 * in_view, distance_m);
}

FollowingScore::FollowingScore(const FollowingConfig& config, std::span<const SignalColumn> columns)
    : config_(config),
      visible_(offset_of(columns, "privileged.lead_visible")),
      distance_(offset_of(columns, "privileged.lead_distance")),
      bearing_(offset_of(columns, "privileged.lead_bearing")),
      collision_(offset_of(columns, "privileged.collision")) {}

bool FollowingScore::write(const Frame& frame, const Step& step) {
  if (frames_ == 0) first_ = last_ = last_seen_ = frame.time;
  const double dt = (frame.time - last_).count();
  if (frames_ >= 2 && dt > 0.0) {
    const double jerk = (step.sent.steering - 2.0 * steering_[1] + steering_[0]) / (dt * dt);
    jerk_squares_ += jerk * jerk;
    ++jerks_;
  }
  if (dt > 0.0) frames_expected_ = std::round(config_.duration.count() / dt);
  steering_[0] = steering_[1];
  steering_[1] = step.sent.steering;
  last_ = frame.time;
  ++frames_;

  const double distance = static_cast<double>(step.signals[distance_]);
  distance_sum_ += distance;
  if (distance >= config_.nearest && distance <= config_.farthest) ++frames_in_range_;
  const bool seen = step.signals[visible_] > 0.0F;
  if (seen) {
    last_seen_ = frame.time;
    missed_ = false;
    ++frames_seen_;
    bearing_sum_ += std::abs(static_cast<double>(step.signals[bearing_]));
  }
  // Times of frames are rounded: none of them shall decide.
  constexpr Seconds kRounding{1e-6};
  // Interference hides the lead for a few frames at a time: that is no loss.
  constexpr Seconds kFlicker{0.2};
  if (frames_seen_ > 0 && !missed_ && frame.time - last_seen_ > kFlicker + kRounding) {
    missed_ = true;
    ++result_.losses;
  }

  result_.collided = result_.collided || step.signals[collision_] > 0.0F;
  result_.lost = result_.lost || last_ - last_seen_ > config_.longest_loss + kRounding;
  const double out_of_range = static_cast<double>(frames_ - frames_in_range_);
  // The tolerance keeps 0.1 of 1500 frames at 150.
  const double allowed = std::floor((1.0 - config_.share_in_range) * frames_expected_ + 1e-6);
  result_.out_of_range = frames_expected_ > 0.0 && out_of_range > allowed;
  return !result_.collided && !result_.lost && !result_.out_of_range;
}

FollowingResult FollowingScore::result() const {
  FollowingResult score = result_;
  if (frames_ == 0) return score;
  const double count = static_cast<double>(frames_);
  const double period = frames_ > 1 ? (last_ - first_).count() / (count - 1.0) : 0.0;
  score.driven_s = (last_ - first_).count() + period;
  score.in_view = static_cast<double>(frames_seen_) / count;
  score.in_range = static_cast<double>(frames_in_range_) / count;
  score.distance_m = distance_sum_ / count;
  score.bearing_rad = frames_seen_ > 0 ? bearing_sum_ / static_cast<double>(frames_seen_) : 0.0;
  score.steering_jerk = jerks_ > 0 ? std::sqrt(jerk_squares_ / static_cast<double>(jerks_)) : 0.0;
  const bool whole = score.driven_s >= config_.duration.count() - period;
  score.followed = whole && !score.collided && !score.lost && !score.out_of_range;
  return score;
}

EpisodeScore FollowingScore::score() const { return result(); }

}  // namespace pacer
