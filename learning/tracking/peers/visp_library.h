// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/types.hpp>

namespace cv {
class Mat;
}

namespace pacer::tracking {

/// ViSP's headers are no C++20, ours are no C++17: this one is both and stands between them.
class VispLibrary {
 public:
  VispLibrary();
  ~VispLibrary();
  VispLibrary(const VispLibrary&) = delete;
  VispLibrary& operator=(const VispLibrary&) = delete;

  /// Both throw vpException (a std::exception) where ViSP gives up.
  void start(const cv::Mat& grey, const cv::Rect& target);
  /// Where the target's centre is, and how much larger than at the start it is.
  void update(const cv::Mat& grey, cv::Point2d& centre, double& scale);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::tracking
