// SPDX-License-Identifier: Apache-2.0
// The camera's imperfections, each against what it should be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "sim/chassis.h"
#include "sim/exposure.h"
#include "sim/lens.h"
#include "sim/motion_blur.h"
#include "sim/radio_link.h"
#include "sim/sensor.h"

namespace pacer::sim {
namespace {

constexpr ImageSize kSize{.width = 320, .height = 240};

Lens lens(double distortion) {
  return {{.view_angle = {62.0, 62.0}, .distortion = {distortion, distortion}}, kSize, Random{1}};
}

Frame grey(std::uint8_t level) {
  Frame frame;
  frame.size = kSize;
  frame.rgb.assign(static_cast<std::size_t>(kSize.width * kSize.height) * 3, level);
  return frame;
}

std::vector<Eigen::Vector2f> still() { return std::vector<Eigen::Vector2f>(16 * 30, {0, 0}); }

std::uint8_t level_at(const Frame& frame, int x, int y) {
  return frame.rgb[static_cast<std::size_t>(y * kSize.width + x) * 3];
}

/// Middle of what is brighter than black.
Eigen::Vector2d middle_of_light(const Frame& frame) {
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double light = 0.0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      sum += level_at(frame, x, y) * Eigen::Vector2d(x, y);
      light += level_at(frame, x, y);
    }
  }
  return sum / light;
}

TEST(Lens, WithoutDistortionIsAPinhole) {
  const Lens ideal = lens(0.0);
  EXPECT_NEAR(ideal.focal(), 160.0 / std::tan(radians(31.0)), 1e-9);
  const Eigen::Vector2d pixel = ideal.project({0.3, -0.2, 1.5});
  EXPECT_NEAR(pixel.x(), 159.5 + ideal.focal() * 0.2, 1e-9);
  EXPECT_NEAR(pixel.y(), 119.5 - ideal.focal() * 0.2 / 1.5, 1e-9);
}

TEST(Lens, RaysGoThroughThePointsThatTheyProject) {
  const Lens barrel = lens(-0.07);
  Random random(4);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector2d pixel{random.uniform(0.0, 319.0), random.uniform(0.0, 239.0)};
    EXPECT_NEAR((barrel.project(2.5 * barrel.ray(pixel)) - pixel).norm(), 0.0, 1e-6);
  }
}

TEST(Lens, WithBarrelDistortionDrawsTheCornersIn) {
  EXPECT_LT(lens(-0.07).project({0.5, 0.3, 1.0}).x(), lens(0.0).project({0.5, 0.3, 1.0}).x());
}

TEST(Lens, HasASourceForEveryPixel) {
  for (const double distortion : {-0.1, -0.03, 0.0, 0.1}) {
    const Lens any = lens(distortion);
    for (const double x : {0.0, 160.0, 319.0}) {
      for (const double y : {0.0, 120.0, 239.0}) {
        const Eigen::Vector2d source = any.source({x, y});
        EXPECT_GE(source.minCoeff(), 2.0);
        EXPECT_LE(source.x(), 317.0);
        EXPECT_LE(source.y(), 237.0);
      }
    }
  }
}

TEST(Sensor, PutsAPointWhereTheLensSays) {
  const Lens barrel = lens(-0.06);
  Sensor sensor(barrel, 0.0, Random{1});
  for (const Eigen::Vector3d& point :
       {Eigen::Vector3d(0.1, 0.1, 1.0), Eigen::Vector3d(-0.5, 0.35, 1.0),
        Eigen::Vector3d(0.52, -0.36, 1.0)}) {
    // A blurred spot of light where the rendered picture has the point.
    const Eigen::Vector2d at = barrel.centre() + barrel.rendered_focal() * point.head<2>();
    Frame rendered = grey(0);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        const double light = 200.0 * std::exp(-0.2 * (Eigen::Vector2d(x, y) - at).squaredNorm());
        std::fill_n(rendered.rgb.begin() + (y * kSize.width + x) * 3, 3,
                    static_cast<std::uint8_t>(light));
      }
    }
    Frame out;
    sensor.expose(rendered, still(), 1.0, out);
    EXPECT_NEAR((middle_of_light(out) - barrel.project(point)).norm(), 0.0, 0.3);
  }
}

TEST(Sensor, KeepsAnEvenPictureEvenAndMultipliesByTheGain) {
  Sensor sensor(lens(-0.05), 0.0, Random{1});
  std::vector<Eigen::Vector2f> field = still();
  for (std::size_t i = 0; i < field.size(); ++i)
    field[i] = {0.04F * static_cast<float>(i % 200), 1.0F};
  Frame out;
  sensor.expose(grey(80), field, 1.5, out);
  for (const std::uint8_t level : out.rgb) ASSERT_NEAR(level, 120, 1);
  sensor.expose(grey(200), field, 2.0, out);
  for (const std::uint8_t level : out.rgb) ASSERT_EQ(level, 255);
}

