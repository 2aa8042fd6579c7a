// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/semi_boost/semi_online_boost.h"

#include "tests/contract/tracker_contract.h"

namespace pacer::testing {

INSTANTIATE_TEST_SUITE_P(
    SemiBoost, TrackerContract,
    ::testing::Values(tracking::TrackerKind{
        .name = "Semi-Online-Boost", .about = "", .make = tracking::make_semi_online_boost}),
    tracker_name);

/// A textured square, shown where it is wanted on a fainter texture that stands still.
class SemiOnlineBoost : public TrackerContract {
 protected:
  tracking::Picture shown_at(int left, int top) const {
    cv::Mat3b image = background_.clone();
    square_.copyTo(image(cv::Rect(left, top, square_.cols, square_.rows)));
    return picture_of(image);
  }
  tracking::Picture hidden() const { return picture_of(background_); }

  void SetUp() override { cv::normalize(background_, background_, 100, 150, cv::NORM_MINMAX); }

  cv::Mat3b background_ = texture(160, 120, 21);
  cv::Mat3b square_ = texture(36, 36, 22);
  std::unique_ptr<tracking::Tracker> tracker_ = tracking::make_semi_online_boost(1);
};

TEST_F(SemiOnlineBoost, SaysNothingWhileTheTargetIsHidden) {
  tracker_->start(shown_at(40, 30), Box::of_pixels(40, 30, 36, 36));
  EXPECT_GT(tracker_->update(shown_at(42, 31)).confidence, 0.0);
  for (int i = 0; i < 5; ++i) {
    const tracking::Track track = tracker_->update(hidden());
    EXPECT_EQ(track.confidence, 0.0);
    EXPECT_EQ(track.box, Box::of_pixels(42, 31, 36, 36));
  }
}

TEST_F(SemiOnlineBoost, FindsTheTargetAgainWhereverItComesBack) {
  tracker_->start(shown_at(40, 30), Box::of_pixels(40, 30, 36, 36));
  for (int i = 0; i < 3; ++i) static_cast<void>(tracker_->update(hidden()));
  const tracking::Track track = tracker_->update(shown_at(110, 75));
  EXPECT_GT(track.confidence, 0.0);
  EXPECT_GT(overlap(track.box, Box::of_pixels(110, 75, 36, 36)), 0.7);
}

TEST_F(SemiOnlineBoost, KeepsTheBoxsOffsetFromItsPartInThePicture) {
  // A quarter of the box is outside; what is inside moves by three pixels.
  tracker_->start(shown_at(0, 40), Box::of_pixels(-12, 40, 48, 36));
  EXPECT_LT(centre_distance(tracker_->update(shown_at(3, 40)).box, Box::of_pixels(-9, 40, 48, 36)),
            1.5);
}

}  // namespace pacer::testing
