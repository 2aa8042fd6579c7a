// SPDX-License-Identifier: Apache-2.0
#include "sim/sim_car.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "core/channels.h"
#include "tests/contract/car_contract.h"
#include "tests/sim/flat_floor.h"

namespace pacer::sim {
namespace {

using namespace std::chrono_literals;

/// A car alone on a bare floor: quick to make.
SimCarConfig alone() {
  SimCarConfig config;
  config.duration = Seconds{2.0};
  config.world.furnished = false;
  config.world.lead = false;
  config.world.balloons = false;
  return config;
}

/// A lead and its follower on a bare floor.
SimCarConfig pair() {
  SimCarConfig config = alone();
  config.world.lead = true;
  config.world.room.length = config.world.room.width = {12.0, 12.0};
  config.camera.link.corrupted = 0.0;
  return config;
}

struct SimCarFactory {
  std::unique_ptr<Car> operator()() const { return std::make_unique<SimCar>(alone(), Random{1}); }
};

}  // namespace
}  // namespace pacer::sim

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Sim, CarContract, pacer::sim::SimCarFactory);
}  // namespace pacer::testing

namespace pacer::sim {
namespace {

TEST(SimCar, ShowsTheSameFramesForTheSameSeed) {
  const auto drive = [](std::uint64_t seed) {
    SimCarConfig config = pair();
    config.camera.link.corrupted = 0.3;
    SimCar car(config, Random{seed});
    std::vector<std::uint8_t> bytes;
    std::vector<float> signals;
    for (const Frame* frame = car.look(); frame != nullptr; frame = car.look()) {
      bytes.insert(bytes.end(), frame->rgb.begin(), frame->rgb.end());
      signals.insert(signals.end(), car.signals().begin(), car.signals().end());
      car.send({1600us, 1650us});
    }
    return std::pair(bytes, signals);
  };
  const auto first = drive(1);
  EXPECT_EQ(first, drive(1));
  EXPECT_NE(first.first, drive(2).first);
}

TEST(SimCar, ShowsAllFramesOfItsDuration) {
  SimCar car(alone(), Random{1});
  int frames = 0;
  for (const Frame* frame = car.look(); frame != nullptr; frame = car.look(), ++frames) {
    EXPECT_EQ(frame->index, static_cast<std::uint64_t>(frames));
    EXPECT_NEAR(frame->time.count(), frames * 0.04, 1e-12);
  }
  EXPECT_EQ(frames, 50);
}

TEST(SimCar, IsAtAllTimesAnImageDelayAheadOfItsFrame) {
  SimCarConfig config = alone();
  config.camera.delay = {0.083, 0.083};  // rounded up to a time step of 5 ms
  SimCar car(config, Random{1});
  ASSERT_NE(car.look(), nullptr);
  const double start = car.world().data().time;
  for (int i = 1; i < 10; ++i) {
    ASSERT_NE(car.look(), nullptr);
    EXPECT_NEAR(car.world().data().time - start, 0.04 * i, 1e-9);
  }
  SimCarConfig sooner = config;
  sooner.camera.delay = {0.04, 0.04};
  SimCar early(sooner, Random{1});
  ASSERT_NE(early.look(), nullptr);
  EXPECT_NEAR(start - early.world().data().time, 0.085 - 0.04, 1e-9);
}

/// A command changes the first frame whose shutter closes later than both delays allow.
TEST(SimCar, FeelsACommandAfterCommandAndImageDelay) {
  SimCarConfig config = alone();
  config.camera.delay = {0.08, 0.08};
  config.command_delay = {0.02, 0.02};
  SimCar car(config, Random{1});
  ASSERT_NE(car.look(), nullptr);
  car.send({1500us, 2000us});  // at 0.08 s; at the motor at 0.10 s
  double moved_at = 0.0;
  for (const Frame* frame = car.look(); frame != nullptr; frame = car.look()) {
    if (car.truth().car_speed > 0.01) {
      moved_at = frame->time.count();
      break;
    }
  }
  EXPECT_NEAR(moved_at, 0.12, 1e-9);
}

TEST(SimCar, StandsUntilTheFirstPulse) {
  SimCar car(alone(), Random{1});
  while (car.look() != nullptr) EXPECT_NEAR(car.truth().car_speed, 0.0, 1e-3);
}

TEST(SimCar, TellsWhatItsSignalColumnsSay) {
  SimCar car(pair(), Random{3});
  ASSERT_NE(car.look(), nullptr);
  const auto value = [&car](std::string_view name, std::size_t component) {
    return car.signals()[offset_of(car.signal_columns(), name) + component];
  };
  const Privileged& truth = car.truth();
  EXPECT_FLOAT_EQ(value("privileged.car_pose", 2), static_cast<float>(truth.car_pose.yaw));
  EXPECT_FLOAT_EQ(value("privileged.lead_pose", 0),
                  static_cast<float>(truth.lead_pose.position.x()));
  EXPECT_FLOAT_EQ(value("privileged.lead_box", 3), static_cast<float>(truth.box_high.y()));
  EXPECT_FLOAT_EQ(value("privileged.lead_distance", 0), static_cast<float>(truth.lead_distance));
  EXPECT_EQ(value("privileged.room_kind", 0), -1.0F);
  EXPECT_EQ(value("privileged.collision", 0), 0.0F);
}

TEST(SimCar, StartsBehindTheLeadWithTheLeadInView) {
  SimCar car(pair(), Random{5});
  ASSERT_NE(car.look(), nullptr);
  const Privileged& truth = car.truth();
  EXPECT_NEAR(truth.lead_distance, 1.2, 0.25);
  EXPECT_NEAR(truth.lead_bearing, 0.0, 0.25);
  EXPECT_TRUE(car.lead_sight().seen);
  EXPECT_EQ(truth.lead_in_view, 1.0);
  EXPECT_GT(truth.lead_visible, 0.2);
  EXPECT_GT(truth.box_high.x() - truth.box_low.x(), 20.0);
  EXPECT_LE(car.lead_sight().low.x(), car.lead_sight().high.x());
}

TEST(SimCar, SeesNothingThroughALinkThatIsDown) {
  SimCarConfig config = pair();
  config.camera.link = {.corrupted = 0.5, .burst_frames = 3.0, .whole = 1.0};
  SimCar car(config, Random{5});
  int spoilt = 0;
  while (car.look() != nullptr) {
    if (car.truth().corrupted_rows == 0.0) continue;
    ++spoilt;
    EXPECT_EQ(car.truth().corrupted_rows, 1.0);
    EXPECT_FALSE(car.lead_sight().seen);
    EXPECT_EQ(car.truth().lead_visible, 0.0);
  }
  EXPECT_GT(spoilt, 0);
}

TEST(SimCar, ReportsACollisionWithTheLead) {
  SimCarConfig config = pair();
  config.duration = Seconds{6.0};
  SimCar car(config, Random{5});
  bool hit = false;
  while (!hit && car.look() != nullptr) {
    const double wheel = std::clamp(2.0 * car.truth().lead_bearing, -1.0, 1.0);
    car.send(Channels{}.encode({.steering = wheel, .throttle = 1.0}));
    hit = car.truth().collision;
  }
  EXPECT_TRUE(hit);
  EXPECT_LT(car.truth().lead_distance, 0.7);
}

TEST(SimCar, LeadDrivesItsRoute) {
  SimCarConfig config = pair();
  config.duration = Seconds{8.0};
  SimCar car(config, Random{7});
  double way = 0.0;
  while (car.look() != nullptr) way += 0.04 * car.truth().lead_speed;
  EXPECT_GT(way, 1.5);
  EXPECT_LT(way, 8.0);
  testing::expect_no_warnings(car.world().data());
}

TEST(SimCar, SeveralDriveSideBySideAsEachWouldAlone) {
  const auto pictures = [](SimCar& car) {
    std::vector<std::uint8_t> bytes;
    for (int i = 0; i < 3; ++i) {
      const Frame* const frame = car.look();
      bytes.insert(bytes.end(), frame->rgb.begin(), frame->rgb.end());
    }
    return bytes;
  };
  SimCar lone(alone(), Random{1});
  const std::vector<std::uint8_t> expected = pictures(lone);
  SimCar one(alone(), Random{1});
  SimCar other(alone(), Random{2});
  const Frame* const first_of_other = other.look();
  ASSERT_NE(first_of_other, nullptr);
  EXPECT_EQ(pictures(one), expected);
}

TEST(SimCar, VariesFromSeedToSeedWhatIsRandomised) {
  std::set<double> fovys;
  std::set<double> masses;
  for (std::uint64_t seed = 0; seed < 4; ++seed) {
    SimCar car(alone(), Random{seed});
    const mjModel& model = car.world().model();
    fovys.insert(model.cam_fovy[car.world().camera()]);
    masses.insert(model.body_mass[car.world().car().body()]);
  }
  EXPECT_EQ(fovys.size(), 4U);
  EXPECT_EQ(masses.size(), 4U);
}

TEST(SimCar, RunsAtOtherRatesAndSizes) {
  SimCarConfig config = alone();
  config.camera.frame_rate_hz = 30.0;
  config.camera.width = 403;
  config.camera.height = 301;
  SimCar car(config, Random{1});
  int frames = 0;
  for (const Frame* frame = car.look(); frame != nullptr; frame = car.look(), ++frames) {
    EXPECT_EQ(frame->size, (ImageSize{.width = 403, .height = 301}));
  }
  EXPECT_EQ(frames, 60);
}

TEST(SimCarConfig, NamesTheFieldThatIsWrong) {
  SimCarConfig config = alone();
  config.command_delay = {0.2, 0.1};
  try {
    SimCar car(config, Random{1});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("command_delay_s"), std::string::npos);
  }
}

/// A car, and balloons in the open, on a bare floor.
SimCarConfig with_balloons() {
  SimCarConfig config = alone();
  config.world.balloons = true;
  config.world.layout = "balloons";
  config.world.room.length = config.world.room.width = {12.0, 12.0};
  config.camera.link.corrupted = 0.0;
  return config;
}

TEST(SimCar, TellsWhereTheBalloonsAreAndWhatIsSeenOfThem) {
  int seen = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    SimCar car(with_balloons(), Random{seed});
    const std::size_t pixels = offset_of(car.signal_columns(), "privileged.green_pixels");
    ASSERT_NE(car.look(), nullptr);
    const Privileged& truth = car.truth();
    EXPECT_EQ(car.signals()[pixels], static_cast<float>(car.balloon_sights().green.pixels));
    for (const BalloonTruth& balloon : {truth.red, truth.green}) {
      const Eigen::Vector2d way = balloon.position - truth.car_pose.position;
      EXPECT_NEAR(balloon.distance, way.norm(), 0.03);
      EXPECT_NEAR(wrapped(balloon.bearing + truth.car_pose.yaw - std::atan2(way.y(), way.x())), 0.0,
                  0.06);
      const bool ahead = std::abs(balloon.bearing) < 0.4;
      if (std::abs(balloon.bearing) > 0.75) {
        EXPECT_EQ(balloon.sight.pixels, 0);
      }
      if (!ahead) continue;
      ++seen;
      ASSERT_GT(balloon.sight.pixels, 30) << seed;
      const double focal = 160.0 / std::tan(0.5 * 62.0 / 180.0 * std::numbers::pi);
      EXPECT_NEAR(std::atan2(159.5 - balloon.sight.centroid.x(), focal), balloon.bearing, 0.04);
    }
  }
  EXPECT_GT(seen, 2);
}

