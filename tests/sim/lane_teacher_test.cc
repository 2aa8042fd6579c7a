// SPDX-License-Identifier: Apache-2.0
#include "sim/lane_teacher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>

#include "core/constant_policy.h"
#include "core/limits.h"
#include "sim/lane_boards.h"
#include "tests/contract/policy_contract.h"
#include "tests/support/bicycle.h"

namespace pacer::sim {
namespace {

using testing::Bicycle;

/// A board `ahead` and `left` metres from the camera.
BoardSight board(LaneSide side, double ahead, double left) {
  return {.side = side,
          .bearing = std::atan2(left, ahead),
          .size = 2.0 * std::atan(0.5 * Board::kHeight / std::hypot(ahead, left)),
          .low = {10.0, 10.0},
          .high = {20.0, 20.0}};
}

/// A straight piece of lane, its middle `aside` metres to the left of the camera.
LaneSight straight(double aside) {
  LaneSight sight;
  for (double ahead = 0.5; ahead < 1.7; ahead += 0.3) {
    sight.boards.push_back(board(LaneSide::kLeft, ahead, aside + 0.4));
    sight.boards.push_back(board(LaneSide::kRight, ahead, aside - 0.4));
  }
  return sight;
}

class LaneTeaching {
 public:
  LaneTeaching() {
    LaneTeacherConfig config;
    config.steering_noise = config.throttle_noise = config.wander = 0.0;
    teacher_.emplace(config, sight, Random(3));
  }
  Command watch(int frames) {
    Command command;
    for (int i = 0; i < frames; ++i) {
      frame_.size = {.width = 320, .height = 240};
      frame_.time = Seconds{0.04 * static_cast<double>(frame_.index++)};
      annotations = {};
      command = teacher_->act({.frame = frame_, .last = {}}, annotations);
    }
    return command;
  }
  LaneSight sight;
  Annotations annotations;

