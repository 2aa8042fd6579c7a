// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/marks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "learning/tracking/motion.h"

namespace pacer::tracking {
namespace {

using ::testing::ElementsAre;

/// Templates of a single pixel, its value their place on a line.
struct Line {
  TemplateGrid grid{1.0, 1.0, 4};
  std::vector<std::uint8_t> templates;
  Medoidshift clusters{{.fewest = 2}};

  void add(int value) {
    std::vector<double> distances;
    for (std::size_t at = 0; at < templates.size(); at += grid.length()) {
      distances.push_back(std::abs(100.0 * (templates[at] - value)));
    }
    distances.push_back(0.0);
    clusters.add(distances);
    templates.resize(templates.size() + grid.length());
    templates[templates.size() - grid.length()] = static_cast<std::uint8_t>(value);
  }
  [[nodiscard]] Annotations shown() const {
    Annotations annotations;
    mark_aspects(clusters, clusters.size() - 1, grid, templates, annotations);
    return annotations;
  }
};

std::vector<int> values(const Annotations& annotations) {
  std::vector<int> all;
  for (const PatchMark& patch : annotations.patches) all.push_back(patch.grey[0]);
  return all;
}

TEST(Marks, ShowTheLargestAspectFirst) {
  Line line;
  for (const int value : {0, 1, 100, 100, 100, 200, 200, 200, 200}) line.add(value);
  EXPECT_THAT(values(line.shown()).front(), 200);
  EXPECT_EQ(line.shown().patches.front().tone, Tone::kMatched);
}

TEST(Marks, ShowTheMatchedAspectHoweverSmall) {
  Line line;
  for (const int value : {0, 1}) line.add(value);
  for (int group = 1; group < 10; ++group) {
    line.add(20 * group);
    line.add(20 * group);
  }
  line.add(255);
  const Annotations shown = line.shown();
  EXPECT_EQ(shown.patches.size(), 6U);
  EXPECT_EQ(values(shown).back(), 255);
  EXPECT_EQ(shown.patches.back().tone, Tone::kMatched);
  EXPECT_EQ(shown.patches.front().tone, Tone::kNeutral);
}

TEST(Marks, ShowComponentsByTheirWeight) {
  const TemplateGrid grid(4.0, 4.0, 16);
  Smat aspects({}, grid.length());
  const auto sample = [&](int value) {
    return std::vector<std::uint8_t>(grid.length(), static_cast<std::uint8_t>(value));
  };
  aspects.start(sample(50));
  aspects.add(sample(52));
  aspects.add(sample(200));
  Annotations annotations;
  mark_aspects(aspects, 1, grid, annotations);
  EXPECT_THAT(values(annotations), ElementsAre(50, 52));
  EXPECT_EQ(annotations.patches[0].tone, Tone::kNeutral);
  EXPECT_EQ(annotations.patches[1].tone, Tone::kMatched);
}

TEST(Targets, GoNoFartherThanWhereTheyTouchThePicture) {
  const cv::Mat1b image(100, 200, std::uint8_t{0});
  const Box box{.x = 50, .y = 50, .width = 20, .height = 10};
  EXPECT_EQ(placed(box, {60.5, 40.25}, image), (Box{60.5, 40.25, 20, 10}));
  EXPECT_EQ(placed(box, {-1e9, 1e9}, image), (Box{-10, 104, 20, 10}));
  EXPECT_EQ(placed(box, {1e9, -1e9}, image), (Box{209, -5, 20, 10}));
}

TEST(Targets, HaveANearestPixelHoweverFar) {
  EXPECT_EQ(nearest_pixel(Eigen::Vector2d(-0.6, 2.4)), cv::Point(-1, 2));
  EXPECT_EQ(nearest_pixel(1e300), 100'000'000);
}

}  // namespace
}  // namespace pacer::tracking
