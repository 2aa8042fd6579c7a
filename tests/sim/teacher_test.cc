// SPDX-License-Identifier: Apache-2.0
#include "sim/teacher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "tests/contract/policy_contract.h"

namespace pacer::sim {
namespace {

/// A teacher with a steady hand, and the sight it looks at.
class Teaching {
 public:
  explicit Teaching(double noise = 0.0) {
    TeacherConfig config;
    config.steering_noise *= noise;
    config.throttle_noise *= noise;
    config.wander *= noise;
    teacher_.emplace(config, sight_, Random(3));
  }

  /// Shows the lead `bearing` radians to the left, `distance` metres away, from behind.
  void show(double bearing, double distance) {
    const double u = 159.5 - 208.5 * std::tan(bearing);
    const double height = 208.5 * 0.17 / distance * std::cos(bearing);
    sight_ = {.seen = true, .bearing = bearing, .size = 2.0 * std::atan(0.6 * height / 208.5)};
    sight_.low = {u - 0.6 * height, 120.0 - 0.5 * height};
    sight_.high = {u + 0.6 * height, 120.0 + 0.5 * height};
    sight_.visible = 1.0;
  }
  void hide() { sight_ = {}; }
  LeadSight& sight() { return sight_; }

  /// Goes on for so many frames; the last command.
  Command watch(int frames) {
    Command command;
    for (int i = 0; i < frames; ++i) {
      frame_.size = {.width = 320, .height = 240};
      frame_.time = Seconds{0.04 * static_cast<double>(frame_.index)};
      ++frame_.index;
      annotations_.clear();
      command = teacher_->act({.frame = frame_, .last = {}}, annotations_);
    }
    return command;
  }
  const Annotations& annotations() const { return annotations_; }

 private:
  LeadSight sight_;
  std::optional<Teacher> teacher_;
  Frame frame_;
  Annotations annotations_;
};

TEST(Teacher, SteersTowardsTheLead) {
  Teaching left, right;
  left.show(0.2, 1.0);
  right.show(-0.2, 1.0);
  EXPECT_GT(left.watch(50).steering, 0.25);
  EXPECT_LT(right.watch(50).steering, -0.25);
}

TEST(Teacher, SteersToTheLockWhereTheLeadLeavesThePicture) {
  Teaching teaching;
  teaching.show(0.62, 1.0);
  EXPECT_GT(teaching.watch(50).steering, 0.95);
}

TEST(Teacher, IsFasterWhenTheLeadLooksSmaller) {
  Teaching near, far;
  near.show(0.0, 0.8);
  far.show(0.0, 1.4);
  EXPECT_GT(far.watch(50).throttle, near.watch(50).throttle + 0.1);
}

TEST(Teacher, BrakesWhenANearLeadComesNearerAndNotAtRest) {
  Teaching teaching;
  teaching.show(0.0, 0.8);
  (void)teaching.watch(25);
  double least = 0.0;
  for (double distance = 0.8; distance > 0.4; distance -= 0.02) {
    teaching.show(0.0, distance);
    least = std::min(least, teaching.watch(1).throttle);
  }
  EXPECT_LT(least, -0.05);
  EXPECT_EQ(teaching.watch(50).throttle, 0.0);
}

TEST(Teacher, TakesALeadSeenFromTheSideToBeAsFarAsFromBehind) {
  Teaching behind, side;
  behind.show(0.0, 1.2);
  side.show(0.0, 1.2);
  LeadSight& sight = side.sight();
  const double widen = sight.high.x() - sight.low.x();  // twice as wide, as high
  sight.low.x() -= 0.5 * widen;
  sight.high.x() += 0.5 * widen;
  sight.size = 2.0 * std::atan(0.5 * (sight.high.x() - sight.low.x()) / 208.5);
  EXPECT_NEAR(side.watch(50).throttle, behind.watch(50).throttle, 0.02);
}

TEST(Teacher, StandsStillUntilItHasSeenSomething) {
  Teaching teaching(1.0);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(teaching.watch(1), Command{});
}

TEST(Teacher, ReactsNoSoonerThanAPersonCan) {
  Teaching teaching;
  teaching.watch(25);
  teaching.show(0.2, 1.4);
  EXPECT_EQ(teaching.watch(4), Command{}) << "0.12 s after it came into view";
  EXPECT_NE(teaching.watch(5), Command{}) << "0.32 s after";
}

TEST(Teacher, StopsSoonAfterItSeesNothing) {
  Teaching teaching(1.0);
  teaching.show(0.1, 1.3);
  EXPECT_GT(teaching.watch(50).throttle, 0.1);
  teaching.hide();
  EXPECT_LE(teaching.watch(20).throttle, 0.0) << "0.8 s after the lead has gone";
  EXPECT_NEAR(teaching.watch(20).steering, 0.0, 0.03);
}

TEST(Teacher, DrivesOnThroughOneSpoiltPicture) {
  Teaching teaching;
  teaching.show(0.0, 1.3);
  const double before = teaching.watch(50).throttle;
  teaching.hide();
  teaching.watch(1);
  teaching.show(0.0, 1.3);
  for (int i = 0; i < 20; ++i) EXPECT_GT(teaching.watch(1).throttle, 0.9 * before);
}

TEST(Teacher, KnowsOnlyTheSightItIsShown) {
  Teaching seeing, blind;
  seeing.show(0.3, 1.0);
  LeadSight& hidden = blind.sight();
  blind.show(0.3, 1.0);
  hidden.seen = false;  // numbers left over from a frame before
  EXPECT_NE(seeing.watch(30), Command{});
  EXPECT_EQ(blind.watch(30), Command{});
}

TEST(Teacher, MarksWhatItSees) {
  Teaching teaching;
  teaching.show(0.0, 1.0);
  teaching.watch(1);
  ASSERT_EQ(teaching.annotations().boxes.size(), 1U);
  EXPECT_EQ(teaching.annotations().boxes[0].tone, Tone::kTarget);
}

TEST(TeacherConfig, NamesTheFieldThatMakesNoSense) {
  EXPECT_NO_THROW(TeacherConfig{}.validate());
  TeacherConfig config;
  config.memory = 0.5;
  EXPECT_THROW(config.validate(), std::invalid_argument) << "longer than its reaction";
  config = {};
  config.halt = 1.5;
  EXPECT_THROW(config.validate(), std::invalid_argument);
}

template <bool seen>
struct TeacherFactory {
  struct WithSight final : Policy {
    WithSight() : teacher({}, sight, Random(11)) {
      if (seen) {
        sight = {.seen = true, .bearing = 0.3, .size = 0.25};
        sight.low = {90.0, 90.0};
        sight.high = {140.0, 130.0};
      }
    }
    Command act(const Observation& observation, Annotations& annotations) override {
      return teacher.act(observation, annotations);
    }
    Driver driver() const override { return teacher.driver(); }
    LeadSight sight;
    Teacher teacher;
  };
  std::unique_ptr<Policy> operator()() const { return std::make_unique<WithSight>(); }
};

}  // namespace
}  // namespace pacer::sim

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(SeeingTeacher, PolicyContract, sim::TeacherFactory<true>);
INSTANTIATE_TYPED_TEST_SUITE_P(BlindTeacher, PolicyContract, sim::TeacherFactory<false>);
}  // namespace pacer::testing
