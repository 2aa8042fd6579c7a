// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/marks.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pacer::tracking {

void mark_predictor(const Eigen::Vector2d& at, double radius, Tone tone, Annotations& annotations) {
  annotations.points.push_back(
      {.at = {.x = static_cast<float>(at.x()), .y = static_cast<float>(at.y())},
       .radius = static_cast<float>(radius),
       .tone = tone});
}

void mark_aspects(const Smat& aspects, int matched, const TemplateGrid& grid,
                  Annotations& annotations) {
  std::vector<int> order(static_cast<std::size_t>(aspects.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](int component) { return aspects.weight(component); });
  for (const int component : order) {
    annotations.patches.push_back(grid.patch(
        aspects.median(component), component == matched ? Tone::kMatched : Tone::kNeutral));
  }
}

void mark_aspects(const Medoidshift& clusters, std::size_t newest, const TemplateGrid& grid,
                  std::span<const std::uint8_t> templates, Annotations& annotations) {
  constexpr std::size_t kMost = 6;  // there can be as many as templates
  const std::span<const std::size_t> modes = clusters.modes();
  const std::size_t matched = modes[newest];
  std::vector<std::size_t> sizes(modes.size());
  for (const std::size_t mode : modes) ++sizes[mode];
  std::vector<std::size_t> order(modes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t point) { return sizes[point] == 0; });
  std::ranges::stable_sort(order, std::ranges::greater{},
                           [&](std::size_t mode) { return sizes[mode]; });
  if (order.size() > kMost) {
    order.resize(kMost);
    if (std::ranges::find(order, matched) == order.end()) order.back() = matched;
  }
  for (const std::size_t mode : order) {
    const auto values = templates.subspan(mode * grid.length(), grid.length());
    annotations.patches.push_back(
        grid.patch(values, mode == matched ? Tone::kMatched : Tone::kNeutral));
  }
}

}  // namespace pacer::tracking
