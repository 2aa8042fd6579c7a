// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/frame.h"

namespace pacer::report {

/// `frame` as a PNG file: exact. Throws std::invalid_argument for a frame whose bytes do not fit
/// its size.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Frame& frame);

/// `frame` as a JPEG file of `quality` in [1, 100]: a tenth of the size.
[[nodiscard]] std::vector<std::uint8_t> encode_jpeg(const Frame& frame, int quality = 88);

/// One picture of a contact sheet.
struct Tiled {
  Frame frame;
  std::string caption = {};  ///< one line; cut where it is too long
};

/// `pictures` row by row in `columns` columns, each fitted into a tile of `tile` pixels with its
/// caption below. Throws std::invalid_argument without pictures or for more than 10,000.
[[nodiscard]] Frame contact_sheet(std::span<const Tiled> pictures, int columns,
                                  ImageSize tile = {320, 240});

}  // namespace pacer::report
