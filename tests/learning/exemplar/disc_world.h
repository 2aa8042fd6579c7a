// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/demonstration.h"
#include "core/random.h"

namespace pacer::testing {

/// A balloon on a picture: a disc, pixels.
struct Disc {
  double x = 0.0, y = 0.0, radius = 0.0;
};

/// What one impulse is about: balloons before a plain wall, and what the teacher does.
struct DiscStep {
  std::optional<Disc> red, green;
  Command command;
  bool snow = false;  ///< interference, from below the discs down
};

inline constexpr ImageSize kDiscImage{.width = 160, .height = 120};

/// The picture of `step`, its edges smooth.
inline void paint(const DiscStep& step, std::uint64_t index, Frame& frame) {
  constexpr double kRate = 25.0;
  frame.index = index;
  frame.time = Seconds{static_cast<double>(index) / kRate};
  frame.size = kDiscImage;
  static const std::vector<std::uint8_t> kWall = [] {
    std::vector<std::uint8_t> wall;
    for (int pixel = 0; pixel < kDiscImage.width * kDiscImage.height; ++pixel) {
      wall.insert(wall.end(), {150, 146, 140});
    }
    return wall;
  }();
  frame.rgb = kWall;
  if (step.snow) {
    const std::ptrdiff_t below = std::ptrdiff_t{3} * kDiscImage.width * (kDiscImage.height - 20);
    for (auto value = frame.rgb.begin() + below; value != frame.rgb.end(); value += 3) {
      *(value + 1) = (value - frame.rgb.begin()) % 2 == 0 ? 255 : 0;
    }
  }
  for (const auto& [disc, red, green, blue] :
       {std::tuple(&step.green, 24.0, 150.0, 39.0), {&step.red, 180.0, 15.0, 17.0}}) {
    if (!*disc) continue;
    const auto [x0, y0, radius] = **disc;
    const int left = std::max(0, static_cast<int>(x0 - radius) - 1);
    const int right = std::min(kDiscImage.width, static_cast<int>(x0 + radius) + 3);
    const int top = std::max(0, static_cast<int>(y0 - radius) - 1);
    const int bottom = std::min(kDiscImage.height, static_cast<int>(y0 + radius) + 3);
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        const double outside = std::hypot(x - x0, y - y0) - radius;
        const double share = std::min(1.0, std::max(0.0, 0.5 - outside));
        const double shade = 1.0 - 0.35 * (y - y0) / radius;  // lit from above
        const double colour[3] = {red, green, blue};
        std::uint8_t* const rgb = frame.rgb.data() + std::ptrdiff_t{3} * (y * kDiscImage.width + x);
        for (int i = 0; i < 3; ++i) {
          rgb[i] =
              static_cast<std::uint8_t>(std::lround(rgb[i] + share * (shade * colour[i] - rgb[i])));
        }
      }
    }
  }
}

/// The red disc anywhere, or out of view one time in six; the green one likewise and for itself.
/// The teacher turns to the red one, the harder the farther it is to the side, or to the left.
inline DiscStep any_step(Random& random) {
  const auto disc = [&]() -> std::optional<Disc> {
    if (random.chance(1.0 / 6.0)) return std::nullopt;
    return Disc{.x = random.uniform(15.0, kDiscImage.width - 15.0),
                .y = random.uniform(32.0, 50.0),  // not far above the horizon
                .radius = random.uniform(5.0, 12.0)};
  };
  DiscStep step{.red = disc(), .green = disc(), .command = {.steering = 0.9, .throttle = 0.2}};
  while (step.red && step.green && std::abs(step.red->x - step.green->x) < 26.0)
    step.green = disc();
  if (step.red) {
    step.command.steering =
        0.8 * (1.0 - 2.0 * step.red->x / kDiscImage.width) + random.normal(0.0, 0.02);
  }
  return step;
}

/// Episodes of impulses: four frames at rest, six that move, the throttle rising, three that brake.
class DiscDemonstration final : public Demonstration {
 public:
  explicit DiscDemonstration(std::vector<std::vector<DiscStep>> episodes)
      : episodes_(std::move(episodes)) {}

  [[nodiscard]] static DiscDemonstration any(int episodes, int impulses, std::uint64_t seed) {
    Random random(seed);
    std::vector<std::vector<DiscStep>> all(static_cast<std::size_t>(episodes));
    for (std::vector<DiscStep>& episode : all) {
      for (int i = 0; i < impulses; ++i) episode.push_back(any_step(random));
    }
    return DiscDemonstration(std::move(all));
  }

  [[nodiscard]] const std::vector<std::vector<DiscStep>>& episodes() const { return episodes_; }

  [[nodiscard]] std::size_t episode_count() const override { return episodes_.size(); }
  [[nodiscard]] double frame_rate_hz() const override { return 25.0; }
  [[nodiscard]] ImageSize image_size() const override { return kDiscImage; }
  [[nodiscard]] std::string fingerprint() const override { return "disc world"; }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override {
    return std::make_unique<Stream>(episodes_.at(episode));
  }

 private:
  class Stream final : public DemonstrationStream {
   public:
    explicit Stream(const std::vector<DiscStep>& steps) : steps_(steps) {}
    [[nodiscard]] const DemonstratedStep* next() override {
      constexpr std::uint64_t kFrames = 13;
      const std::uint64_t impulse = index_ / kFrames;
      if (impulse >= steps_.size()) return nullptr;
      const DiscStep& step = steps_[impulse];
      const std::uint64_t phase = index_ % kFrames;
      paint(step, index_++, frame_);
      step_ = {.frame = &frame_, .command = {}};
      if (phase >= 4 && phase < 10) {
        const double share = std::min(1.0, static_cast<double>(phase - 3) / 3.0);
        step_.command = {.steering = step.command.steering,
                         .throttle = share * step.command.throttle};
      } else if (phase >= 10) {
        step_.command = {.steering = step.command.steering, .throttle = -0.3};
      }
      return &step_;
    }

   private:
    const std::vector<DiscStep>& steps_;
    std::uint64_t index_ = 0;
    Frame frame_;
    DemonstratedStep step_;
  };

  std::vector<std::vector<DiscStep>> episodes_;
};

}  // namespace pacer::testing
