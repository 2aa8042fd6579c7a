// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/results_file.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.h"
#include "dataset/sequence_annotation.h"

namespace pacer {
namespace {

using tracking::Track;

TEST(ResultsFile, CountsPixelsFromOne) {
  const std::vector<Track> tracks = {{.box = Box::of_pixels(0.0, 4.0, 10.0, 20.0)},
                                     {.box = Box::of_pixels(-2.5, 0.25, 10.5, 1.0)}};
  EXPECT_EQ(results_text(0, tracks), "1,5,10,20\n-1.5,1.25,10.5,1\n");
}

TEST(ResultsFile, HasALineForEachPictureBeforeTheStart) {
  const std::vector<Track> tracks = {{.box = Box::of_pixels(0, 0, 2, 2)}};
  EXPECT_EQ(results_text(2, tracks), "NaN,NaN,NaN,NaN\nNaN,NaN,NaN,NaN\n1,1,2,2\n");
}

TEST(ResultsFile, IsAnAnnotationToo) {
  Random random(1);
  std::vector<Track> tracks;
  for (int i = 0; i < 200; ++i) {
    tracks.push_back({.box = {random.uniform(-500, 2000), random.uniform(-500, 2000),
                              random.uniform(0.01, 900), random.uniform(0.01, 900)}});
  }
  tracks.push_back({.box = {NAN, 1, 2, 3}});
  const auto boxes =
      dataset::parse_boxes(results_text(3, tracks), dataset::SequenceLayout::kOtb, "results.txt");
  ASSERT_EQ(boxes.size(), 204U);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_FALSE(boxes[i]);
  EXPECT_FALSE(boxes.back());
  for (std::size_t i = 0; i < 200; ++i) {
    ASSERT_TRUE(boxes[i + 3]);
    EXPECT_NEAR(boxes[i + 3]->x, tracks[i].box.x, 1e-4);
    EXPECT_NEAR(boxes[i + 3]->height, tracks[i].box.height, 1e-4);
  }
}

}  // namespace
}  // namespace pacer