TEST(Sensor, HasTheNoiseItWasGiven) {
  Sensor sensor(lens(-0.05), 3.0, Random{1});
  Frame out;
  sensor.expose(grey(100), still(), 1.0, out);
  double sum = 0.0;
  double squares = 0.0;
  for (const std::uint8_t level : out.rgb) {
    sum += level - 100.0;
    squares += (level - 100.0) * (level - 100.0);
  }
  const auto count = static_cast<double>(out.rgb.size());
  EXPECT_NEAR(sum / count, 0.0, 0.6);
  EXPECT_NEAR(std::sqrt(squares / count), 3.0, 0.25);
  Frame next;
  sensor.expose(grey(100), still(), 1.0, next);
  EXPECT_NE(out.rgb, next.rgb);
}

TEST(Sensor, SmearsAnEdgeAcrossTheWayItMoved) {
  Sensor sensor(lens(0.0), 0.0, Random{1});
  Frame rendered = grey(0);
  for (std::size_t i = 0; i < rendered.rgb.size(); ++i) {
    if (i / 3 % 320 >= 160) rendered.rgb[i] = 200;
  }
  const auto width_of_edge = [&](float moved) {
    std::vector<Eigen::Vector2f> field(16 * 30, {moved, 0.0F});
    Frame out;
    sensor.expose(rendered, field, 1.0, out);
    int between = 0;
    for (int x = 0; x < 320; ++x) {
      const int level = level_at(out, x, 120);
      between += level > 5 && level < 195 ? 1 : 0;
    }
    return between;
  };
  EXPECT_LE(width_of_edge(0.0F), 3);
  EXPECT_NEAR(width_of_edge(3.0F), 4, 1);
  EXPECT_NEAR(width_of_edge(8.0F), 8, 2);
  EXPECT_NEAR(width_of_edge(-8.0F), 8, 2);
}

/// What the sensor is to do, in floating point and a pixel at a time.
TEST(Sensor, IsTheMeanOfWhatPassesEachPixel) {
  const Lens barrel = lens(-0.05);
  Sensor sensor(barrel, 0.0, Random{1});
  Frame rendered = grey(0);
  const auto level = [](double x, double y) {
    return 120.0 + 60.0 * std::sin(x / 9.0) + 50.0 * std::sin(y / 7.0 + x / 23.0);
  };
  for (std::size_t i = 0; i < rendered.rgb.size(); ++i) {
    const auto x = static_cast<double>(i / 3 % 320);
    const auto y = static_cast<double>(i / 3 / 320);
    rendered.rgb[i] = static_cast<std::uint8_t>(std::lround(level(x, y)));
  }
  for (const Eigen::Vector2f& moved :
       {Eigen::Vector2f{0.0F, 0.0F}, Eigen::Vector2f{1.5F, -1.0F}, Eigen::Vector2f{-4.0F, 2.0F},
        Eigen::Vector2f{9.0F, 3.0F}, Eigen::Vector2f{-2.0F, -10.0F}}) {
    Frame out;
    sensor.expose(rendered, std::vector<Eigen::Vector2f>(16 * 30, moved), 0.8, out);
    for (int y = 20; y < 220; y += 3) {
      for (int x = 20; x < 300; x += 7) {
        const Eigen::Vector2d from = barrel.source({x, y});
        double mean = 0.0;
        constexpr int kSamples = 64;
        for (int i = 0; i < kSamples; ++i) {
          const Eigen::Vector2d at = from + (i + 0.5) / kSamples * moved.cast<double>();
          mean += level(at.x(), at.y()) / kSamples;
        }
        ASSERT_NEAR(level_at(out, x, y), 0.8 * mean, 7.0) << x << ", " << y << ", " << moved;
      }
    }
  }
}

/// The field is what the projection of points does in the shutter's time, to first order.
TEST(MotionBlur, IsTheMotionOfProjectedPoints) {
  const Lens barrel = lens(-0.05);
  MotionBlur blur(barrel, {4.0, 3.0}, 2.5);
  CameraMotion motion;
  motion.world_from_camera.linear() << 0, 0, 1, -1, 0, 0, 0, -1, 0;  // looks along world x
  motion.world_from_camera.translation() = Eigen::Vector3d(0.5, 0.2, 0.16);
  motion.velocity = Eigen::Vector3d(0.05, 0.02, 1.2);
  motion.turning = Eigen::Vector3d(0.1, -1.5, 0.2);
  const Seconds shutter{0.01};
  const auto field = blur.field(motion, shutter);
  for (const int tile : {0, 8, 200, 247, 303, 400, 479}) {
    const Eigen::Vector2d pixel{tile % 16 * 20 + 9.5, tile / 16 * 8 + 3.5};
    const Eigen::Vector3d ray = barrel.ray(pixel);
    const Eigen::Vector3d way = motion.world_from_camera.linear() * ray;
    const Eigen::Vector3d eye = motion.world_from_camera.translation();
    double depth = std::min((std::copysign(4.0, way.x()) - eye.x()) / way.x(),
                            (std::copysign(3.0, way.y()) - eye.y()) / way.y());
    depth = std::min(depth, ((way.z() > 0 ? 2.5 : 0.0) - eye.z()) / way.z());
    const Eigen::Vector3d point = depth * ray;
    const double dt = 1e-5;
    const Eigen::Vector3d later = point - dt * (motion.velocity + motion.turning.cross(point));
    const Eigen::Vector2d moved =
        barrel.rendered_focal() * (later.head<2>() / later.z() - ray.head<2>()) * (0.01 / dt);
    EXPECT_NEAR((field[static_cast<std::size_t>(tile)].cast<double>() - moved).norm(), 0.0, 0.05)
        << tile;
  }
}

