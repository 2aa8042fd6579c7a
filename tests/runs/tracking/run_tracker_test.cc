// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/run_tracker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "core/check.h"
#include "runs/tracking/choose_trackers.h"
#include "tests/runs/tracking/fake_tracker.h"
#include "tests/runs/tracking/moving_target.h"
#include "tests/support/scratch.h"

namespace pacer {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using testing::kind;

dataset::Sequence named(const std::string& name, const std::filesystem::path& path) {
  dataset::Sequence sequence;
  sequence.name = name;
  sequence.path = path;
  return sequence;
}

class RunTracker : public ::testing::Test {
 protected:
  TrackingTarget target(std::size_t pictures, std::size_t first = 0) {
    return targets_of({testing::write_moving(scratch_ / "moving", pictures, first)}, {}).front();
  }
  testing::Scratch scratch_;
};

TEST_F(RunTracker, FollowsEveryPictureOfASequence) {
  const TrackingTarget moving = target(150);  // several chunks
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving);
  EXPECT_EQ(run.tracker, "bright");
  EXPECT_EQ(run.target, "moving");
  EXPECT_EQ(run.pictures, 150U);
  ASSERT_EQ(run.tracks.size(), 150U);
  for (std::size_t at = 0; at < 150; ++at) {
    ASSERT_LT(centre_distance(run.tracks[at].box, testing::moving_target(at)), 0.6) << at;
  }
  const TrackingScore score = score_tracks(run.tracks, truth_of(moving, run));
  EXPECT_EQ(score.scored, 150U);
  EXPECT_EQ(score.frames_held, 150U);
  EXPECT_GT(run.fps(), 0.0);
  EXPECT_TRUE(run.failures.empty());
  EXPECT_EQ(run.sequence_error, "");
  EXPECT_TRUE(run.whole);
}

TEST_F(RunTracker, StartsWhereTheTruthDoes) {
  const TrackingTarget moving = target(30, 12);
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving);
  EXPECT_EQ(run.first, 12U);
  EXPECT_EQ(run.tracks.size(), 18U);
  EXPECT_EQ(score_tracks(run.tracks, truth_of(moving, run)).frames_held, 18U);
}

TEST_F(RunTracker, CountsFailuresWithResets) {
  // The target leaves a box of 12 px that stands still after six pictures of 2 px: 6, 11 + 6 ...
  const TrackingRun run = run_tracker(kind<testing::Still>("still"), target(20));
  EXPECT_THAT(run.failures, ElementsAre(6U, 17U));
  EXPECT_EQ(run.tracks.size(), 20U);
}

TEST_F(RunTracker, ATrackerThatThrowsLosesTheRestAndNothingElse) {
  const TrackingTarget moving = target(20);
  tracking::TrackerKind throwing = kind<testing::Throwing>("throwing");
  throwing.make = [](std::uint64_t) -> std::unique_ptr<tracking::Tracker> {
    class OnThird final : public testing::Still {
      int seen_ = 0;
      [[nodiscard]] tracking::Track follow(const tracking::Picture&) override {
        if (++seen_ == 3) throw std::runtime_error("third");
        return {.box = box_, .confidence = 1.0};
      }
    };
    return std::make_unique<OnThird>();
  };
  const TrackingRun run = run_tracker(throwing, moving);
  EXPECT_EQ(run.tracker_error, "third");
  EXPECT_EQ(run.tracks.size(), 3U);
  EXPECT_EQ(run.pictures, 20U);
  const TrackingScore score = score_tracks(run.tracks, truth_of(moving, run));
  EXPECT_EQ(score.scored, 20U);
  EXPECT_EQ(score.lost_at, 3U);
}

TEST_F(RunTracker, APictureOfAnotherSizeEndsItWithWhatThereIs) {
  const TrackingTarget moving = target(20);
  Frame other = testing::moving_frame(0);
  other.size = {48, 64};
  dataset::SequenceWriter writer(scratch_ / "other");
  writer.write(other, testing::moving_target(0));
  writer.close();
  std::filesystem::copy_file(scratch_ / "other/img/0001.jpg", moving.sequence.pictures[9],
                             std::filesystem::copy_options::overwrite_existing);
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving);
  EXPECT_THAT(run.sequence_error, HasSubstr("picture 10 is 48 x 64"));
  EXPECT_EQ(run.tracks.size(), 9U);
  EXPECT_EQ(score_tracks(run.tracks, truth_of(moving, run)).scored, 9U);
}

