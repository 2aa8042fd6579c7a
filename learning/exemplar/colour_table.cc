// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/colour_table.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>

#include "core/check.h"

namespace pacer::exemplar {
namespace {

void validate_entry(const char* field, const NamedColour& entry) {
  try {
    entry.validate();
  } catch (const std::invalid_argument& error) {
    throw std::invalid_argument(std::string(field) + "." + error.what());
  }
}

/// Only once the config is validated are they numbers.
Eigen::Vector3d shares_of(const NamedColour& entry) {
  const Eigen::Vector3d colour(entry.red, entry.green, entry.blue);
  return colour / colour.sum();
}

}  // namespace

void NamedColour::validate() const {
  for (const auto& [field, value] : {std::pair{"red", red}, {"green", green}, {"blue", blue}}) {
    require(value >= 0.0 && value <= 1e6, std::string(field) + ": must lie in [0, 1e6]");
  }
  require(red + green + blue > 0.0, "red, green, blue: black has no colour to tell it by");
  require(tolerance >= 0.0 && tolerance <= 1.0, "tolerance: must lie in [0, 1]");
  require(hue >= 0.0 && hue <= 1.0, "hue: must lie in [0, 1]");
  require(dimmest >= 0.0 && dimmest <= 3.0, "dimmest: must lie in [0, 3]");
}

void ColourTableConfig::validate() const {
  validate_entry("red_balloon", red_balloon);
  validate_entry("green_balloon", green_balloon);
  require(mixed >= 0.0 && mixed <= 1.0, "mixed: must lie in [0, 1]");
}

ColourTable::ColourTable(const ColourTableConfig& config)
    : shares_{shares_of(config.red_balloon), shares_of(config.green_balloon)},
      dimmest_{config.red_balloon.dimmest, config.green_balloon.dimmest} {
  config.validate();
  const std::array<const NamedColour*, kNames> entries = {&config.red_balloon,
                                                          &config.green_balloon};
  for (int r = 0; r < kSteps; ++r) {
    for (int g = 0; g < kSteps; ++g) {
      const double red = (r + 0.5) / kSteps, green = (g + 0.5) / kSteps;
      const Eigen::Vector3d here(red, green, 1.0 - red - green);
      const auto at = static_cast<std::size_t>(r * kSteps + g);
      names_[at] = nearest_[at] = Name::kNone;
      double least = 2.0;  // farther than any two colours are
      for (std::size_t i = 0; i < kNames; ++i) {
        const double apart = (here - shares_[i]).norm();
        if (apart >= least) continue;
        least = apart;
        const Eigen::Vector3d to_white = Eigen::Vector3d::Constant(1.0 / 3.0) - shares_[i];
        const double across = (here - shares_[i]).cross(to_white.normalized()).norm();
        const bool within = apart <= entries[i]->tolerance && across <= entries[i]->hue;
        names_[at] = within ? static_cast<Name>(i) : Name::kNone;
        nearest_[at] = apart <= config.mixed ? static_cast<Name>(i) : Name::kNone;
      }
    }
  }
}

Name ColourTable::look_up(const Table& table, const Eigen::Vector3d& colour) noexcept {
  const double sum = colour.sum();
  if (!(sum > 0.0)) return Name::kNone;
  const auto step = [&](double channel) {
    return std::clamp(static_cast<int>(channel / sum * kSteps), 0, kSteps - 1);
  };
  return table[static_cast<std::size_t>(step(colour.x()) * kSteps + step(colour.y()))];
}

}  // namespace pacer::exemplar
