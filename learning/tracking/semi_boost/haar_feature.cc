// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/haar_feature.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace pacer::tracking {
namespace {

/// The kinds, as cells of equal size: how many across and down, and which rectangles of them weigh
/// how much per cell.
struct Kind {
  int across, down;
  struct Cells {
    int x, y, width, height;
    float weight;
  };
  std::array<Cells, 4> cells;
  int count;
};
constexpr std::array<Kind, 6> kKinds{{
    {2, 1, {{{0, 0, 1, 1, 1.0F}, {1, 0, 1, 1, -1.0F}}}, 2},
    {1, 2, {{{0, 0, 1, 1, 1.0F}, {0, 1, 1, 1, -1.0F}}}, 2},
    {3, 1, {{{0, 0, 1, 1, 0.5F}, {1, 0, 1, 1, -1.0F}, {2, 0, 1, 1, 0.5F}}}, 3},
    {1, 3, {{{0, 0, 1, 1, 0.5F}, {0, 1, 1, 1, -1.0F}, {0, 2, 1, 1, 0.5F}}}, 3},
    {2, 2, {{{0, 0, 1, 1, 0.5F}, {1, 0, 1, 1, -0.5F}, {0, 1, 1, 1, -0.5F}, {1, 1, 1, 1, 0.5F}}}, 4},
    {3, 3, {{{0, 0, 3, 3, 0.125F}, {1, 1, 1, 1, -1.125F}}}, 2},
}};

/// In [1, largest], small ones more often.
int extent(int largest, Random& random) {
  const double skewed = 1.0 - std::sqrt(1.0 - random.uniform(0.0, 1.0));
  return 1 + static_cast<int>(skewed * largest);
}

}  // namespace

void IntegralImage::set(const cv::Mat1b& grey) { cv::integral(grey, sums_, CV_32S); }

HaarFeature random_haar_feature(ImageSize size, Random& random) {
  check(size.width * size.height >= 2, "a patch of two pixels or more has Haar-like features");
  const Kind* kind = nullptr;
  do {
    kind = &kKinds[random.below(kKinds.size())];
  } while (kind->across > size.width || kind->down > size.height);
  const int width = extent(size.width / kind->across, random);
  const int height = extent(size.height / kind->down, random);
  const auto place = [&](int room) {
    return static_cast<int>(random.below(static_cast<std::uint64_t>(room) + 1));
  };
  const int left = place(size.width - kind->across * width);
  const int top = place(size.height - kind->down * height);

  HaarFeature feature;
  feature.count = kind->count;
  for (int i = 0; i < kind->count; ++i) {
    const Kind::Cells& cells = kind->cells[static_cast<std::size_t>(i)];
    feature.parts[static_cast<std::size_t>(i)] = {
        .x = left + cells.x * width,
        .y = top + cells.y * height,
        .width = cells.width * width,
        .height = cells.height * height,
        .weight = cells.weight / static_cast<float>(width * height)};
  }
  return feature;
}

}  // namespace pacer::tracking
