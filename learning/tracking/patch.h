// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace pacer::tracking {

/// Where a frame of reference lies in an image: image = centre + scale R(angle) frame.
struct Similarity {
  double x = 0.0;      ///< of the frame's origin, pixels
  double y = 0.0;      ///< of the frame's origin, pixels
  double scale = 1.0;  ///< image pixels a unit of the frame
  double angle = 0.0;  ///< radians, from x towards y

  /// The same frame with its origin where the point (u, v) of it is now.
  [[nodiscard]] Similarity moved(double u, double v) const;
};

/// A square of grey samples with a margin, float, row by row.
struct Patch {
  static constexpr int kMargin = 1;  ///< samples on each side, for gradients
  int side = 0;                      ///< samples, a multiple of 16, without the margin
  std::size_t stride = 0;            ///< floats a row
  std::vector<float> samples;        ///< (side + 2 kMargin) x stride

  explicit Patch(int side);
  /// Sample (0, 0), behind the margin; rows are `stride` apart.
  [[nodiscard]] const float* data() const { return samples.data() + kMargin * stride + kMargin; }
};

/// Copies of a part of an image, each half as wide and high as the one before, from which patches
/// are sampled: so that one sample stands for the pixels around it, at a cost that the target's
/// size hardly changes. Allocates only where an image's size is not the last one's.
class RegionPyramid {
 public:
  /// Takes the part of `image` that a patch of `side` samples at `pose` (pixels a sample) looks
  /// at, with `slack` (at least 1) times its width and height.
  void take(const cv::Mat1b& image, const Similarity& pose, int side, double slack);

  /// What was taken is no longer of use: covers() is false.
  void forget() { region_ = {}; }

  /// Samples, bilinearly, the square around `pose`; outside the image its border is repeated.
  /// What is not covered() is sampled as if the part that was taken were the image.
  void sample(const Similarity& pose, Patch& patch) const;

  /// Would sample() find all it needs, at a scale that what was taken is good for?
  [[nodiscard]] bool covers(const Similarity& pose, int side) const;

 private:
  /// Makes room for every level of an image of this size.
  void make_room(const cv::Mat1b& image);

  cv::Size size_;       // of the image
  cv::Rect region_;     // of the image; its corner is at multiples of the last level's pixel
  int level_ = 0;       // halvings; 0: patches are sampled from the image's own pixels
  double scale_ = 1.0;  // of the pose it was taken for
  std::vector<std::vector<std::uint8_t>> halved_;  // all levels but the first and the last
  // The last level: each pixel with the one below it, two bytes, so that four bytes hold all that
  // lies around a sample; a column more than there are repeats the border.
  std::vector<std::uint8_t> pairs_;
  int width_ = 0, height_ = 0;  // of the last level
};

}  // namespace pacer::tracking
