// SPDX-License-Identifier: Apache-2.0
#include "sim/click_teacher.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "tests/contract/policy_contract.h"

namespace pacer::sim {
namespace {

/// A balloon of a disc's shape in a picture of 320 x 240.
BalloonSight disc(double x, double y, double radius) {
  BalloonSight sight;
  sight.pixels = static_cast<int>(M_PI * radius * radius);
  sight.centroid = {x, y};
  sight.low = {x - radius, y - radius};
  sight.high = {x + radius, y + radius};
  return sight;
}

/// A teacher and the sights it looks at; each act() is one impulse.
class Clicking {
 public:
  explicit Clicking(const ClickTeacherConfig& config = {}, std::uint64_t seed = 3)
      : teacher_(config, sights, Random(seed)) {
    frame_.size = {.width = 320, .height = 240};
  }
  Command act() {
    annotations.clear();
    ++frame_.index;
    return teacher_.act({.frame = frame_, .last = {}}, annotations);
  }
  BalloonSights sights;
  Annotations annotations;

 private:
  Frame frame_;
  ClickTeacher teacher_;
};

/// One without a person's scatter.
ClickTeacherConfig steady() {
  ClickTeacherConfig config;
  config.scatter = config.hand = config.throttle_scatter = config.search_scatter = 0.0;
  return config;
}

TEST(ClickTeacher, SteersToTheSideOnWhichTheBalloonIs) {
  Clicking teacher(steady());
  double before = 2.0;
  for (double x = 10.0; x < 320.0; x += 10.0) {
    teacher.sights.red = disc(x, 90.0, 12.0);
    const double steering = teacher.act().steering;
    EXPECT_LE(steering, before) << x;
    EXPECT_EQ(steering > 0.0, x < 159.5) << x;
    before = steering;
  }
}

TEST(ClickTeacher, DrivesHarderTheFartherTheBalloonLooks) {
  Clicking teacher(steady());
  double before = 0.0;
  for (const double radius : {80.0, 40.0, 20.0, 10.0, 5.0}) {
    teacher.sights.red = disc(160.0, 90.0, radius);
    const double throttle = teacher.act().throttle;
    EXPECT_GE(throttle, before) << radius;
    EXPECT_GT(throttle, 0.0);
    before = throttle;
  }
}

TEST(ClickTeacher, ClicksOnTheBalloonWithAPersonsScatter) {
  Clicking teacher;
  double sum = 0.0, squares = 0.0;
  constexpr int kClicks = 400;
  for (int i = 0; i < kClicks; ++i) {
    teacher.sights.red = disc(200.0 + 3 * (i % 7), 90.0, 20.0);  // it sways
    (void)teacher.act();
    ASSERT_EQ(teacher.annotations.points.size(), 1U);
    const PixelPoint at = teacher.annotations.points[0].at;
    EXPECT_LE(std::abs(static_cast<double>(at.x) - 209.0), 30.0);
    EXPECT_LE(std::abs(static_cast<double>(at.y) - 90.0), 20.1);
    const double off = static_cast<double>(at.x) - 200.0 - 3 * (i % 7);
    sum += off;
    squares += off * off;
  }
  EXPECT_LT(std::abs(sum / kClicks), 1.0);
  EXPECT_NEAR(std::sqrt(squares / kClicks), std::hypot(0.12 * 41.0, 2.5), 0.8);
}

TEST(ClickTeacher, TurnsToTheChosenSideUntilItHasSeenTheBalloonThenToWhereItWas) {
  for (const bool left : {true, false}) {
    ClickTeacherConfig config;
    config.search = left ? "left" : "right";
    Clicking teacher(config);
    EXPECT_GT(teacher.act().steering * (left ? 1.0 : -1.0), 0.5);
    teacher.sights.red = disc(left ? 300.0 : 20.0, 90.0, 12.0);
    (void)teacher.act();
    teacher.sights.red = {};
    EXPECT_LT(teacher.act().steering * (left ? 1.0 : -1.0), -0.5);
  }
}

TEST(ClickTeacher, DoesNotMindTheGreenBalloon) {
  Clicking with, without;
  for (int i = 0; i < 20; ++i) {
    for (Clicking* teacher : {&with, &without}) {
      teacher->sights.red = i % 4 == 0 ? BalloonSight{} : disc(15.0 * i + 10.0, 90.0, 14.0);
    }
    with.sights.green = disc(300.0 - 10.0 * i, 100.0, 30.0);
    EXPECT_EQ(with.act(), without.act());
  }
}

TEST(ClickTeacher, WaitsWhereInterferenceMayCoverTheBalloon) {
  Clicking teacher;
  teacher.sights.spoilt_rows = 100;
  teacher.sights.red.covered = 400;
  for (int i = 0; i < 100; ++i) EXPECT_EQ(teacher.act(), Command{});
  teacher.sights.red = disc(160.0, 90.0, 12.0);  // what is clear of it will do
  EXPECT_GT(teacher.act().throttle, 0.0);
}

TEST(ClickTeacher, KnowsNothingOfWhatIsCovered) {
  Clicking one, other;
  other.sights.red.covered = 500;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(one.act(), other.act());
}

TEST(ClickTeacher, GivesUpWhenItHasTurnedForLongAndSaysSo) {
  ClickTeacherConfig config;
  config.patience = 7;
  Clicking teacher(config);
  for (int i = 0; i < 7; ++i) EXPECT_GT(teacher.act().throttle, 0.0);
  EXPECT_EQ(teacher.act(), Command{});
  EXPECT_NE(teacher.annotations.label.find("gives up"), std::string::npos);
}

TEST(ClickTeacher, GivesUpWhenThePictureStaysAsItIs) {
  Clicking teacher;
  teacher.sights.red = disc(160.0, 90.0, 12.0);
  for (int i = 0; i < 5; ++i) EXPECT_GT(teacher.act().throttle, 0.0) << i;
  EXPECT_EQ(teacher.act(), Command{});
  EXPECT_EQ(teacher.annotations.label, "gives up: stuck");
}

TEST(ClickTeacher, RefusesAHandThatNobodyHas) {
  ClickTeacherConfig config;
  config.search = "up";
  EXPECT_THROW(Clicking{config}, std::invalid_argument);
  config = {};
  config.least = 0.9;
  EXPECT_THROW(Clicking{config}, std::invalid_argument);
}

/// A teacher with its sights, for pictures of 320 x 240.
template <bool kSeeing>
struct ClickTeacherFactory {
  struct Whole final : Policy {
    Whole() : teacher({}, sights, Random(9)) {
      if (kSeeing) sights.red = disc(100.0, 80.0, 15.0);
    }
    Command act(const Observation& observation, Annotations& annotations) override {
      return teacher.act(observation, annotations);
    }
    [[nodiscard]] Driver driver() const override { return teacher.driver(); }
    BalloonSights sights;
    ClickTeacher teacher;
  };
  std::unique_ptr<Policy> operator()() const { return std::make_unique<Whole>(); }
};

}  // namespace
}  // namespace pacer::sim

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(SeeingClicks, PolicyContract, sim::ClickTeacherFactory<true>);
INSTANTIATE_TYPED_TEST_SUITE_P(BlindClicks, PolicyContract, sim::ClickTeacherFactory<false>);
}  // namespace pacer::testing
