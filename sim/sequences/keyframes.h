// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <numbers>
#include <string_view>
#include <vector>

#include "core/check.h"
#include "core/random.h"

namespace pacer::sim {

/// A number that changes smoothly from key to key and never beyond them (a monotone cubic, after
/// Fritsch and Carlson 1980); constant before the first and after the last.
class Keyframes {
 public:
  struct Key {
    double frame;
    double value;
  };

  /// `keys` in the order of their frames.
  Keyframes(std::initializer_list<Key> keys) : keys_(keys), slopes_(keys.size(), 0.0) {
    check(!keys_.empty(), "a keyframed number has a key");
    for (std::size_t i = 1; i + 1 < keys_.size(); ++i) {
      const double before = slope(i - 1);
      const double after = slope(i);
      if (before * after > 0.0) slopes_[i] = 2.0 * before * after / (before + after);
    }
  }

  [[nodiscard]] double at(double frame) const {
    if (frame <= keys_.front().frame) return keys_.front().value;
    if (frame >= keys_.back().frame) return keys_.back().value;
    const auto after = std::ranges::upper_bound(keys_, frame, {}, &Key::frame);
    const auto i = static_cast<std::size_t>(after - keys_.begin()) - 1;
    const double length = keys_[i + 1].frame - keys_[i].frame;
    const double s = (frame - keys_[i].frame) / length;
    const double t = 1.0 - s;
    return keys_[i].value * t * t * (1.0 + 2.0 * s) + keys_[i + 1].value * s * s * (1.0 + 2.0 * t) +
           length * s * t * (slopes_[i] * t - slopes_[i + 1] * s);
  }

 private:
  [[nodiscard]] double slope(std::size_t i) const {
    check(keys_[i + 1].frame > keys_[i].frame, "keys are in the order of their frames");
    return (keys_[i + 1].value - keys_[i].value) / (keys_[i + 1].frame - keys_[i].frame);
  }

  std::vector<Key> keys_;
  std::vector<double> slopes_;  // a frame, at each key; 0 at the ends and where the way turns
};

/// The idle motion of living things: slow sines, within [-1, 1]. Its `name` is its seed, so that it
/// is part of the script.
class Sway {
 public:
  /// `period` of the slowest sine, frames.
  Sway(std::string_view name, double period) : period_(period) {
    Random random = Random(1).fork(name);
    for (double& phase : phases_) phase = random.uniform(0.0, 2.0 * std::numbers::pi);
  }

  [[nodiscard]] double at(double frame) const {
    constexpr std::array<double, 3> kFaster = {1.0, 1.7, 2.9};
    constexpr std::array<double, 3> kShares = {0.55, 0.3, 0.15};
    double sum = 0.0;
    for (std::size_t i = 0; i < phases_.size(); ++i) {
      sum += kShares.at(i) *
             std::sin(2.0 * std::numbers::pi * kFaster.at(i) * frame / period_ + phases_.at(i));
    }
    return sum;
  }

 private:
  double period_;
  std::array<double, 3> phases_{};
};

}  // namespace pacer::sim
