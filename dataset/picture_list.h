// SPDX-License-Identifier: Apache-2.0
// Which pictures a folder holds.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pacer::dataset {

struct NumberedPicture {
  std::int64_t number = 0;  ///< as its name says
  std::filesystem::path path;
};

/// Whether a file's name ends as a picture's does.
[[nodiscard]] bool is_picture(const std::filesystem::path& file);

/// The pictures of a folder (jpg, png, bmp, ppm, pgm; any case), by number: those whose names are a
/// number or, where there are none, end in one behind the same letters ("frame0001.png"). None
/// where the folder does not exist. Throws std::runtime_error, naming the folder, when two have the
/// same number, or names begin differently, or there are too many.
[[nodiscard]] std::vector<NumberedPicture> list_pictures(const std::filesystem::path& folder);

/// Those whose names are `prefix`, digits, `suffix`. Throws likewise.
[[nodiscard]] std::vector<NumberedPicture> list_pictures(const std::filesystem::path& folder,
                                                         const std::string& prefix,
                                                         const std::string& suffix);

/// The kinds of pictures, for messages.
inline constexpr const char* kPictureKinds = "jpg, png, bmp, ppm or pgm";

}  // namespace pacer::dataset