TEST(SimCar, ABalloonUnderInterferenceIsNotSeen) {
  SimCarConfig config = with_balloons();
  config.camera.link.corrupted = 0.5;
  config.camera.link.whole = 1.0;
  SimCar car(config, Random{3});
  int covered = 0;
  while (car.look() != nullptr) {
    const BalloonSights& sights = car.balloon_sights();
    EXPECT_EQ(sights.spoilt_rows > 0, car.truth().corrupted_rows > 0.0);
    if (sights.spoilt_rows == 0) continue;
    ++covered;
    EXPECT_EQ(sights.red.pixels + sights.green.pixels, 0);
  }
  EXPECT_GT(covered, 5);
}

TEST(SimCar, WhereThereIsALeadItTellsOfTheLead) {
  SimCar car(pair(), Random{1});
  ASSERT_NE(car.look(), nullptr);
  EXPECT_EQ(car.signals().size(), 19U);
  EXPECT_NO_THROW((void)offset_of(car.signal_columns(), "privileged.lead_box"));
  EXPECT_THROW((void)offset_of(car.signal_columns(), "privileged.red_pixels"), std::runtime_error);
}

TEST(SimCar, RefusesALayoutThatTheWorldCannotHave) {
  SimCarConfig config = with_balloons();
  config.world.lead = true;
  EXPECT_THROW(SimCar(config, Random{1}), std::invalid_argument);
  config = with_balloons();
  config.world.balloons = false;
  EXPECT_THROW(SimCar(config, Random{1}), std::invalid_argument);
  config.world.layout = "heap";
  EXPECT_THROW(SimCar(config, Random{1}), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::sim
