// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_score.h"

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

/// Watches for the first stretch without the target.
class Hold {
 public:
  void see(std::size_t picture, bool held) {
    if (lost_) return;
    if (held) {
      run_ = 0;
    } else if (run_++ == 0) {
      since_ = picture;
      before_ = seen_;
    }
    ++seen_;
    lost_ = run_ == TrackingScore::kLossFrames;
  }
  void tell(TrackingScore& score) const {
    const bool lost = run_ > 0;  // a stretch that the end cut short is one, too
    score.frames_held = lost ? before_ : seen_;
    if (lost) score.lost_at = since_;
  }

 private:
  std::size_t seen_ = 0;    // pictures with truth
  std::size_t run_ = 0;     // of them, the last ones not held
  std::size_t since_ = 0;   // where that stretch began
  std::size_t before_ = 0;  // pictures with truth before it
  bool lost_ = false;
};

}  // namespace

TrackingScore score_tracks(std::span<const tracking::Track> tracks, Truth truth) {
  TrackingScore score;
  score.overlap.assign(truth.size(), kNan);
  score.centre_error.assign(truth.size(), kNan);
  Hold hold;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!truth[i] || !is_proper(*truth[i])) continue;
    ++score.scored;
    const bool tracked = i < tracks.size() && is_proper(tracks[i].box);
    const Box box = tracked ? tracks[i].box : Box{};
    score.overlap[i] = overlap(box, *truth[i]);
    score.centre_error[i] =
        tracked ? centre_distance(box, *truth[i]) : std::numeric_limits<double>::infinity();
    hold.see(i, tracked && is_in(box, *truth[i]));
  }
  hold.tell(score);

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
