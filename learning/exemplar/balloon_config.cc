// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/balloon_config.h"

#include "core/check.h"

namespace pacer::exemplar {

void BalloonConfig::validate() const {
  require(spread >= 0.0 && spread <= 1.0, "spread: must lie in [0, 1]");
  require(noise >= 0.0 && noise <= 50.0, "noise: must lie in [0, 50]");
  require(reach >= 1.0, "reach: must be at least 1");
  require(least_part >= 1, "least_part_px: must be at least 1");
  require(least_area >= 1.0, "least_area_px: must be at least 1");
  require(least_fill >= 0.0 && least_fill <= 1.0, "least_fill: must lie in [0, 1]");
  require(joint_fill >= 0.0 && joint_fill <= 1.0, "joint_fill: must lie in [0, 1]");
  require(longest >= 1.0, "longest: must be at least 1");
  require(shading >= -2.0 && shading <= 2.0, "shading: must lie in [-2, 2]");
  require(tiny_area >= 0.0, "tiny_area_px: must not be negative");
  require(tiny_shading >= -2.0 && tiny_shading <= 2.0, "tiny_shading: must lie in [-2, 2]");
  require(behind_shading >= -2.0 && behind_shading <= 2.0, "behind_shading: must lie in [-2, 2]");
  require(snow_shading >= -2.0 && snow_shading <= 2.0, "snow_shading: must lie in [-2, 2]");
  require(small_area >= 0.0, "small_area_px: must not be negative");
  require(small_fill >= 0.0 && small_fill <= 1.0, "small_fill: must lie in [0, 1]");
  require(least_behind >= 1.0, "least_behind_px: must be at least 1");
  require(rim >= 1.0, "rim: must be at least 1");
  require(lowest >= 0.0 && lowest <= 1.0, "lowest: must lie in [0, 1]");
  require(stained >= 0.0 && stained <= 1.0, "stained: must lie in [0, 1]");
  require(wide_shading >= -2.0 && wide_shading <= 2.0, "wide_shading: must lie in [-2, 2]");
  require(side_shading >= -2.0 && side_shading <= 2.0, "side_shading: must lie in [-2, 2]");
  require(small_step >= 0.0 && small_step <= 1.0, "small_step: must lie in [0, 1]");
  require(clear >= 0.0 && clear <= 2.0, "clear: must lie in [0, 2]");
  require(side_clear >= 0.0 && side_clear <= 2.0, "side_clear: must lie in [0, 2]");
  require(horizon >= 0.0 && horizon <= 1.0, "horizon: must lie in [0, 1]");
  require(highest >= 0.0, "highest: must not be negative");
  require(gap >= 0.0 && gap < 1.0, "gap: must lie in [0, 1)");
  require(interference > 0.0, "interference: must be positive");
}

}  // namespace pacer::exemplar
