// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/configuration.h"

#include <algorithm>

#include "core/check.h"

namespace pacer::affordance {

static_assert(kMaxItems % 64 == 0 && kMaxItems >= kTiles * (100 + 10 + 10));

void GridConfig::validate() const {
  require(tile >= 0.5 && tile <= 20.0, "tile: must lie in [0.5, 20]");
}

void build_configuration(const LabelledFeatures& features, const ItemLayout& layout,
                         const GridConfig& grid, std::size_t centre,
                         Configuration& configuration) noexcept {
  const float side = static_cast<float>(grid.tile) * features.size[centre];
  const float reach = 1.5F * side;
  const float left = features.x[centre] - reach;
  const float top = features.y[centre] - reach;
  configuration.clear();
  configuration.centre = static_cast<std::uint32_t>(centre);
  configuration.tile_side = side;
  const auto first = std::lower_bound(features.x.begin(), features.x.end(), left);
  for (auto i = static_cast<std::size_t>(first - features.x.begin()); i < features.count(); ++i) {
    const float dx = features.x[i] - left;
    if (dx >= 3.0F * side) break;  // ascending by x: the rest lie further right
    const float dy = features.y[i] - top;
    if (dy < 0.0F || dy >= 3.0F * side || i == centre) continue;
    const int column = std::min(2, static_cast<int>(dx / side));
    const int row = std::min(2, static_cast<int>(dy / side));
    const int tile = 3 * row + column;
    const float distance = (dx - reach) * (dx - reach) + (dy - reach) * (dy - reach);
    const auto feature = static_cast<std::uint16_t>(i);
    configuration.set(layout.descriptor(tile, features.descriptor[i]), feature, distance);
    configuration.set(layout.scale(tile, features.scale[i]), feature, distance);
    configuration.set(layout.orientation(tile, features.orientation[i]), feature, distance);
  }
}

}  // namespace pacer::affordance
