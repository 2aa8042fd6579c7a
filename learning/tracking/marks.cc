// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/marks.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace pacer::tracking {
namespace {

PixelPoint reference_point(const FlockMember& member, const Eigen::Vector2d& origin) {
  const Eigen::Vector2f at = (origin + member.offset).cast<float>();
  return {.x = at.x(), .y = at.y()};
}

}  // namespace

void mark(const FlockMember& member, const Eigen::Vector2d& origin, Tone tone,
          Annotations& annotations) {
  annotations.points.push_back(
      {.at = reference_point(member, origin), .radius = 0.0F, .tone = tone});
}

void mark_range(const FlockMember& member, const Eigen::Vector2d& origin, double support_range,
                Tone tone, Annotations& annotations) {
  annotations.points.push_back({.at = reference_point(member, origin),
                                .radius = static_cast<float>(support_range),
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

}  // namespace pacer::tracking
