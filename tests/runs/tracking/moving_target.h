// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

#include "core/frame.h"
#include "dataset/sequence.h"

namespace pacer::testing {

constexpr ImageSize kPictureSize{64, 48};

/// Where the moving target is in picture `at`: two pixels a picture to the right, and back.
inline Box moving_target(std::size_t at) {
  const std::size_t there = at % 40;
  const double x = 2.0 * static_cast<double>(there < 20 ? there : 40 - there);
  return Box::of_pixels(4.0 + x, 20.0, 12.0, 10.0);
}

/// A bright box on grey, at moving_target(at).
inline Frame moving_frame(std::size_t at) {
  Frame frame{.index = at, .time = {}, .size = kPictureSize, .rgb = {}};
  const Box box = moving_target(at);
  for (int y = 0; y < kPictureSize.height; ++y) {
    for (int x = 0; x < kPictureSize.width; ++x) {
      const bool in = x >= box.left() && x < box.left() + box.width && y >= box.top() &&
                      y < box.top() + box.height;
      frame.rgb.insert(frame.rgb.end(), 3, in ? std::uint8_t{220} : std::uint8_t{90});
    }
  }
  return frame;
}

/// Writes `pictures` of them to `folder`, in OTB's layout, annotated from picture `first` on.
inline dataset::Sequence write_moving(const std::filesystem::path& folder, std::size_t pictures,
                                      std::size_t first = 0) {
  dataset::SequenceWriter writer(folder);
  for (std::size_t at = 0; at < pictures; ++at) {
    writer.write(moving_frame(at), at < first ? std::nullopt : std::optional(moving_target(at)));
  }
  writer.close();
  return dataset::Sequence::open(folder);
}

}  // namespace pacer::testing
