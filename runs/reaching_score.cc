// SPDX-License-Identifier: Apache-2.0
#include "runs/reaching_score.h"

#include <fmt/format.h>

#include "runs/score.h"

namespace pacer {

std::string ReachingResult::verdict() const {
  if (reached) return "reached";
  return fmt::format("not reached{}{}{}", collided ? ", collided" : "", stuck ? ", stuck" : "",
                     out_of_impulses ? ", out of impulses" : "");
}

std::string ReachingResult::summary() const {
  return fmt::format("{} impulses in {:.1f} s, {:.2f} m from the red balloon at the end", impulses,
                     driven_s, distance_m);
}

ReachingScore::ReachingScore(const ReachingConfig& config, std::span<const SignalColumn> columns)
    : config_(config),
      pose_(offset_of(columns, "privileged.car_pose")),
      distance_(offset_of(columns, "privileged.red_distance")),
      collision_(offset_of(columns, "privileged.collision")) {}

bool ReachingScore::write(const Frame& frame, const Step& step) {
  constexpr float kMoved = 0.03F;  // metres
  const Eigen::Vector2f place(step.signals[pose_], step.signals[pose_ + 1]);
  if (!started_) first_ = last_ = frame.time;
  if (!started_ || (place - place_).norm() > kMoved) {
    place_ = place;
    moved_ = frame.time;
  }
  started_ = true;
  const Seconds period = frame.time - last_;
  last_ = frame.time;
  result_.driven_s = (last_ - first_ + period).count();
  result_.distance_m = static_cast<double>(step.signals[distance_]);
  result_.reached = result_.distance_m <= config_.distance;
  result_.collided = !result_.reached && step.signals[collision_] > 0.0F;
  result_.stuck = !result_.reached && frame.time - moved_ > config_.standstill;

  const bool drives = step.sent.throttle > 0.0;
  if (drives && !driving_ && !result_.reached) {
    result_.out_of_impulses = result_.impulses == config_.most_impulses;
    if (!result_.out_of_impulses) ++result_.impulses;
  }
  driving_ = drives;
  return !result_.reached && !result_.collided && !result_.stuck && !result_.out_of_impulses;
}

EpisodeScore ReachingScore::score() const { return result_; }

}  // namespace pacer
