// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/colour_table.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

/// Of a thing in light that is warmer by `tint`, cooler where that is below 0.
Eigen::Vector3d shares_of(const NamedColour& entry, double tint) {
  const Eigen::Vector3d colour(entry.red * (1.0 + tint), entry.green, entry.blue * (1.0 - tint));
  return colour / colour.sum();
}

/// The least distance between the shares of two things, each in light from cool to warm.
double least_distance(const NamedColour& one, const NamedColour& other) {
  constexpr int kSteps = 10;
  const auto tint = [](const NamedColour& entry, int step) {
    return entry.tint * (2.0 * step / kSteps - 1.0);
  };
  double least = 2.0;
  for (int i = 0; i <= kSteps; ++i) {
    for (int j = 0; j <= kSteps; ++j) {
      const Eigen::Vector3d apart = shares_of(one, tint(one, i)) - shares_of(other, tint(other, j));
      least = std::min(least, apart.norm());
    }
  }
  return least;
}

}  // namespace

void NamedColour::validate() const {
  for (const auto& [field, value] : {std::pair{"red", red}, {"green", green}, {"blue", blue}}) {
    require(value >= 0.0 && value <= 255.0, std::string(field) + ": must lie in [0, 255]");
  }
  require(red + green + blue > 0.0, "red, green, blue: black has no colour to tell it by");
  require(tint >= 0.01 && tint <= 0.5, "tint: must lie in [0.01, 0.5]");
  require(dimmest >= 0.0 && dimmest <= 3.0, "dimmest: must lie in [0, 3]");
}

void ColourTableConfig::validate() const {
  validate_section("red_balloon", red_balloon);
  validate_section("green_balloon", green_balloon);
  require(tolerance >= 0.001 && tolerance <= 0.1, "tolerance: must lie in [0.001, 0.1]");
  require(grain >= 0.0 && grain <= 1.0, "grain: must lie in [0, 1]");
  require(dark >= 0.0 && dark <= 10.0, "dark: must lie in [0, 10]");
  require(mixed >= 0.0 && mixed <= 1.0, "mixed: must lie in [0, 1]");
  require(
      least_distance(red_balloon, green_balloon) > 2.0 * tolerance,
      "green_balloon: is too like red_balloon, by its shares of red, green and blue, to be told "
      "from it");
}

ColourTable::ColourTable(const ColourTableConfig& config) : config_(config) {
  config.validate();
  const std::array<const NamedColour*, kNames> entries = {&config.red_balloon,
                                                          &config.green_balloon};
  for (std::size_t i = 0; i < kNames; ++i) {
    const NamedColour& entry = *entries[i];
    lines_[i].start = shares_of(entry, -entry.tint);
    lines_[i].way = shares_of(entry, entry.tint) - lines_[i].start;
  }
}

double ColourTable::apart(const Eigen::Vector3d& colour, Name name) const noexcept {
  const double sum = colour.sum();
  if (!(sum > 0.0)) return 1.0;
  const Line& line = lines_[static_cast<std::size_t>(name)];
  const Eigen::Vector3d from = colour / sum - line.start;
  const double along = line.way.dot(from) / std::max(line.way.squaredNorm(), 1e-12);
  return (from - std::clamp(along, 0.0, 1.0) * line.way).norm();
}

Name ColourTable::look_up(const Eigen::Vector3d& colour, double most) const noexcept {
  if (!(colour.sum() > 0.0)) return Name::kNone;
  Name name = Name::kNone;
  for (const Name one : {Name::kRed, Name::kGreen}) {
    const double distance = apart(colour, one);
    if (distance > most) continue;
    most = distance;
    name = one;
  }
  return name;
}

Name ColourTable::name(const Eigen::Vector3d& colour, double pixels, double more) const noexcept {
  return look_up(colour, more + config_.tolerance + config_.grain / std::sqrt(pixels) +
                             config_.dark / std::max(colour.sum(), 1.0));
}

Name ColourTable::nearest(const Eigen::Vector3d& colour) const noexcept {
  return look_up(colour, config_.mixed);
}

double ColourTable::dimmest(Name name) const noexcept {
  return name == Name::kRed ? config_.red_balloon.dimmest : config_.green_balloon.dimmest;
}

}  // namespace pacer::exemplar
