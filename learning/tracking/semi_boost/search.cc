// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/search.h"

#include <algorithm>

namespace pacer::tracking {
namespace {

cv::Point step_of(const cv::Size& size) {
  return {std::max(1, (size.width + 50) / 100), std::max(1, (size.height + 50) / 100)};
}

/// Steps across and down.
cv::Size grid_of(const cv::Size& region, const cv::Size& size) {
  const cv::Point step = step_of(size);
  return {(region.width - size.width) / step.x + 1, (region.height - size.height) / step.y + 1};
}

}  // namespace

cv::Rect twice(const cv::Rect& patch) {
  return {patch.x - patch.width / 2, patch.y - patch.height / 2, 2 * patch.width, 2 * patch.height};
}

std::array<cv::Point, 4> corners(const cv::Rect& region, const cv::Size& size) {
  const cv::Point last = region.br() - cv::Point(size);
  return {region.tl(), cv::Point(last.x, region.y), cv::Point(region.x, last.y), last};
}

void PatchSearch::reserve(const cv::Size& region, const cv::Size& size) {
  const auto places = static_cast<std::size_t>(grid_of(region, size).area());
  margins_.reserve(places);
  smooth_.reserve(places);
}

Found PatchSearch::best(const StrongClassifier& classifier, const IntegralImage& image,
                        const cv::Rect& region, const cv::Size& size) {
  const cv::Point step = step_of(size);
  const cv::Size grid = grid_of(region.size(), size);
  const int columns = grid.width;
  const int rows = grid.height;
  const auto place = [&](int row, int column) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  };
  margins_.resize(place(rows, 0));
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      margins_[place(row, column)] = classifier.margin(
          {.image = &image, .left = region.x + column * step.x, .top = region.y + row * step.y});
    }
  }
  // A binomial of three, across and then down; the edge repeats.
  smooth_.resize(margins_.size());
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      smooth_[place(row, column)] = 0.25F * margins_[place(row, std::max(0, column - 1))] +
                                    0.5F * margins_[place(row, column)] +
                                    0.25F * margins_[place(row, std::min(columns - 1, column + 1))];
    }
  }
  Found found;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const float margin = 0.25F * smooth_[place(std::max(0, row - 1), column)] +
                           0.5F * smooth_[place(row, column)] +
                           0.25F * smooth_[place(std::min(rows - 1, row + 1), column)];
      if (margin > found.margin) {
        found = {.at = {region.x + column * step.x, region.y + row * step.y}, .margin = margin};
      }
    }
  }
  return found;
}

}  // namespace pacer::tracking
