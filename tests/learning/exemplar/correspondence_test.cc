// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/correspondence.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "learning/exemplar/train.h"
#include "tests/learning/exemplar/disc_world.h"

namespace pacer::exemplar {
namespace {

using testing::DiscDemonstration;
using testing::DiscStep;

/// A picture with things of other colours in it, and its blobs.
class Correspondences : public ::testing::Test {
 protected:
  Correspondences()
      : correspondence_(exemplars_of(DiscDemonstration::any(20, 15, 3), {}).exemplars) {}

  Balloons match(const DiscStep& step) {
    testing::paint(step, 0, frame_);
    (void)finder_.find(frame_);
    std::vector<Blob> blobs(finder_.blobs().begin(), finder_.blobs().end());
    std::ranges::reverse(blobs);  // their order says nothing
    return correspondence_.match(blobs);
  }

  Correspondence correspondence_;
  BalloonFinder finder_;
  Frame frame_;
};

TEST_F(Correspondences, FindWhatTheColourTableNames) {
  Random random(17);
  int same = 0;
  int all = 0;
  for (int i = 0; i < 60; ++i) {
    const DiscStep step = testing::any_step(random);
    const Balloons found = match(step);
    const Balloons named = finder_.find(frame_);
    for (const auto& [one, other] :
         {std::pair(&found.red, &named.red), {&found.green, &named.green}}) {
      ++all;
      same += one->has_value() == other->has_value() &&
                      (!*one || ((*one)->centroid - (*other)->centroid).norm() < 1.5)
                  ? 1
                  : 0;
    }
  }
  EXPECT_GE(same, all * 9 / 10) << "what is as no exemplar was is left out";
}

TEST_F(Correspondences, OneOddExemplarDoesNotMakeOddBlobsFit) {
  Exemplars exemplars = exemplars_of(DiscDemonstration::any(20, 15, 3), {}).exemplars;
  Blob odd;
  odd.area = 4000.0;
  odd.centroid = {80.0, 60.0};
  odd.xx = odd.yy = 320.0;
  odd.colour = {60.0, 55.0, 200.0};
  const std::vector<double> action = {0.0, 0.2};
  exemplars.add(percept({.red = odd, .green = {}}), action);
  odd.area = 3900.0;  // a bit less odd
  odd.colour[2] = 195.0;
  const std::vector<Blob> blobs = {odd};
  EXPECT_FALSE(Correspondence(exemplars).match(blobs).red);
}

TEST_F(Correspondences, GiveNoBlobTwice) {
  testing::Disc disc{.x = 80, .y = 40, .radius = 9};
  const Balloons found = match({.red = disc, .green = std::nullopt, .command = {}});
  ASSERT_TRUE(found.red);
  EXPECT_FALSE(found.green);
}

TEST_F(Correspondences, OfNothingAreNothing) {
  const Balloons found = correspondence_.match({});
  EXPECT_FALSE(found.red || found.green);
}

TEST(Correspondence, ABalloonThatWasNeverSeenIsNotFound) {
  std::vector<std::vector<DiscStep>> episodes(1);
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    episodes[0].push_back(testing::any_step(random));
    episodes[0].back().green.reset();
  }
  const DemonstratedExemplars seen = exemplars_of(DiscDemonstration(episodes), {});
  const Correspondence correspondence(seen.exemplars);
  Frame frame;
  testing::paint({.red = testing::Disc{.x = 40, .y = 40, .radius = 9},
                  .green = testing::Disc{.x = 110, .y = 40, .radius = 9},
                  .command = {}},
                 0, frame);
  BalloonFinder finder;
  (void)finder.find(frame);
  const Balloons found = correspondence.match(finder.blobs());
  EXPECT_TRUE(found.red);
  EXPECT_FALSE(found.green);
}

}  // namespace
}  // namespace pacer::exemplar
