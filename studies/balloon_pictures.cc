// SPDX-License-Identifier: Apache-2.0
#include "studies/balloon_pictures.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "core/channels.h"
#include "sim/camera.h"
#include "sim/world.h"

namespace pacer {
namespace {

using Eigen::Vector2d;

constexpr Seconds kTimeStep{0.005};
constexpr int kSettling = 50;  // steps, until the car stands still on its wheels
constexpr int kDriving = 100;  // steps, before a picture is taken from a moving car

/// Where the balloons hang, red and green.
std::array<Vector2d, 2> balloons_of(const sim::World& world) {
  std::array<Vector2d, 2> places;
  const std::array<const char*, 2> names = {"red_balloon", "green_balloon"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    const int body = mj_name2id(&world.model(), mjOBJ_BODY, names[i]);
    if (body < 0) throw std::runtime_error("the scenario's world has no balloons to look for");
    const mjtNum* const at = world.data().xpos + 3 * body;
    places[i] = {at[0], at[1]};
  }
  return places;
}

/// Somewhere the car can stand.
Vector2d free_place(const sim::RoomPlan& plan, Random& random) {
  constexpr double kFree = 0.3;  // metres about the car
  Vector2d place = Vector2d::Zero();
  for (int attempt = 0; attempt < 1000; ++attempt) {
    place = {random.uniform(-plan.half_extent.x(), plan.half_extent.x()),
             random.uniform(-plan.half_extent.y(), plan.half_extent.y())};
    if (sim::clearance(plan, place) >= kFree) break;
  }
  return place;
}

sim::FloorPose pose_in(const sim::World& world, Random& random) {
  constexpr double kAim = 0.4;  // radians, to either side
  sim::FloorPose pose;
  pose.position = free_place(world.plan(), random);
  const Vector2d way = balloons_of(world).at(random.below(2)) - pose.position;
  pose.yaw = random.chance(0.5) ? std::atan2(way.y(), way.x()) + random.uniform(-kAim, kAim)
                                : random.uniform(-std::numbers::pi, std::numbers::pi);
  return pose;
}

void pass(sim::World& world, int steps, const Pulses& pulses) {
  for (int i = 0; i < steps; ++i) {
    world.observe();
    world.advance(pulses);
  }
}

/// The first world of `random`'s that has room for all that it is to hold.
void make_world(const sim::SimCarConfig& config, const sim::Lens& lens, const Random& random,
                std::optional<sim::World>& world) {
  constexpr std::uint64_t kTries = 8;
  for (std::uint64_t attempt = 0;; ++attempt) {
    try {
      world.emplace(config.world, kTimeStep, lens.rendered_fovy(), random.fork("world", attempt));
      return;
    } catch (const std::runtime_error&) {
      if (attempt + 1 == kTries) throw;
    }
  }
}

}  // namespace

void take_balloon_pictures(const sim::SimCarConfig& config, int count, const Random& random,
                           const std::function<void(const BalloonPicture&)>& take) {
  const sim::Lens lens(config.camera.lens, config.camera.size(), random.fork("lens"));
  std::optional<sim::World> world;
  make_world(config, lens, random, world);
  sim::Camera camera(config.camera, lens, *world, random.fork("camera"));
  Random poses = random.fork("poses");
  BalloonPicture picture;
  picture.room = world->plan().kind;
  for (int i = 0; i < count; ++i) {
    world->observe();
    if (i > 0) {
      world->car().place(world->data(), pose_in(*world, poses));
      pass(*world, kSettling, Channels{}.encode({}));
    }
    picture.moving = poses.chance(0.5);
    Command command;
    command.steering = poses.uniform(-1.0, 1.0);
    command.throttle = poses.uniform(0.1, 0.4);
    if (picture.moving) pass(*world, kDriving, Channels{}.encode(command));
    world->observe();
    const std::span<const sim::RowBand> spoilt = camera.take(*world, picture.frame);
    picture.truth = camera.balloons(*world, spoilt);
    take(picture);
  }
}

bool is_false_balloon(const Vector2d& centroid, double area, const sim::BalloonSight& truth) {
  constexpr double kMargin = 3.0;  // pixels
  if (truth.pixels == 0) return true;
  const bool inside = (centroid.array() >= truth.low.array() - kMargin).all() &&
                      (centroid.array() <= truth.high.array() + kMargin).all();
  return !inside || area > 2.0 * truth.pixels + 20.0;
}

}  // namespace pacer
