// SPDX-License-Identifier: Apache-2.0
#include "runs/hierarchy_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include "learning/exemplar/generated_exemplars.h"

namespace pacer {
namespace {

using exemplar::Exemplars;

exemplar::Model model_of(Exemplars exemplars, ImageSize size = {.width = 320, .height = 240}) {
  return {.config = {},
          .image_size = size,
          .scenario = "",
          .fingerprint = "",
          .drift = Eigen::Matrix2d::Identity(),
          .hierarchy = exemplar::Hierarchy(std::move(exemplars), {})};
}

exemplar::Percept two_balloons() {
  exemplar::Percept percept{};
  const std::array<double, exemplar::kPerceptSize> values = {
      1200, 60, 100, 100, 0, 100, 180, 15, 17, 1200, 240, 180, 100, 0, 100, 24, 150, 39};
  std::ranges::copy(values, percept.begin());
  return percept;
}

/// The middle of the balloons of one colour in the columns [left, right) of the nodes' pictures,
/// which stand below the actions.
struct Patch {
  double x = 0.0, y = 0.0;
  int pixels = 0;
};
Patch patch_of(const Frame& picture, int channel, int left, int right) {
  constexpr int kBelowActions = 450;
  constexpr int kOver = 60;  // grey levels above the others
  Patch patch;
  for (int y = kBelowActions; y < picture.size.height; ++y) {
    for (int x = left; x < right; ++x) {
      const std::uint8_t* const rgb = &picture.rgb[3 * (std::size_t(y) * picture.size.width + x)];
      const int other = channel == 0 ? std::max(rgb[1], rgb[2]) : std::max(rgb[0], rgb[2]);
      if (rgb[channel] < other + kOver) continue;
      patch.x += x;
      patch.y += y;
      ++patch.pixels;
    }
  }
  if (patch.pixels > 0) {
    patch.x /= patch.pixels;
    patch.y /= patch.pixels;
  }
  return patch;
}

TEST(HierarchyPicture, ShowsTheBalloonsOfANodeWhereTheyWere) {
  const exemplar::Percept percept = two_balloons();
  const Frame picture =
      draw_hierarchy(model_of(Exemplars(exemplar::kPerceptSize, exemplar::kActionSize,
                                        {percept.begin(), percept.end()}, {0.4, 0.3})));
  const Patch red = patch_of(picture, 0, 0, picture.size.width);
  const Patch green = patch_of(picture, 1, 0, picture.size.width);
  ASSERT_GT(red.pixels, 50);
  ASSERT_GT(green.pixels, 50);
  // 180 pixels to the right and 80 down, in pictures that are drawn smaller.
  EXPECT_NEAR((green.y - red.y) / (green.x - red.x), 80.0 / 180.0, 0.05);
  EXPECT_GT(green.x, red.x + 30.0);
}

TEST(HierarchyPicture, ShowsTurnsToTheLeftAtTheLeft) {
  exemplar::Percept percept = two_balloons();
  std::vector<double> percepts(percept.begin(), percept.end());
  percept[1] = 250;  // the other one's red balloon is to the right
  percepts.insert(percepts.end(), percept.begin(), percept.end());
  const Frame picture = draw_hierarchy(model_of(
      Exemplars(exemplar::kPerceptSize, exemplar::kActionSize, percepts, {0.8, 0.3, -0.8, 0.3})));
  // Beside the root, which stands in the middle: a leaf at either side, green at the same place in
  // both, and red to the left of it in one only.
  const int width = picture.size.width;
  for (const auto& [left, side] : {std::pair(0, -1.0), {6 * width / 10, 1.0}}) {
    const Patch red = patch_of(picture, 0, left, left + 4 * width / 10);
    const Patch green = patch_of(picture, 1, left, left + 4 * width / 10);
    ASSERT_GT(red.pixels, 50) << left;
    ASSERT_GT(green.pixels, 50) << left;
    EXPECT_GT(side * (red.x - green.x), 0.0) << left;
  }
}

TEST(HierarchyPicture, ShowsNothingOfWhatLiesBeyondMeasure) {
  exemplar::Percept percept = two_balloons();
  percept[1] = 1e100;
  const Frame picture =
      draw_hierarchy(model_of(Exemplars(exemplar::kPerceptSize, exemplar::kActionSize,
                                        {percept.begin(), percept.end()}, {0.4, 0.3})));
  EXPECT_EQ(patch_of(picture, 0, 0, picture.size.width).pixels, 0);
  EXPECT_GT(patch_of(picture, 1, 0, picture.size.width).pixels, 50);
}

TEST(HierarchyPicture, DrawsNumbersOfAnyGreatness) {
  exemplar::GeneratedExemplars config;
  config.exemplars = 20;
  const Exemplars usual = exemplar::generate_exemplars(config, Random(1));
  for (const double greatness : {-1e100, -1e12, -1e5, -1.0, 0.0, 1e5, 1e12, 1e100}) {
    for (std::size_t which = 0; which < 9; ++which) {
      std::vector<double> percepts(usual.percepts().begin(), usual.percepts().end());
      std::vector<double> actions(usual.actions().begin(), usual.actions().end());
      for (std::size_t n = 0; n < usual.size(); n += 2) {
        percepts[n * exemplar::kPerceptSize + which] = greatness;
        actions[n * exemplar::kActionSize + which % 2] = greatness;
      }
      const Frame picture = draw_hierarchy(
          model_of(Exemplars(exemplar::kPerceptSize, exemplar::kActionSize, percepts, actions)));
      EXPECT_EQ(picture.size.width, 1280);
    }
  }
}

TEST(HierarchyPicture, IsOfPicturesAsWideAndAsHighAsModelsTake) {
  for (const ImageSize size :
       {ImageSize{.width = 1, .height = 16}, ImageSize{.width = 16384, .height = 1024},
        ImageSize{.width = 1024, .height = 16384}}) {
    const exemplar::Percept percept = two_balloons();
    const Frame picture =
        draw_hierarchy(model_of(Exemplars(exemplar::kPerceptSize, exemplar::kActionSize,
                                          {percept.begin(), percept.end()}, {0.4, 0.3}),
                                size));
    EXPECT_LT(picture.size.height, 16384);
  }
}

}  // namespace
}  // namespace pacer
