// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "core/random.h"
#include "sim/texture.h"

namespace pacer::sim {

/// A print, painted in metres from its top-left corner, so that what is printed has the same size
/// on whatever it goes on: a vehicle's side, a coat, a board.
class Panel {
 public:
  using Colour = texture::Colour;

  static const Colour kGlass, kWhite, kBlack;

  /// `width` x `height` metres, painted all over.
  Panel(double width, double height, const Colour& paint);

  void fill(double x, double y, double width, double height, const Colour& colour);
  void disc(double x, double y, double radius, const Colour& colour);
  /// A slanted bar: its top edge lies `lean` to the right of its bottom edge.
  void slash(double x, double y, double width, double height, double lean, const Colour& colour);
  void text(double x, double y, double width, double height, const std::string& words,
            const Colour& ink);
  void checker(double x, double y, int columns, int rows, double side, const Colour& even,
               const Colour& odd);
  /// A sponsors' corner: little marks, no two alike.
  void marks(double x, double y, int columns, int rows, double side, Random random);

  [[nodiscard]] const cv::Mat& picture() const { return picture_; }

 private:
  cv::Mat picture_;
};

}  // namespace pacer::sim