 private:
  std::optional<LaneTeacher> teacher_;
  Frame frame_;
};

TEST(LaneTeacher, SteersToTheMiddleBetweenTheBoards) {
  LaneTeaching left, middle, right;
  left.sight = straight(0.15);
  middle.sight = straight(0.0);
  right.sight = straight(-0.15);
  EXPECT_GT(left.watch(50).steering, 0.15);
  EXPECT_NEAR(middle.watch(50).steering, 0.0, 0.03);
  EXPECT_LT(right.watch(50).steering, -0.15);
  EXPECT_GT(middle.watch(1).throttle, 0.15);
}

TEST(LaneTeacher, OneRowOfBoardsIsEnough) {
  for (const LaneSide side : {LaneSide::kLeft, LaneSide::kRight}) {
    LaneTeaching teaching;
    for (const BoardSight& one : straight(0.1).boards) {
      if (one.side == side) teaching.sight.boards.push_back(one);
    }
    EXPECT_GT(teaching.watch(50).steering, 0.1);
    EXPECT_LT(teaching.watch(1).steering, 0.4);
  }
}

TEST(LaneTeacher, WhatStandsBeyondAGapIsAnotherStretchOfTheLane) {
  LaneTeaching plain, with_more;
  plain.sight = with_more.sight = straight(0.0);
  with_more.sight.boards.push_back(board(LaneSide::kLeft, 1.7, -1.0));
  EXPECT_EQ(plain.watch(50), with_more.watch(50));
}

TEST(LaneTeacher, IsSlowerInBends) {
  LaneTeaching ahead, bend;
  ahead.sight = straight(0.0);
  bend.sight = straight(0.3);
  EXPECT_GT(ahead.watch(50).throttle, bend.watch(50).throttle + 0.01);
}

TEST(LaneTeacher, GoesOnThroughAFlickerAndStopsWhereNothingIsToBeSeen) {
  LaneTeaching teaching;
  teaching.sight = straight(0.1);
  (void)teaching.watch(50);
  teaching.sight = {};
  EXPECT_GT(teaching.watch(8).throttle, 0.1);
  EXPECT_EQ(teaching.annotations.label, "no board to be seen");
  EXPECT_EQ(teaching.watch(50).throttle, 0.0);
}

/// What a camera at the car's middle sees of the boards: no lens, nothing in the way.
LaneSight sight_of(const FloorPose& eye, const std::vector<Board>& boards) {
  LaneSight sight;
  for (const Board& one : boards) {
    const Eigen::Vector2d way = one.pose.position - eye.position;
    const Eigen::Vector2d ahead = eye.ahead();
    const double x = ahead.dot(way);
    const double y = ahead.x() * way.y() - ahead.y() * way.x();
    if (way.norm() > 1.8 || x < 0.15 || std::abs(std::atan2(y, x)) > 0.5) continue;
    if (way.dot(one.pose.ahead()) < 0.35 * way.norm()) continue;
    sight.boards.push_back(board(one.side, x, y));
  }
  std::ranges::sort(sight.boards, std::ranges::greater{}, &BoardSight::size);
  return sight;
}

/// Drives a car that is an equation for `seconds`; the most that its middle was off the lane's,
/// and how far it came.
struct Drive {
  double worst = 0.0;
  double distance = 0.0;
};
template <class MakePolicy>
Drive drive_lane(std::uint64_t seed, MakePolicy&& make_policy, double seconds = 45.0) {
  const Random random = Random(7).fork("course", seed);
  const RoomPlan plan = {
      .kind = "test", .half_extent = {5.0, 4.5}, .obstacles = {{{0.4, 0.2}, {0.5, 0.35}, 0.4}}};
  const LaneConfig config;
  const Lane lane = lay_lane(config, plan, random);
  const std::vector<Board> boards = stand_boards(lane, config.spacing);
  Bicycle car({lane.beside(0.0, 0.05), lane.at(0.0).yaw + 0.05}, random);
  LaneSight shown;
  auto policy = make_policy(shown, random);
  const Limits limits;
  Frame frame;
  frame.size = {.width = 320, .height = 240};
  std::deque<LaneSight> pictures;
  Command command;
  Drive drive;
  double along = lane.nearest(car.pose().position).along;
  for (double time = 0.0; time < seconds; time += 0.04) {
    pictures.push_back(sight_of(car.pose(), boards));
    if (pictures.size() > 3) pictures.pop_front();
    shown = pictures.front();
    frame.time = Seconds{time};
    Annotations annotations;
    command = limits.apply(policy.act({.frame = frame, .last = command}, annotations), command,
                           Seconds{0.04});
    for (int i = 0; i < 8; ++i) car.step(command);
    const Lane::Place place = lane.nearest(car.pose().position);
    drive.distance += std::remainder(place.along - along, lane.length());
    along = place.along;
    drive.worst = std::max(drive.worst, std::abs(place.offset));
  }
  return drive;
}

TEST(LaneTeacher, KeepsUnseenLanes) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Drive drive = drive_lane(seed, [](LaneSight& sight, const Random& random) {
      return LaneTeacher({}, sight, random.fork("teacher"));
    });
    EXPECT_LT(drive.worst, 0.25) << seed;
    EXPECT_GT(drive.distance, 9.0) << seed;
  }
}

TEST(LaneTeacher, TheTaskHasTeeth) {
  for (const Command& command : {Command{0.0, 0.2}, Command{0.2, 0.2}}) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
      EXPECT_GT(drive_lane(seed, [&](LaneSight&, const Random&) { return ConstantPolicy(command); })
                    .worst,
                0.3)
          << seed;
    }
  }
}

TEST(LaneTeacherConfig, NamesTheFieldThatMakesNoSense) {
  EXPECT_NO_THROW(LaneTeacherConfig{}.validate());
  EXPECT_THROW(LaneTeacherConfig{.least = 0.5}.validate(), std::invalid_argument);
  EXPECT_THROW(LaneTeacherConfig{.half_width = 0.0}.validate(), std::invalid_argument);
}

template <bool seen>
struct LaneTeacherFactory {
  struct WithSight final : Policy {
    WithSight() : teacher({}, sight, Random(11)) {
      if (seen) sight = straight(0.1);
    }
    Command act(const Observation& observation, Annotations& annotations) override {
      return teacher.act(observation, annotations);
    }
    Driver driver() const override { return teacher.driver(); }
    LaneSight sight;
    LaneTeacher teacher;
  };
  std::unique_ptr<Policy> operator()() const { return std::make_unique<WithSight>(); }
};

}  // namespace
}  // namespace pacer::sim

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(SeeingLaneTeacher, PolicyContract, sim::LaneTeacherFactory<true>);
INSTANTIATE_TYPED_TEST_SUITE_P(BlindLaneTeacher, PolicyContract, sim::LaneTeacherFactory<false>);
}  // namespace pacer::testing
