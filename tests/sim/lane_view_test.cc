// SPDX-License-Identifier: Apache-2.0
#include "sim/lane_view.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/channels.h"
#include "sim/lane_teacher.h"
#include "sim/sim_car.h"

namespace pacer::sim {
namespace {

/// A lane on a bare floor, a picture without interference.
SimCarConfig lane_on_a_bare_floor() {
  SimCarConfig config;
  config.duration = Seconds{2.0};
  config.world.furnished = false;
  config.world.lead = false;
  config.world.balloons = false;
  config.world.layout = "lane";
  config.world.room.length = config.world.room.width = {12.0, 12.0};
  config.camera.link.corrupted = 0.0;
  return config;
}

TEST(LaneView, ShowsBoardsOfBothSidesWhereTheyStand) {
  int left = 0;
  int right = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    SimCar car(lane_on_a_bare_floor(), Random{seed});
    ASSERT_NE(car.look(), nullptr);
    const FloorPose& pose = car.truth().car_pose;
    double farther = 1e9;
    for (const BoardSight& sight : car.lane_sight().boards) {
      (sight.side == LaneSide::kLeft ? left : right) += 1;
      EXPECT_LE(sight.size, farther) << "nearest first";
      farther = sight.size;
      EXPECT_LT(sight.low.x(), sight.high.x());
      EXPECT_LT(sight.low.y(), sight.high.y());
      // A board of this side stands where bearing and size say.
      const double distance = Board::kHeight / sight.size;
      double least = 1e9;
      for (const Board& board : car.world().boards()) {
        if (board.side != sight.side) continue;
        const Eigen::Vector2d way = board.pose.position - pose.position;
        const double bearing = wrapped(std::atan2(way.y(), way.x()) - pose.yaw);
        least = std::min(
            least, std::hypot(way.norm() - distance, distance * wrapped(bearing - sight.bearing)));
      }
      EXPECT_LT(least, 0.1) << seed;
    }
  }
  EXPECT_GT(left, 8);
  EXPECT_GT(right, 8);
}

TEST(LaneView, CoveredRowsShowNoBoard) {
  SimCarConfig config = lane_on_a_bare_floor();
  config.camera.link = {.corrupted = 0.5, .burst_frames = 3.0, .whole = 1.0};
  SimCar car(config, Random{5});
  int spoilt = 0;
  int clear = 0;
  while (car.look() != nullptr) {
    const bool covered = car.truth().corrupted_rows > 0.0;
    EXPECT_EQ(car.lane_sight().boards.empty(), covered);
    (covered ? spoilt : clear) += 1;
  }
  EXPECT_GT(spoilt, 3);
  EXPECT_GT(clear, 3);
}

/// One board ahead of a camera, on a floor, and what `more` adds.
LaneSight look_at_a_board(double yaw, const std::string& more) {
  const std::string xml = R"(<mujoco><worldbody><geom type="plane" size="5 5 1"/>
      <body name="car"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        <camera name="eye" pos="0 0 .16" xyaxes="0 -1 0 0 0 1"/></body>)" +
                          more + "</worldbody></mujoco>";
  std::array<char, 500> error{};
  mjSpec* const spec =
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size()));
  EXPECT_NE(spec, nullptr) << error.data();
  mjModel* const model = mj_compile(spec, nullptr);
  mjData* const data = mj_makeData(model);
  mj_forward(model, data);
  LaneView view(*model, 0, {{LaneSide::kRight, {{1.0, -0.2}, yaw}}},
                {.fx = 260.0,
                 .fy = 260.0,
                 .cx = 159.5,
                 .cy = 119.5,
                 .size = {.width = 320, .height = 240},
                 .lens = {}});
  LaneSight sight = view.look(*data);
  mj_deleteData(data);
  mj_deleteModel(model);
  mj_deleteSpec(spec);
  return sight;
}

