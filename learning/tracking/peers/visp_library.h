// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>

namespace pacer::tracking {

/// ViSP's headers are no C++20, ours are no C++17: this one is both and stands between them.
class VispLibrary {
 public:
  VispLibrary();
  ~VispLibrary();
  VispLibrary(const VispLibrary&) = delete;
  VispLibrary& operator=(const VispLibrary&) = delete;

  // Both throw vpException (a std::exception) where ViSP gives up.
  void start(const cv::Mat1b& grey, const cv::Rect& target);
  /// By how much the target has moved since the start.
  [[nodiscard]] cv::Point2d update(const cv::Mat1b& grey);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace pacer::tracking
