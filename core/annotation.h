// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/frame.h"

namespace pacer {

/// What a mark means; sinks choose its colour.
enum class Tone : std::uint8_t { kNeutral, kMatched, kTarget, kIgnored };

/// A position in the frame, pixels: x right, y down, (0, 0) the centre of the top-left pixel.
struct PixelPoint {
  float x = 0.0F;
  float y = 0.0F;
};

struct PointMark {
  PixelPoint at;
  float radius = 0.0F;  ///< pixels
  Tone tone = Tone::kNeutral;
};
struct LineMark {
  PixelPoint from, to;
  Tone tone = Tone::kNeutral;
};
struct BoxMark {
  PixelPoint low, high;  ///< top-left and bottom-right corners
  Tone tone = Tone::kNeutral;
};

/// A small grey picture, e.g. an appearance that a tracker remembers; sinks show them in a row.
struct PatchMark {
  ImageSize size;
  std::vector<std::uint8_t> grey;  ///< size.height x size.width, top row first
  Tone tone = Tone::kNeutral;
};

/// What a policy saw and matched in one frame. Sinks draw it; nothing reads it back.
struct Annotations {
  std::vector<PointMark> points;
  std::vector<LineMark> lines;
  std::vector<BoxMark> boxes;
  std::vector<PatchMark> patches;
  std::string label;  ///< one line, e.g. "fast-left, 12 rules"

  /// Empties it, keeping the memory.
  void clear() {
    points.clear();
    lines.clear();
    boxes.clear();
    patches.clear();
    label.clear();
  }
};

}  // namespace pacer
