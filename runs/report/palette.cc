// SPDX-License-Identifier: Apache-2.0
#include "runs/report/palette.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace pacer::report {
namespace {

constexpr std::string_view kGrey = "#9AA0A6";
constexpr std::array<std::string_view, 9> kColours = {"#4477AA", "#EE6677", "#66CCEE",
                                                      "#CCBB44", "#EE7733", "#009988",
                                                      "#8866CC", "#8C6D31", "#DD55AA"};

std::string_view reserved(std::string_view name) {
  if (name == "teacher") return "#228833";
  if (name == "mean") return "#AA3377";
  if (name == "neutral") return kGrey;
  return {};
}

}  // namespace

Palette::Palette(std::span<const std::string> names) {
  std::size_t next = 0;
  for (const std::string& name : names) {
    const bool known = std::any_of(entries_.begin(), entries_.end(),
                                   [&name](const Entry& entry) { return entry.name == name; });
    if (known || !reserved(name).empty()) continue;
    entries_.push_back({.name = name, .colour = std::string(kColours[next++ % kColours.size()])});
  }
}

Palette Palette::graded(std::span<const std::string> names) {
  // Tol's "sunset" without its light middle.
  static constexpr std::array<std::array<double, 3>, 4> kStops = {
      {{54, 75, 154}, {110, 166, 205}, {246, 126, 75}, {165, 0, 38}}};
  Palette palette;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const double at = names.size() == 1 ? 0.0
                                        : static_cast<double>((kStops.size() - 1) * i) /
                                              static_cast<double>(names.size() - 1);
    const std::size_t stop = std::min(static_cast<std::size_t>(at), kStops.size() - 2);
    const double share = at - static_cast<double>(stop);
    std::array<int, 3> rgb{};
    for (std::size_t c = 0; c < rgb.size(); ++c) {
      rgb[c] = static_cast<int>(
          std::lround((1.0 - share) * kStops[stop][c] + share * kStops[stop + 1][c]));
    }
    palette.entries_.push_back(
        {.name = names[i], .colour = fmt::format("#{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2])});
  }
  return palette;
}

std::string_view Palette::colour(std::string_view name) const noexcept {
  for (const Entry& entry : entries_) {
    if (entry.name == name) return entry.colour;
  }
  const std::string_view fixed = reserved(name);
  return fixed.empty() ? kGrey : fixed;
}

}  // namespace pacer::report