TEST_F(RunTracker, APictureThatCannotBeReadEndsItWithWhatThereIs) {
  const TrackingTarget moving = target(20);
  std::ofstream(moving.sequence.pictures[9], std::ios::binary) << "no picture";
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving);
  EXPECT_THAT(run.sequence_error, HasSubstr("0010.jpg"));
  EXPECT_EQ(run.tracks.size(), 9U);
}

TEST_F(RunTracker, SaysWhereASequenceIsShorterThanItsAnnotation) {
  TrackingTarget moving = target(20);
  const std::vector<std::optional<Box>> longer(25, moving.box);
  moving.truth = longer;
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving);
  EXPECT_EQ(run.tracks.size(), 20U);
  EXPECT_EQ(run.sequence_error, "it has 20 pictures, its annotation 25");
}

TEST_F(RunTracker, StopsWhereItIsTold) {
  const TrackingTarget moving = target(30);
  std::stop_source stop;
  std::size_t seen = 0;
  TrackingOptions options;
  options.tick = [&] {
    if (++seen == 7) stop.request_stop();
  };
  const TrackingRun run =
      run_tracker(kind<testing::Bright>("bright"), moving, options, stop.get_token());
  EXPECT_FALSE(run.whole);
  EXPECT_EQ(run.tracks.size(), 7U);
  EXPECT_EQ(run.pictures, 7U);
}

TEST_F(RunTracker, ShowsWhatItTracks) {
  const TrackingTarget moving = target(12, 2);
  std::vector<double> seen;
  TrackingOptions options;
  options.watch = [&](const tracking::Picture& picture, const tracking::Track& track,
                      const tracking::Tracker&) {
    EXPECT_EQ(picture.grey.cols, 64);
    seen.push_back(track.box.x);
  };
  const TrackingRun run = run_tracker(kind<testing::Bright>("bright"), moving, options);
  ASSERT_EQ(seen.size(), 10U);
  EXPECT_EQ(seen.back(), run.tracks.back().box.x);
}

TEST_F(RunTracker, StartsElsewhereForItsRobustness) {
  const TrackingRun run =
      run_tracker(kind<testing::Bright>("bright"), target(40), {.robustness = true});
  ASSERT_TRUE(run.temporal && run.spatial);
  EXPECT_EQ(run.temporal->runs, 20U);
  EXPECT_EQ(run.spatial->runs, 12U);
  EXPECT_GT(run.temporal->success, 0.85);
  EXPECT_LT(run.spatial->success, run.temporal->success) << "boxes of another size stay so";
  EXPECT_DOUBLE_EQ(run.spatial->precision, 1.0);
}

TEST_F(RunTracker, TravelsAsBytes) {
  TrackingRun run = run_tracker(kind<testing::Still>("still"), target(20), {.robustness = true});
  run.tracker_error = "with \"quotes\" and \xFF";
  run.tracks.push_back({.box = {0.1, NAN, 1e300, 3.0}, .confidence = 0.25});
  const TrackingRun same = tracking_run_from(to_bytes(run));
  EXPECT_EQ(to_bytes(same), to_bytes(run));
  EXPECT_EQ(same.tracks.size(), run.tracks.size());
  EXPECT_EQ(same.tracks[3].box, run.tracks[3].box);
  EXPECT_EQ(same.failures, run.failures);
  EXPECT_EQ(same.temporal->success, run.temporal->success);
  EXPECT_EQ(same.tracker_error, run.tracker_error);
  EXPECT_THROW((void)tracking_run_from("something else"), std::invalid_argument);
}

TEST_F(RunTracker, FollowsPicturesThatComeOneByOne) {
  class Source final : public dataset::PictureSource {
    int at_ = 0;
    [[nodiscard]] bool next(cv::Mat& picture) override {
      testing::numbered_picture(at_).bgr.copyTo(picture);
      return at_++ < 15;
    }
  };
  Source camera;
  const TrackingRun run = run_tracker(kind<testing::Still>("still"), camera,
                                      Box{20.0, 20.0, 8.0, 8.0}, TrackingOptions{});
  EXPECT_EQ(run.tracks.size(), 15U);
  EXPECT_TRUE(run.failures.empty());
}

