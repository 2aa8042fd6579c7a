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

std::array<int, 3> colour_at(const Frame& frame, int x, int y) {
  const std::size_t at = 3 * (static_cast<std::size_t>(y) * frame.size.width + x);
  return {frame.rgb[at], frame.rgb[at + 1], frame.rgb[at + 2]};
}

TEST(HierarchyPicture, ShowsTheBalloonsOfEachNodeWhereTheyWere) {
  const exemplar::Percept percept = two_balloons();
  const Frame picture =
      draw_hierarchy(model_of(Exemplars(exemplar::kPerceptSize, exemplar::kActionSize,
                                        {percept.begin(), percept.end()}, {0.4, 0.3})));
  // The root's picture: 147 pixels wide, in the middle, below the actions.
  const double scale = 147.0 / 320.0;
  const int left = 640 - 73;
  const int top = 400;
  const auto at = [&](double x, double y) {
    return colour_at(picture, left + static_cast<int>(scale * x),
                     top + static_cast<int>(scale * y));
  };
  EXPECT_GT(at(60, 100)[0], 180);
  EXPECT_LT(at(60, 100)[1], 100);
  EXPECT_GT(at(240, 180)[1], 150);
  EXPECT_LT(at(240, 180)[0], 120);
  EXPECT_LT(at(160, 60)[0], 60) << "and nothing elsewhere";
}

TEST(HierarchyPicture, ShowsTwoExemplarsAsTwoNodesBelowTheRoot) {
  exemplar::Percept percept = two_balloons();
  std::vector<double> percepts(percept.begin(), percept.end());
  percept[1] = 250;  // the other one's red balloon is to the right
  percepts.insert(percepts.end(), percept.begin(), percept.end());
  const Frame picture = draw_hierarchy(model_of(
      Exemplars(exemplar::kPerceptSize, exemplar::kActionSize, percepts, {0.8, 0.3, -0.8, 0.3})));
  const double scale = 147.0 / 320.0;
  const int top = 400 + 110 + 34 + 26;
  for (const auto& [middle, x] : {std::pair(16 + 312, 60.0), {16 + 936, 250.0}}) {
    const auto colour = colour_at(picture, middle - 73 + static_cast<int>(scale * x),
                                  top + static_cast<int>(scale * 100.0));
    EXPECT_GT(colour[0], 120) << "the turn to the left is to the left";
    EXPECT_LT(colour[1], 100);
  }
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
