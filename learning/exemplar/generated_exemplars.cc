// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/generated_exemplars.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/check.h"
#include "learning/exemplar/percept.h"
#include "learning/exemplar/response.h"

namespace pacer::exemplar {
namespace {

constexpr double kWidth = 320.0;
constexpr double kHeight = 240.0;

/// Where a balloon is drawn.
struct Disc {
  double x, y, radius;  // pixels
  [[nodiscard]] bool in_view() const { return x >= 0.0 && x < kWidth && y >= 0.0 && y < kHeight; }
};

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

Disc place(const GeneratedExemplars& config, Random& random) {
  const double focal = 0.5 * kWidth / std::tan(0.5 * radians(config.view_deg));
  const double bearing = radians(random.uniform(-config.bearing_deg, config.bearing_deg));
  const double depth = random.uniform(config.nearest_m, config.farthest_m) * std::cos(bearing);
  const double height = random.uniform(-config.highest_m, config.highest_m);
  return {.x = 0.5 * kWidth - focal * std::tan(bearing),  // to the left is positive
          .y = 0.5 * kHeight - focal * height / depth,
          .radius = focal * config.radius_m / depth};
}

void append_blob(const Disc& disc, const double (&colour)[3], const GeneratedExemplars& config,
                 Random& random, std::vector<double>& percept) {
  if (!disc.in_view()) {
    percept.insert(percept.end(), kBalloonValues, 0.0);
    return;
  }
  const auto shape = [&](double value) {
    return value * (1.0 + random.normal(0.0, config.shape_noise));
  };
  const double second = 0.25 * disc.radius * disc.radius;  // of a disc, over its area
  percept.push_back(shape(std::numbers::pi * disc.radius * disc.radius));
  percept.push_back(disc.x + random.normal(0.0, config.pixel_noise));
  percept.push_back(disc.y + random.normal(0.0, config.pixel_noise));
  percept.push_back(shape(second));
  percept.push_back(second * random.normal(0.0, config.shape_noise));
  percept.push_back(shape(second));
  const double light = 1.0 + random.normal(0.0, config.light);
  for (const double channel : colour) {
    percept.push_back(light * channel + random.normal(0.0, config.colour_noise));
  }
}

}  // namespace

void GeneratedExemplars::validate() const {
  require(exemplars >= 1, "exemplars: must be at least 1");
  require(bearing_deg > 0.0 && bearing_deg < 90.0, "bearing_deg: must lie in (0, 90)");
  require(view_deg > 0.0 && view_deg < 180.0, "view_deg: must lie in (0, 180)");
  require(nearest_m > 0.0 && nearest_m <= farthest_m,
          "nearest_m: must lie above 0 and not above farthest_m");
  require(radius_m > 0.0, "radius_m: must be positive");
  require(highest_m >= 0.0, "highest_m: must not be negative");
  require(pixel_noise >= 0.0, "pixel_noise: must not be negative");
  require(shape_noise >= 0.0, "shape_noise: must not be negative");
  require(light >= 0.0, "light: must not be negative");
  require(colour_noise >= 0.0, "colour_noise: must not be negative");
  require(turn_scatter >= 0.0, "turn_scatter: must not be negative");
  require(drive_scatter >= 0.0, "drive_scatter: must not be negative");
}

Exemplars generate_exemplars(const GeneratedExemplars& config, Random random) {
  config.validate();
  constexpr double kRed[] = {200.0, 40.0, 40.0};
  constexpr double kGreen[] = {50.0, 170.0, 60.0};
  constexpr double kTurning = 0.8;   // to the left, while the red one is out of view
  constexpr double kLargest = 40.0;  // pixels of radius at which the teacher drives slowest
  std::vector<double> percepts;
  std::vector<double> actions;
  percepts.reserve(static_cast<std::size_t>(config.exemplars) * kPerceptSize);
  actions.reserve(static_cast<std::size_t>(config.exemplars) * kActionSize);
  for (int n = 0; n < config.exemplars; ++n) {
    const Disc red = place(config, random);
    const Disc green = place(config, random);
    append_blob(red, kRed, config, random, percepts);
    append_blob(green, kGreen, config, random, percepts);
    const double turn = red.in_view() ? 1.0 - 2.0 * red.x / kWidth : kTurning;
    const double drive = red.in_view() ? 1.0 - 0.7 * std::min(red.radius / kLargest, 1.0) : 0.3;
    actions.push_back(std::clamp(turn + random.normal(0.0, config.turn_scatter), -1.0, 1.0));
    actions.push_back(std::clamp(drive + random.normal(0.0, config.drive_scatter), 0.0, 1.0));
  }
  return {kPerceptSize, kActionSize, std::move(percepts), std::move(actions)};
}

}  // namespace pacer::exemplar