TEST_F(RunTracker, SaysWhereThereIsNoPictureToStartOn) {
  class Nothing final : public dataset::PictureSource {
    [[nodiscard]] bool next(cv::Mat&) override { return false; }
  };
  Nothing camera;
  const TrackingRun run = run_tracker(kind<testing::Still>("still"), camera,
                                      Box{20.0, 20.0, 8.0, 8.0}, TrackingOptions{});
  EXPECT_TRUE(run.tracks.empty());
  EXPECT_EQ(run.sequence_error, "it ends before picture 1, on which trackers start");
}

TEST(TargetsOf, ATypedBoxIsInTheFirstPicture) {
  dataset::Sequence sequence = named("s", "s");
  sequence.targets.push_back({.name = "", .boxes = {std::nullopt, Box{1, 1, 2, 2}}});
  const auto targets = targets_of({sequence}, Box{5, 5, 3, 3});
  ASSERT_EQ(targets.size(), 1U);
  EXPECT_EQ(targets[0].first, 0U);
  EXPECT_EQ(targets[0].box.x, 5.0);
  EXPECT_EQ(targets[0].truth.size(), 2U);
}

TEST(TargetsOf, EachTargetStartsWithItsTruth) {
  dataset::Sequence sequence = named("Jogging", "s");
  sequence.targets.push_back({.name = "1", .boxes = {Box{1, 1, 2, 2}}});
  sequence.targets.push_back({.name = "2", .boxes = {std::nullopt, Box{2, 2, 3, 3}}});
  const auto targets = targets_of({sequence}, {});
  ASSERT_EQ(targets.size(), 2U);
  EXPECT_EQ(targets[0].name, "Jogging.1");
  EXPECT_EQ(targets[1].name, "Jogging.2");
  EXPECT_EQ(targets[1].first, 1U);
  EXPECT_EQ(targets[1].box.width, 3.0);
}

TEST(TargetsOf, ASequenceWithoutTruthWantsABox) {
  const dataset::Sequence video = named("v", "some/v.mp4");
  try {
    (void)targets_of({video}, {});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("some/v.mp4"));
    EXPECT_THAT(error.what(), HasSubstr("--box"));
  }
  dataset::Sequence absent = video;
  absent.targets.push_back({.name = "", .boxes = {std::nullopt, Box{NAN, 1, 1, 1}}});
  EXPECT_THROW((void)targets_of({absent}, {}), UsageError);
}

TEST(ParseBox, CountsPixelsFromOne) {
  EXPECT_EQ(parse_box("1,2,30,40.5"), Box::of_pixels(0.0, 1.0, 30.0, 40.5));
  EXPECT_EQ(parse_box("-5,2,3,4"), Box::of_pixels(-6.0, 1.0, 3.0, 4.0));
}

TEST(ParseBox, RefusesWhatIsNoBox) {
  for (const char* text : {"", "1,2,3", "1,2,3,4,5", "1,2,3,x", "1 2 3 4", "1,2,0,4", "1,2,3,-4",
                           "nan,2,3,4", "1,inf,3,4", "1,2,3,4 ", ",1,2,3,4"}) {
    EXPECT_THROW((void)parse_box(text), std::invalid_argument) << text;
  }
}

TEST(ChooseTrackers, TakesThemInTheOrderOfTheNames) {
  const std::vector<tracking::TrackerKind> known = {kind<testing::Still>("a"),
                                                    kind<testing::Still>("b")};
  const auto names = [&](const std::vector<std::string>& wanted) {
    std::vector<std::string> found;
    for (const auto& one : choose_trackers(wanted, known)) found.push_back(one.name);
    return found;
  };
  EXPECT_THAT(names({}), ElementsAre("a"));
  EXPECT_THAT(names({"b", "a"}), ElementsAre("b", "a"));
  EXPECT_THAT(names({"B"}), ElementsAre("b")) << "capitals do not matter";
  EXPECT_THAT(names({"all"}), ElementsAre("a", "b"));
  EXPECT_THROW((void)names({"b", "all"}), UsageError);
  EXPECT_THROW((void)names({"a", "A"}), UsageError);
  try {
    (void)names({"c"});
    FAIL();
  } catch (const UsageError& error) {
    EXPECT_THAT(error.what(), HasSubstr("there are a, b"));
  }
}

}  // namespace
}  // namespace pacer
