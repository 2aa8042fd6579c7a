// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "core/units.h"

namespace pacer {

struct ImageSize {
  int width = 0;   ///< pixels
  int height = 0;  ///< pixels
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// One camera image: 8-bit RGB, top row first, rows packed without padding.
struct Frame {
  std::uint64_t index =
      0;           ///< 0 for the first frame of a run, then +1 each; a gap is a dropped frame
  Seconds time{};  ///< when the shutter closed, on the car's own clock
  ImageSize size;
  std::vector<std::uint8_t> rgb;  ///< size.height x size.width x 3
};

}  // namespace pacer
