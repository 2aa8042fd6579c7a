// SPDX-License-Identifier: Apache-2.0
#include "sim/tour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/channels.h"
#include "sim/sim_car.h"

namespace pacer::sim {
namespace {

/// A bare floor without anybody else: quick to make.
SimCarConfig bare() {
  SimCarConfig config;
  config.duration = Seconds{2.0};
  config.world.furnished = false;
  config.world.lead = false;
  config.world.balloons = false;
  config.camera.link.corrupted = 0.0;
  return config;
}

TEST(StandingLead, StandsWhereItIsPut) {
  SimCarConfig config = bare();
  config.world.lead = true;
  config.world.room.length = config.world.room.width = {12.0, 12.0};
  config.world.layout = "standing";
  config.world.standing_lead.distance = 1.8;
  config.world.standing_lead.bearing = 15.0;
  SimCar car(config, Random{1});
  ASSERT_NE(car.look(), nullptr);
  const Privileged first = car.truth();
  const Eigen::Vector2d offset = first.lead_pose.position - first.car_pose.position;
  EXPECT_NEAR(offset.norm(), 1.8, 0.02);
  EXPECT_NEAR(wrapped(std::atan2(offset.y(), offset.x()) - first.car_pose.yaw),
              15.0 * std::numbers::pi / 180.0, 0.02);
  EXPECT_GT(first.lead_visible, 0.5);
  EXPECT_TRUE(car.world().route().points.empty());
  while (car.look() != nullptr) car.send(Channels{}.neutral());
  EXPECT_LT((car.truth().lead_pose.position - first.lead_pose.position).norm(), 0.01);
}

/// The same furnished room with and without a lead.
TEST(Lead, LeavesTheRoomAsItIsWithoutIt) {
  SimCarConfig config;
  config.duration = Seconds{0.2};
  config.camera.link.corrupted = 0.0;
  SimCar with(config, Random{6});
  config.world.lead = false;
  SimCar without(config, Random{6});
  ASSERT_NE(with.look(), nullptr);
  const Frame* frame = without.look();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(with.truth().car_pose.position, without.truth().car_pose.position);
  EXPECT_EQ(with.world().plan().obstacles.size(), without.world().plan().obstacles.size());
  EXPECT_GT(with.truth().lead_visible, 0.0);
  EXPECT_EQ(without.truth().lead_visible, 0.0);
  EXPECT_EQ(without.world().lead(), nullptr);
}

TEST(Tour, GoesThroughARoomWithoutALead) {
  SimCarConfig config;
  config.duration = Seconds{12.0};
  config.camera.width = 64;
  config.camera.height = 48;
  config.world.lead = false;
  SimCar car(config, Random{2});
  Tour tour(config.world.lead_driver, car);
  Annotations annotations;
  Command command;
  double off = 0.0;
  while (const Frame* frame = car.look()) {
    command = tour.act({.frame = *frame, .last = command}, annotations);
    car.send(Channels{}.encode(command));
    double nearest = 1e9;
    for (const RoutePoint& point : car.world().route().points) {
      nearest = std::min(nearest, (point.pose.position - car.truth().car_pose.position).norm());
    }
    off = std::max(off, nearest);
    EXPECT_FALSE(car.truth().collision);
  }
  const Eigen::Vector2d start = car.world().route().follower_start().position;
  EXPECT_GT((car.truth().car_pose.position - start).norm(), 1.0);
  EXPECT_LT(off, 0.25) << "metres off the way";
}

TEST(Tour, NeedsAWay) {
  SimCar car(bare(), Random{1});
  EXPECT_THROW(Tour({}, car), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::sim
