// SPDX-License-Identifier: Apache-2.0
// Sequences on disk, made up for a test.
#pragma once

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tests/support/scratch.h"

namespace pacer::dataset::testing {

using pacer::testing::Scratch;

inline void write_file(const std::filesystem::path& path, const std::string& bytes) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream(path, std::ios::binary) << bytes;
}

/// A smooth picture, encoded.
inline std::string encoded_picture(const std::string& extension, int width = 24, int height = 16,
                                   int type = CV_8UC3) {
  cv::Mat picture(height, width, type);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const cv::Scalar colour(4.0 * x, 100.0, 6.0 * y, 255.0);
      picture(cv::Rect(x, y, 1, 1)).setTo(colour);
    }
  }
  std::vector<std::uint8_t> bytes;
  cv::imencode(extension, picture, bytes);
  return {bytes.begin(), bytes.end()};
}

/// Pictures numbered from `first`, as `pattern` (of fmt) has it: "img/{:04d}.jpg".
inline void write_pictures(const std::filesystem::path& folder, const std::string& pattern,
                           int count, int first = 1) {
  const std::string bytes = encoded_picture(std::filesystem::path(pattern).extension().string());
  for (int i = first; i < first + count; ++i) {
    write_file(folder / fmt::format(fmt::runtime(pattern), i), bytes);
  }
}

/// `count` lines "i,i,10,20", i from 1.
inline std::string lines_of_boxes(int count) {
  std::string text;
  for (int i = 1; i <= count; ++i) text += fmt::format("{0},{0},10,20\n", i);
  return text;
}

/// What `run` says is wrong; "" when it is content.
inline std::string complaint(const std::function<void()>& run) {
  try {
    run();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

}  // namespace pacer::dataset::testing
