// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/tracker.h"

#include <fmt/format.h>

#include <stdexcept>

namespace pacer::tracking {
namespace {

constexpr double kLongest = 1e8;  // side, pixels: sums of them are still good to a fraction of one

}  // namespace

void Tracker::start(const Picture& picture, const Box& target) {
  const ImageSize size{picture.grey.cols, picture.grey.rows};
  const Box whole = Box::of_pixels(0.0, 0.0, size.width, size.height);
  if (!is_proper(target) || target.width < 1.0 || target.height < 1.0 || target.width > kLongest ||
      target.height > kLongest || overlap(target, whole) <= 0.0) {
    throw std::invalid_argument(fmt::format(
        "a box of {:g} x {:g} pixels about ({:g}, {:g}) has nothing to track in a picture of "
        "{} x {}: choose one that lies in it, a pixel or more across",
        target.width, target.height, target.x, target.y, size.width, size.height));
  }
  begin(picture, target);
  size_ = size;
}

Track Tracker::update(const Picture& picture) {
  if (size_ == ImageSize{}) throw std::logic_error("a tracker was updated before it was started");
  const ImageSize size{picture.grey.cols, picture.grey.rows};
  if (size != size_) {
    throw std::invalid_argument(
        fmt::format("the picture is {} x {} pixels, the first was {} x {}: start again", size.width,
                    size.height, size_.width, size_.height));
  }
  return follow(picture);
}

void Tracker::annotate(Annotations& /*annotations*/) const {}

}  // namespace pacer::tracking
