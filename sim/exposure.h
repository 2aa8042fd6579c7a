// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/frame.h"
#include "core/random.h"
#include "core/range.h"

namespace pacer::sim {

/// How the camera chooses its exposure, and how grainy its sensor is.
struct ExposureConfig {
  double target = 112.0;         ///< grey level that it wants the picture's mean to have
  Seconds time_constant{0.8};    ///< of its correction
  double least_gain = 0.7;       ///< it cannot darken more
  double most_gain = 1.7;        ///< it cannot brighten more
  Range first_gain{0.85, 1.15};  ///< what an episode starts with, of the right one
  Range shutter{0.006, 0.012};   ///< seconds that it stands open: blur from motion
  Range noise{1.5, 3.5};         ///< grey levels, deviation of one sample

  /// Throws std::invalid_argument, naming the field.
  void validate() const;

  template <class Visitor>
  void fields(Visitor&& visit) {
    visit("target", target);
    visit("time_constant_s", time_constant);
    visit("least_gain", least_gain);
    visit("most_gain", most_gain);
    visit("first_gain", first_gain);
    visit("shutter_s", shutter);
    visit("noise", noise);
  }
};

/// Automatic exposure: a gain that follows the picture's brightness slowly.
class Exposure {
 public:
  Exposure(const ExposureConfig& config, const Random& random);

  /// The gain for the picture `rendered`, `dt` after the one before.
  double meter(const Frame& rendered, Seconds dt) noexcept;

  [[nodiscard]] Seconds shutter() const noexcept { return shutter_; }

 private:
  ExposureConfig config_;
  Seconds shutter_;
  double first_error_;
  double gain_ = 0.0;  // not yet metered
};

/// Noise of the sensor: a table drawn once, read from a new place for each row.
class SensorNoise {
 public:
  /// `row` is how many samples a row of the picture has.
  SensorNoise(double deviation, std::size_t row, const Random& random);

  /// The noise of one more row: that many samples, in grey levels.
  [[nodiscard]] const std::int8_t* next_row() noexcept {
    return table_.data() + random_.below(starts_);
  }

 private:
  Random random_;
  std::uint64_t starts_;
  std::vector<std::int8_t> table_;
};

}  // namespace pacer::sim
