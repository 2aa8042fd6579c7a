// SPDX-License-Identifier: Apache-2.0
#include "runs/report/palette.h"

#include <algorithm>
#include <array>
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
    entries_.push_back({.name = name, .colour = kColours[next++ % kColours.size()]});
  }
}

std::string_view Palette::colour(std::string_view name) const noexcept {
  for (const Entry& entry : entries_) {
    if (entry.name == name) return entry.colour;
  }
  const std::string_view fixed = reserved(name);
  return fixed.empty() ? kGrey : fixed;
}

}  // namespace pacer::report
