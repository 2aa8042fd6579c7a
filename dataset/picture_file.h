// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <opencv2/core/mat.hpp>

namespace pacer::dataset {

/// Reads a JPEG, PNG, BMP or binary PNM as it is stored: 1, 3 (BGR) or 4 (BGRA) channels of 8 or 16
/// bits. The file is not trusted: a picture of more than 8192 x 8192 pixels, one that was cut short
/// and one of another kind is a std::runtime_error that names it. Keeps the memory of `picture`.
void read_picture(const std::filesystem::path& path, cv::Mat& picture);

}  // namespace pacer::dataset
