// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/exposure.h"
#include "sim/lens.h"

namespace pacer::sim {

/// Where a rendered picture becomes a photograph: lens, motion blur, gain and noise in one pass
/// over the pixels, in fixed-point arithmetic.
///
/// The pass goes by runs of five pixels of a row. Within a run all pixels are shifted alike (by a
/// lens's shift at its middle, right to a fifth of a pixel), so that one run is sixteen bytes of
/// plain vector arithmetic.
class Sensor {
 public:
  Sensor(const Lens& lens, double noise, const Random& random);

  /// `rendered` through Lens::rendered_focal(); `field` from MotionBlur. Fills `out`'s size and
  /// pixels. The mean of what passes each pixel, times `gain`, plus noise.
  void expose(const Frame& rendered, std::span<const Eigen::Vector2f> field, double gain,
              Frame& out);

 private:
  struct Source {  // of a run's first pixel, in what was rendered, 1/256 pixels
    std::int32_t x;
    std::int32_t y;
  };
  struct Sweep {  // what the motion of a tile asks for: 2^shift taps, each a step on, 1/256 pixels
    int shift;
    std::int32_t step_x;
    std::int32_t step_y;
  };

  std::span<const Sweep> sweep(std::span<const Eigen::Vector2f> field);

  ImageSize size_;
  SensorNoise noise_;
  std::vector<int> starts_;      // first column of each run of a row
  std::vector<Source> sources_;  // rows of runs
  std::vector<Sweep> sweeps_;    // of the frame under way, a tile each
};

}  // namespace pacer::sim
