// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_target.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "core/check.h"

namespace pacer {

std::vector<TrackingTarget> targets_of(const std::vector<dataset::Sequence>& sequences,
                                       const std::optional<Box>& box) {
  std::vector<TrackingTarget> targets;
  for (const dataset::Sequence& sequence : sequences) {
    if (box) {
      TrackingTarget target{.name = sequence.name, .sequence = sequence, .truth = {}, .box = *box};
      if (sequence.targets.size() == 1) target.truth = sequence.targets.front().boxes;
      targets.push_back(std::move(target));
      continue;
    }
    const std::size_t before = targets.size();
    for (const dataset::TargetTruth& truth : sequence.targets) {
      const auto start = std::ranges::find_if(
          truth.boxes, [](const std::optional<Box>& one) { return one && is_proper(*one); });
      if (start == truth.boxes.end()) continue;
      const std::string number = truth.name.empty() ? "" : "." + truth.name;
      targets.push_back({.name = sequence.name + number,
                         .sequence = sequence,
                         .truth = truth.boxes,
                         .first = static_cast<std::size_t>(start - truth.boxes.begin()),
                         .box = **start});
    }
    if (targets.size() == before) {
      throw UsageError(sequence.path.string() +
                       ": nothing says where the target is; give --box x,y,w,h, or --draw it");
    }
  }
  return targets;
}

Box parse_box(const std::string& text) {
  std::array<double, 4> numbers{};
  const char* at = text.data();
  const char* const end = at + text.size();
  for (double& number : numbers) {
    if (&number != numbers.data()) {
      if (at == end || *at != ',') break;
      ++at;
    }
    const auto [after, error] = std::from_chars(at, end, number);
    if (error != std::errc{}) break;
    at = after;
    if (&number == &numbers.back() && at == end) {
      const auto [left, top, width, height] = numbers;
      const Box box = Box::of_pixels(left - 1.0, top - 1.0, width, height);
      if (is_proper(box)) return box;
      throw std::invalid_argument(
          fmt::format("{}: a box has a finite place, and sides longer than nothing", text));
    }
  }
  throw std::invalid_argument(
      fmt::format("{}: want x,y,width,height in pixels, the top-left pixel being 1,1", text));
}

}  // namespace pacer
