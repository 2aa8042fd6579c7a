// SPDX-License-Identifier: Apache-2.0
#include "tests/contract/tracker_contract.h"

namespace pacer::testing {
namespace {

INSTANTIATE_TEST_SUITE_P(OurOwn, TrackerContract, ::testing::ValuesIn(tracking::trackers()),
                         tracker_name);

/// Ours take whatever holds a pixel; other people's may refuse it.
class OurTracker : public TrackerContract {};

TEST_P(OurTracker, StartsOnAnyBoxAndPicture) {
  const cv::Mat3b black(kSize.height, kSize.width, cv::Vec3b(0, 0, 0));
  for (const tracking::Picture& picture : {moving_square(1)[0], picture_of(black)}) {
    for (const Box& box : awkward_boxes()) {
      EXPECT_NO_THROW(make()->start(picture, box))
          << box.width << " x " << box.height << " at " << box.left() << ", " << box.top();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OurOwn, OurTracker, ::testing::ValuesIn(tracking::trackers()),
                         tracker_name);

}  // namespace
}  // namespace pacer::testing
