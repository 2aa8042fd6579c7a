// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_cost.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/check.h"
#include "runs/tracking/picture_chunks.h"
#include "studies/materials.h"

namespace pacer {
namespace {

constexpr std::size_t kUpdates = 100;

double median_update_s(const tracking::TrackerKind& kind,
                       std::span<const tracking::Picture> pictures, const Box& box,
                       std::uint64_t seed) {
  using Clock = std::chrono::steady_clock;
  const std::unique_ptr<tracking::Tracker> tracker = kind.make(seed);
  tracker->start(pictures.front(), box);
  std::vector<double> seconds;
  for (const tracking::Picture& picture : pictures.subspan(1)) {
    const Clock::time_point start = Clock::now();
    (void)tracker->update(picture);
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  }
  const auto middle = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::ranges::nth_element(seconds, middle);
  return *middle;
}

}  // namespace

double power_of(std::span<const double> x, std::span<const double> y) {
  check(x.size() == y.size() && x.size() > 1, "a slope needs two points");
  const auto mean_log = [](std::span<const double> values) {
    double sum = 0.0;
    for (const double value : values) sum += std::log(value);
    return sum / static_cast<double>(values.size());
  };
  const double mean_x = mean_log(x);
  const double mean_y = mean_log(y);
  double both = 0.0;
  double squares = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double from_mean = std::log(x[i]) - mean_x;
    both += from_mean * (std::log(y[i]) - mean_y);
    squares += from_mean * from_mean;
  }
  return both / squares;
}

std::vector<TrackingCost> measure_costs(const std::vector<tracking::TrackerKind>& kinds,
                                        const TrackingTarget& target, std::uint64_t seed,
                                        const std::stop_token& stop) {
  PictureChunks chunks(target);
  const std::span<const tracking::Picture> pictures = chunks.next(kUpdates + 1);
  if (pictures.size() < 2) {
    throw std::runtime_error(target.name + ": has too few pictures to time trackers on");
  }
  const OneCore core;
  std::vector<TrackingCost> costs;
  for (const tracking::TrackerKind& kind : kinds) {
    TrackingCost cost{.tracker = kind.name, .areas = {}, .seconds = {}};
    for (const double scale : {1.0, 2.0, 4.0, 8.0}) {
      if (stop.stop_requested()) throw StudyStopped();
      const Box box{target.box.x, target.box.y, 33.0 * scale, 44.0 * scale};
      cost.areas.push_back(box.area());
      cost.seconds.push_back(median_update_s(kind, pictures, box, seed));
    }
    costs.push_back(std::move(cost));
  }
  return costs;
}

}  // namespace pacer
