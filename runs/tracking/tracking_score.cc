// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_score.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pacer {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPrecisionAt = 20;  // px

bool is_in(const Box& box, const Box& around) {
  return std::abs(box.x - around.x) <= 0.5 * around.width &&
         std::abs(box.y - around.y) <= 0.5 * around.height;
}

/// Share of the `scored` pictures that `passes`.
template <class Passes>
double share(const std::vector<double>& values, std::size_t scored, const Passes& passes) {
  std::size_t count = 0;
  for (const double value : values) count += passes(value) ? 1 : 0;  // NaN passes nothing
  return scored == 0 ? kNan : static_cast<double>(count) / static_cast<double>(scored);
}

/// Whether the target is held in a picture of the run.
struct Sight {
  std::size_t picture;
  bool held;
};

void tell_loss(std::span<const Sight> sights, TrackingScore& score) {
  score.frames_held = sights.size();
  for (std::size_t i = 0; i < sights.size(); ++i) {
    if (sights[i].held) continue;
    const auto ahead = sights.subspan(i, std::min(TrackingScore::kLossWindow, sights.size() - i));
    const auto held = static_cast<std::size_t>(std::ranges::count(ahead, true, &Sight::held));
    if (2 * held >= ahead.size()) continue;
    score.frames_held = i;
    score.lost_at = sights[i].picture;
    return;
  }
}

}  // namespace

TrackingScore score_tracks(std::span<const tracking::Track> tracks, Truth truth) {
  TrackingScore score;
  score.overlap.assign(truth.size(), kNan);
  score.centre_error.assign(truth.size(), kNan);
  std::vector<Sight> sights;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i] || !is_proper(*truth[i])) continue;
    ++score.scored;
    const bool tracked = i < tracks.size() && is_proper(tracks[i].box);
    const Box box = tracked ? tracks[i].box : Box{};
    score.overlap[i] = overlap(box, *truth[i]);
    score.centre_error[i] =
        tracked ? centre_distance(box, *truth[i]) : std::numeric_limits<double>::infinity();
    sights.push_back({.picture = i, .held = tracked && is_in(box, *truth[i])});
  }
  tell_loss(sights, score);

  for (std::size_t i = 0; i < score.success_plot.size(); ++i) {
    const double threshold = static_cast<double>(i) / 20.0;
    score.success_plot[i] =
        share(score.overlap, score.scored, [=](double value) { return value > threshold; });
  }
  for (std::size_t i = 0; i < score.precision_plot.size(); ++i) {
    const auto threshold = static_cast<double>(i);
    score.precision_plot[i] =
        share(score.centre_error, score.scored, [=](double value) { return value <= threshold; });
  }
  score.success = std::accumulate(score.success_plot.begin(), score.success_plot.end(), 0.0) /
                  static_cast<double>(score.success_plot.size());
  score.precision = score.precision_plot[kPrecisionAt];
  return score;
}

}  // namespace pacer