TEST(Exposure, ComesToItsTargetAtItsTimeConstant) {
  const ExposureConfig config{
      .target = 112.0, .time_constant = Seconds{0.8}, .first_gain = {0.8, 0.8}};
  Exposure exposure(config, Random{1});
  const Frame dim = grey(100);
  EXPECT_NEAR(exposure.meter(dim, Seconds{0.04}), 0.8 * 1.12, 1e-9);
  double gain = 0.0;
  for (int i = 0; i < 20; ++i) gain = exposure.meter(dim, Seconds{0.04});
  EXPECT_NEAR(gain, 1.12 * (1.0 - 0.2 * std::exp(-1.0)), 1e-6);
}

TEST(Exposure, StaysWithinItsGains) {
  Exposure exposure({.first_gain = {1.0, 1.0}}, Random{1});
  EXPECT_NEAR(exposure.meter(grey(10), Seconds{0.04}), ExposureConfig{}.most_gain, 1e-9);
  Exposure bright({.first_gain = {1.0, 1.0}}, Random{1});
  EXPECT_NEAR(bright.meter(grey(255), Seconds{0.04}), ExposureConfig{}.least_gain, 1e-9);
}

TEST(RadioLink, SpoilsTheShareOfFramesItIsGivenInBursts) {
  constexpr int kFrames = 100000;
  const RadioLinkConfig plain;
  for (const double share : {plain.corrupted, 0.5, 0.9, 1.0}) {
    RadioLinkConfig config;
    config.corrupted = share;
    RadioLink link(config, kSize, Random{1});
    Frame frame = grey(50);
    int spoilt = 0;
    int bursts = 0;
    bool before = false;
    for (int i = 0; i < kFrames; ++i) {
      const bool now = !link.transmit(frame).empty();
      spoilt += now ? 1 : 0;
      bursts += now && !before ? 1 : 0;
      before = now;
    }
    EXPECT_NEAR(spoilt, share * kFrames, 0.0025 * kFrames) << share;
    // Of nine spoilt frames in ten a burst is nine long: one good frame ends it.
    const double length = share == 1.0 ? kFrames : share == 0.9 ? 9.0 : plain.burst_frames;
    EXPECT_NEAR(static_cast<double>(spoilt) / bursts, length, 0.16 * length) << share;
  }
}

TEST(RadioLink, LeavesTheRowsAloneThatItDoesNotReport) {
  RadioLink link({.corrupted = 0.4, .whole = 0.2}, kSize, Random{2});
  Frame clean = grey(0);
  for (std::size_t i = 0; i < clean.rgb.size(); ++i) {
    clean.rgb[i] = static_cast<std::uint8_t>(i * 7 % 251);
  }
  int whole = 0;
  int bands = 0;
  for (int i = 0; i < 200; ++i) {
    Frame frame = clean;
    std::vector<bool> covered(240, false);
    for (const RowBand& band : link.transmit(frame)) {
      ASSERT_LT(band.first, band.last);
      for (int y = band.first; y < band.last; ++y) covered[static_cast<std::size_t>(y)] = true;
    }
    const auto count = std::count(covered.begin(), covered.end(), true);
    whole += count == 240 ? 1 : 0;
    bands += count > 0 && count < 240 ? 1 : 0;
    for (std::size_t y = 0; y < 240; ++y) {
      const auto row = [y](const Frame& f) { return f.rgb.begin() + static_cast<long>(y * 960); };
      EXPECT_TRUE(covered[y] || std::equal(row(frame), row(frame) + 960, row(clean))) << y;
    }
  }
  EXPECT_GT(whole, 0);
  EXPECT_GT(bands, 0);
}

TEST(RadioLink, IsQuietWhenSwitchedOff) {
  RadioLink link({.corrupted = 0.0}, kSize, Random{1});
  Frame frame = grey(50);
  for (int i = 0; i < 1000; ++i) ASSERT_TRUE(link.transmit(frame).empty());
  EXPECT_EQ(frame.rgb, grey(50).rgb);
}

}  // namespace
}  // namespace pacer::sim
