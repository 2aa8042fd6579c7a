// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "studies/study.h"

namespace pacer {

/// The pictures that displacement estimators are tried on.
struct TestPictures {
  static constexpr std::size_t kMost = 20;
  static constexpr int kLongestSide = 1024;  ///< pixels; larger pictures are reduced to it
  static constexpr int kShortestSide = 100;  ///< pixels; a smaller picture is refused

  std::vector<cv::Mat1b> grey;
  std::vector<std::string> names;  ///< of each: its file's, or its room's
  std::string about;               ///< one sentence: which they are
};

/// kMost of the pictures in `folder` and the folders in it, evenly chosen from their sorted paths,
/// or all where there are fewer. Throws UsageError when there is no such folder or no picture in
/// it, and std::runtime_error, naming the file, for one that cannot be read or is too small.
[[nodiscard]] TestPictures read_test_pictures(const std::filesystem::path& folder);

/// Those of `--images` or, where it is not given, one frame of each of kMost rooms, kept in the
/// cache.
[[nodiscard]] TestPictures test_pictures(const StudyContext& context);

/// A section of `page` that says which they are, and shows them.
void show(const TestPictures& pictures, report::Page& page);

}  // namespace pacer
