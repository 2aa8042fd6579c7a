// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/percept.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

#include "core/check.h"
#include "learning/exemplar/balloon_choice.h"

namespace pacer::exemplar {
namespace {

/// How many rows there are above the first one of snow.
int rows_above_snow(const Frame& frame, double limit) noexcept {
  const int width = frame.size.width;
  if (width < 2) return frame.size.height;
  const auto most = static_cast<std::int64_t>(limit * (width - 1));
  const std::uint8_t* green = frame.rgb.data() + 1;
  for (int y = 0; y < frame.size.height; ++y, green += 3 * static_cast<std::ptrdiff_t>(width)) {
    std::int64_t sum = 0;
    for (int x = 1; x < width; ++x) sum += std::abs(green[3 * x] - green[3 * x - 3]);
    if (sum > most) return y;
  }
  return frame.size.height;
}

}  // namespace

void PerceptConfig::validate() const {
  PerceptConfig copy = *this;
  copy.fields([](const char* name, auto& section) { validate_section(name, section); });
}

PerceptConfig of_videos(PerceptConfig config) {
  config.colours.tolerance = std::min(1.5 * config.colours.tolerance, 0.1);
  config.colours.dark = std::min(4.0 * config.colours.dark, 10.0);
  // Just beyond a balloon's edge its own colour is still about.
  config.balloons.small_step *= 0.5;
  config.balloons.clear *= 0.67;
  config.balloons.side_clear *= 0.6;
  return config;
}

Percept percept(const Balloons& balloons) noexcept {
  Percept values{};
  std::size_t at = 0;
  for (const std::optional<Blob>* one : {&balloons.red, &balloons.green}) {
    if (*one) {
      const Blob& blob = **one;
      const std::array<double, kBalloonValues> nine = {
          blob.area, blob.centroid.x(), blob.centroid.y(), blob.xx,       blob.xy,
          blob.yy,   blob.colour[0],    blob.colour[1],    blob.colour[2]};
      std::ranges::copy(nine, values.begin() + static_cast<std::ptrdiff_t>(at));
    }
    at += kBalloonValues;
  }
  return values;
}

Balloons balloons(const Percept& percept) noexcept {
  Balloons both;
  const double* nine = percept.data();
  for (std::optional<Blob>* one : {&both.red, &both.green}) {
    if (nine[0] > 0.0) {
      Blob& blob = one->emplace();
      blob.area = nine[0];
      blob.centroid = {nine[1], nine[2]};
      blob.xx = nine[3];
      blob.xy = nine[4];
      blob.yy = nine[5];
      blob.colour = {nine[6], nine[7], nine[8]};
    }
    nine += kBalloonValues;
  }
  return both;
}

void mark(const Balloons& balloons, Annotations& annotations) {
  if (balloons.red) mark(*balloons.red, Tone::kTarget, annotations);
  if (balloons.green) mark(*balloons.green, Tone::kNeutral, annotations);
}

BalloonFinder::BalloonFinder(const PerceptConfig& config)
    : config_(config),
      finder_(config.blobs),
      grower_(config.balloons, ColourTable(config.colours)) {
  config_.validate();
}

const Balloons& BalloonFinder::find(const Frame& frame) {
  blobs_ = finder_.find(frame);
  const int rows = rows_above_snow(frame, config_.balloons.interference);
  whole_ = rows == frame.size.height;
  const std::span<Region> regions = grower_.grow(frame, finder_, blobs_, rows);
  const auto choose = [&](Name name, const std::optional<Blob>& other) {
    return choose_balloon(regions, name, frame.size, other, config_.balloons);
  };
  balloons_.red = choose(Name::kRed, {});
  balloons_.green = choose(Name::kGreen, balloons_.red);
  balloons_.red = choose(Name::kRed, balloons_.green);
  return balloons_;
}

}  // namespace pacer::exemplar
