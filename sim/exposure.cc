// SPDX-License-Identifier: Apache-2.0
#include "sim/exposure.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace pacer::sim {
namespace {

/// Mean of the samples, of one in about sixty: enough to tell how bright a picture is.
double mean_level(const Frame& frame) noexcept {
  constexpr std::size_t kStride = 61;  // prime, so that it meets all three channels and columns
  std::uint64_t sum = 0;
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < frame.rgb.size(); i += kStride, ++count) sum += frame.rgb[i];
  return static_cast<double>(sum) / static_cast<double>(count);
}

}  // namespace

void ExposureConfig::validate() const {
  require(target >= 20.0 && target <= 220.0, "target: must lie in [20, 220]");
  require(time_constant.count() > 0.0, "time_constant_s: must be positive");
  require(least_gain > 0.1 && least_gain <= most_gain && most_gain <= 4.0,
          "least_gain, most_gain: 0.1 < least <= most <= 4");
  first_gain.validate("first_gain", 0.3, 3.0);
  shutter.validate("shutter_s", 0.0, 0.04);
  noise.validate("noise", 0.0, 20.0);
}

Exposure::Exposure(const ExposureConfig& config, const Random& random) : config_(config) {
  Random open = random.fork("shutter");
  Random first = random.fork("first");
  shutter_ = Seconds{config.shutter.draw(open)};
  first_error_ = config.first_gain.draw(first);
}

double Exposure::meter(const Frame& rendered, Seconds dt) noexcept {
  const double right = std::clamp(config_.target / std::max(1.0, mean_level(rendered)),
                                  config_.least_gain, config_.most_gain);
  if (gain_ == 0.0) {
    gain_ = right * first_error_;
  } else {
    gain_ += (right - gain_) * -std::expm1(-dt / config_.time_constant);
  }
  return gain_;
}

SensorNoise::SensorNoise(double deviation, std::size_t row, const Random& random)
    : random_(random.fork("rows")), starts_(1U << 16U), table_(starts_ + row) {
  Random levels = random.fork("levels");
  for (std::int8_t& level : table_) {
    level = static_cast<std::int8_t>(
        std::clamp(std::lround(levels.normal(0.0, deviation)), -127L, 127L));
  }
}

}  // namespace pacer::sim
