// SPDX-License-Identifier: Apache-2.0
// Private to the module: what a picture's file says of itself, before anything is decoded.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace pacer::dataset {

/// The decoders ask for memory by the size that a file claims, and pass over an end that is
/// missing: both are looked at first.
struct PictureHeader {
  std::int64_t width = 0;   ///< pixels
  std::int64_t height = 0;  ///< pixels
  bool whole = false;       ///< as long as its parts say, and as their checksums say
};

/// Of a PNG, JPEG, BMP or binary PNM; none where `bytes` is no such file, or ends in its header.
[[nodiscard]] std::optional<PictureHeader> read_picture_header(std::string_view bytes);

}  // namespace pacer::dataset
