// SPDX-License-Identifier: Apache-2.0
#include "studies/tracking_insides.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "studies/materials.h"
#include "studies/tracking_clusters.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

using ::testing::HasSubstr;

class TrackingInsides : public ::testing::Test {
 protected:
  testing::Scratch scratch_;
  std::vector<TrackingTarget> targets_ =
      targets_of({testing::write_moving(scratch_ / "walk", 20, 2)}, {});
};

TEST_F(TrackingInsides, AreTimedAndDrawnPictureByPicture) {
  std::size_t seen = 0;
  const TrackerInsides insides =
      look_inside("LP-SMAT", targets_.front(), {0, 5, 99}, 1, {},
                  [&seen](std::size_t, const tracking::Picture&) { ++seen; });
  EXPECT_EQ(seen, 18U);
  EXPECT_EQ(insides.update_s.size(), 17U);
  ASSERT_EQ(insides.shots.size(), 2U) << "there is no hundredth picture";
  EXPECT_EQ(insides.shots[0].at, 2U) << "the sequence's first two are not annotated";
  EXPECT_EQ(insides.shots[1].at, 7U);
}

TEST_F(TrackingInsides, EndWhenTold) {
  std::stop_source stop;
  stop.request_stop();
  EXPECT_THROW((void)look_inside("LP-MED", targets_.front(), {}, 1, stop.get_token()),
               StudyStopped);
}

TEST(ClusteredTemplates, JoinPicturesThatAreAlikeHoweverFarApart) {
  const Box box{32.0, 24.0, 12.0, 10.0};
  ClusteredTemplates clusters(box);
  for (int at = 0; at < 60; ++at) {  // one look and another, in turns
    const bool turned = at % 10 >= 5;
    clusters.add(cv::Mat1b(48, 64, turned ? std::uint8_t{200} : std::uint8_t{50}), box);
  }
  report::Page page("clusters");
  clusters.add_to(page);
  EXPECT_THAT(page.html(), HasSubstr("of which there are 2<"));
}

TEST(ClusteredTemplates, AreOfTheFirstPicturesOnly) {
  const Box box{32.0, 24.0, 12.0, 10.0};
  ClusteredTemplates clusters(box, 30);
  for (int at = 0; at < 60; ++at) {
    clusters.add(cv::Mat1b(48, 64, static_cast<std::uint8_t>(50 + at)), box);
  }
  report::Page page("clusters");
  clusters.add_to(page);
  EXPECT_THAT(page.html(), HasSubstr("pictures 1 to 30"));
}

}  // namespace
}  // namespace pacer