TEST(LaneView, ABoardIsSeenWhereThePinholePutsIt) {
  const LaneSight sight = look_at_a_board(0.0, "");
  ASSERT_EQ(sight.boards.size(), 1U);
  const BoardSight& board = sight.boards.front();
  EXPECT_EQ(board.side, LaneSide::kRight);
  EXPECT_NEAR(board.bearing, std::atan2(-0.2, 1.0), 0.01);
  EXPECT_NEAR(Board::kHeight / board.size, std::hypot(1.0, 0.2), 0.03);
  EXPECT_GT(board.low.x(), 159.5 + 260.0 * 0.15);
  EXPECT_LT(board.high.x(), 159.5 + 260.0 * 0.25);
}

TEST(LaneView, ABoardFromBehindFromTheSideOrHiddenIsNotSeen) {
  EXPECT_TRUE(look_at_a_board(std::numbers::pi, "").boards.empty());
  EXPECT_TRUE(look_at_a_board(0.5 * std::numbers::pi, "").boards.empty());
  const char* const box = R"(<geom type="box" size=".02 .3 .3" pos=".6 0 .3" group="1"/>)";
  EXPECT_TRUE(look_at_a_board(0.0, box).boards.empty());
  const char* const touched = R"(<geom type="box" size=".02 .3 .3" pos=".6 0 .3" group="3"/>)";
  EXPECT_EQ(look_at_a_board(0.0, touched).boards.size(), 1U) << "it is not drawn";
}

TEST(LaneView, TheLaneIsTheSameForTheSameSeed) {
  const auto drive = [](std::uint64_t seed) {
    SimCar car(lane_on_a_bare_floor(), Random{seed});
    std::vector<std::uint8_t> bytes;
    std::vector<float> signals;
    LaneTeacher teacher({}, car.lane_sight(), Random{seed});
    Annotations annotations;
    for (const Frame* frame = car.look(); frame != nullptr; frame = car.look()) {
      bytes.insert(bytes.end(), frame->rgb.begin(), frame->rgb.end());
      signals.insert(signals.end(), car.signals().begin(), car.signals().end());
      car.send(Channels{}.encode(teacher.act({.frame = *frame, .last = {}}, annotations)));
    }
    return std::pair(bytes, signals);
  };
  const auto first = drive(1);
  EXPECT_EQ(first, drive(1));
  EXPECT_NE(first.first, drive(2).first);
}

TEST(LaneView, TheCarStartsInTheLaneAndTheTruthFollowsIt) {
  SimCarConfig config = lane_on_a_bare_floor();
  config.duration = Seconds{5.0};
  SimCar car(config, Random{4});
  ASSERT_NE(car.look(), nullptr);
  EXPECT_LE(std::abs(car.truth().lane.offset), 0.12);
  EXPECT_EQ(car.truth().lane.driven, 0.0);
  const std::size_t driven = offset_of(car.signal_columns(), "privileged.lane_driven");
  LaneTeacher teacher({}, car.lane_sight(), Random{4});
  Annotations annotations;
  double way = 0.0;
  for (const Frame* frame = car.look(); frame != nullptr; frame = car.look()) {
    car.send(Channels{}.encode(teacher.act({.frame = *frame, .last = {}}, annotations)));
    way += 0.04 * car.truth().car_speed;
    EXPECT_EQ(car.signals()[driven], static_cast<float>(car.truth().lane.driven));
    EXPECT_FALSE(car.truth().collision);
  }
  EXPECT_GT(way, 0.8);
  EXPECT_NEAR(car.truth().lane.driven, way, 0.2 * way);
  EXPECT_NEAR(car.truth().lane.laps, car.truth().lane.driven / car.world().lane().length(), 1e-9);
}

TEST(LaneView, RefusesALeadInALane) {
  SimCarConfig config = lane_on_a_bare_floor();
  config.world.lead = true;
  EXPECT_THROW(SimCar(config, Random{1}), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::sim
