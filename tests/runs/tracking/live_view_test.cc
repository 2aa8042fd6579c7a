// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/live_view.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>

#include "tests/runs/tracking/fake_tracker.h"

namespace pacer {
namespace {

using ::testing::HasSubstr;

/// Pictures without a camera.
class Pictures final : public dataset::PictureSource {
 public:
  [[nodiscard]] bool next(cv::Mat& picture) override {
    testing::numbered_picture(at_).bgr.copyTo(picture);
    return at_++ < 10;
  }

 private:
  int at_ = 0;
};

class LiveView : public ::testing::Test {
 protected:
  void SetUp() override {  // NOLINTBEGIN(concurrency-mt-unsafe): there is one thread
    ::unsetenv("DISPLAY");
    ::unsetenv("WAYLAND_DISPLAY");
  }
  /// Windows that are drawn into memory, where OpenCV's are Qt's; else the test is skipped.
  static void open_windows_in_memory() {
    ::setenv("DISPLAY", ":memory", 1);
    ::setenv("QT_QPA_PLATFORM", "offscreen", 1);
  }  // NOLINTEND(concurrency-mt-unsafe)
};

TEST_F(LiveView, WithoutADisplayItSaysWhatToDo) {
  try {
    require_display();
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("DISPLAY"));
    EXPECT_THAT(error.what(), HasSubstr("--box"));
  }
  Pictures pictures;
  EXPECT_THROW((void)track_live(testing::kind<testing::Still>("still"), pictures, {}, 1, {}, {}),
               std::runtime_error);
  EXPECT_THROW((void)draw_box(testing::numbered_picture(3).bgr), std::runtime_error);
}

TEST_F(LiveView, FollowsInAWindow) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the window toolkit keeps memory to its end";
#endif
  open_windows_in_memory();
  try {
    require_display();
  } catch (const std::runtime_error&) {
    GTEST_SKIP() << "OPENCV'S WINDOWS ARE NOT QT'S: the live view is NOT tested";
  }
  Pictures pictures;
  int seen = 0;
  const TrackWatch watch = [&seen](const auto&...) { ++seen; };
  const TrackingRun run = track_live(testing::kind<testing::Throwing>("throwing"), pictures,
                                     Box{20.0, 20.0, 9.0, 9.0}, 1, watch, {});
  EXPECT_EQ(run.tracks.size(), 6U);
  EXPECT_EQ(seen, 6);
  EXPECT_EQ(run.tracker_error, "seven");

  Pictures others;
  const TrackingRun none =
      track_live(testing::kind<testing::Still>("still"), others, {}, 1, watch, {});
  EXPECT_EQ(none.first, 10U) << "nobody drew a box";
  EXPECT_TRUE(none.tracks.empty());
}

}  // namespace
}  // namespace pacer
