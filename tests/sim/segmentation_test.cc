// SPDX-License-Identifier: Apache-2.0
#include "sim/segmentation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sim/sensor.h"
#include "sim/world.h"

namespace pacer::sim {
namespace {

constexpr ImageSize kSize{.width = 160, .height = 120};

/// A car in a room, set down before a balloon; its camera.
class SegmentationTest : public testing::Test {
 protected:
  SegmentationTest()
      : lens_({}, kSize, Random{5}),
        world_(config(), Seconds{0.005}, lens_.rendered_fovy(), Random{11}),
        renderer_(world_.model(), World::kCamera, kSize),
        segmentation_(world_.model(), lens_) {}

  static WorldConfig config() {
    WorldConfig config;
    config.lead = false;
    return config;
  }

  /// Stands the car `distance` metres from the balloon, off its axis by `bearing` (radians).
  void stand_before(const char* balloon, double distance, double bearing, double from = 0.4) {
    const int body = mj_name2id(&world_.model(), mjOBJ_BODY, balloon);
    const Eigen::Vector2d at(world_.data().xpos[3 * body], world_.data().xpos[3 * body + 1]);
    const FloorPose pose{
        .position = at + distance * Eigen::Vector2d(std::cos(from), std::sin(from)),
        .yaw = from + M_PI - bearing};
    world_.car().place(world_.data(), pose);
    mj_forward(&world_.model(), &world_.data());
  }

  const BalloonSights& look(std::span<const RowBand> covered = {}) {
    return segmentation_.look(world_.model(), world_.data(), renderer_, covered);
  }

  /// By a ray through each pixel: what it meets first.
  Label met(int x, int y) {
    const mjModel& model = world_.model();
    const mjData& data = world_.data();
    const Eigen::Vector3d ray = lens_.ray({x, y});
    const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> axes(data.cam_xmat +
                                                                              9 * world_.camera());
    const Eigen::Vector3d way = axes * Eigen::Vector3d(ray.x(), -ray.y(), -1.0);
    constexpr std::array<mjtByte, mjNGROUP> kDrawn = {1, 1, 1, 0, 0, 0};
    int geom = -1;
    mj_ray(&model, &data, data.cam_xpos + 3 * world_.camera(), way.data(), kDrawn.data(), 1, -1,
           &geom, nullptr);
    if (geom < 0) return Label::kOther;
    const auto is = [&](const char* name) {
      // The hull, and the knot that hangs from it; not the string.
      const int hull = mj_name2id(&model, mjOBJ_GEOM, name);
      return model.geom_bodyid[geom] == model.geom_bodyid[hull] &&
             model.geom_type[geom] == mjGEOM_ELLIPSOID;
    };
    return is("red_balloon") ? Label::kRed : is("green_balloon") ? Label::kGreen : Label::kOther;
  }

  Label label(int x, int y) const {
    return segmentation_.labels()[static_cast<std::size_t>(y * kSize.width + x)];
  }

  Lens lens_;
  World world_;
  Renderer renderer_;
  Segmentation segmentation_;
};

TEST_F(SegmentationTest, ShowsWhatARayThroughEachPixelMeets) {
  int shown = 0;
  for (const char* balloon : {"red_balloon", "green_balloon"}) {
    for (const double bearing : {-0.45, 0.0, 0.2}) {
      stand_before(balloon, 1.1, bearing);
      (void)look();
      for (int y = 1; y + 1 < kSize.height; ++y) {
        for (int x = 1; x + 1 < kSize.width; ++x) {
          const Label is = label(x, y);
          if (is != Label::kOther) ++shown;
          // At an edge the nearest pixel may be the neighbour.
          bool inside = true;
          for (const int i : {-1, 0, 1}) {
            for (const int j : {-1, 0, 1}) inside = inside && label(x + i, y + j) == is;
          }
          const bool sampled = is != Label::kOther || (x + 7 * y) % 23 == 0;
          if (!inside || !sampled) continue;
          ASSERT_EQ(met(x, y), is) << balloon << " " << x << " " << y;
        }
      }
    }
  }
  EXPECT_GT(shown, 2000);
}

TEST_F(SegmentationTest, CountsItsPixelsAndNamesTheirMiddleAndBox) {
  stand_before("red_balloon", 1.0, 0.1);
  const BalloonSight red = look().red;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Vector2d low(1e9, 1e9), high(-1e9, -1e9);
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (label(x, y) != Label::kRed) continue;
      sum += Eigen::Vector3d(x, y, 1.0);
      low = low.cwiseMin(Eigen::Vector2d(x, y));
      high = high.cwiseMax(Eigen::Vector2d(x, y));
    }
  }
  ASSERT_GT(red.pixels, 200);
  EXPECT_EQ(red.pixels, sum.z());
  EXPECT_EQ(red.covered, 0);
  EXPECT_NEAR((red.centroid - sum.head<2>() / sum.z()).norm(), 0.0, 1e-9);
  EXPECT_EQ(red.low, low);
  EXPECT_EQ(red.high, high);
  EXPECT_LT(red.centroid.x(), 0.5 * kSize.width);  // a bearing to the left
}

TEST_F(SegmentationTest, WhatInterferenceCoversIsNotSeen) {
  stand_before("red_balloon", 1.0, 0.0);
  const BalloonSights clear = look();
  const int middle = static_cast<int>(clear.red.centroid.y());
  const std::vector<RowBand> half = {{.first = 0, .last = middle}};
  const BalloonSights spoilt = look(half);
  EXPECT_EQ(spoilt.spoilt_rows, middle);
  EXPECT_EQ(spoilt.red.pixels + spoilt.red.covered, clear.red.pixels);
  EXPECT_GT(spoilt.red.covered, 0);
  EXPECT_EQ(spoilt.red.low.y(), middle);
  const std::vector<RowBand> whole = {{.first = 0, .last = kSize.height}};
  EXPECT_EQ(look(whole).red.pixels, 0);
  EXPECT_EQ(look(whole).red.covered, clear.red.pixels);
}

TEST_F(SegmentationTest, ABalloonBehindTheCarIsNotSeen) {
  stand_before("red_balloon", 1.0, M_PI);
  EXPECT_EQ(look().red.pixels, 0);
}

TEST_F(SegmentationTest, LeavesThePictureAsItWas) {
  stand_before("green_balloon", 0.9, 0.0);
  Frame before, after;
  renderer_.render(world_.model(), world_.data(), before);
  EXPECT_GT(look().green.pixels, 0);
  renderer_.render(world_.model(), world_.data(), after);
  EXPECT_EQ(before.rgb, after.rgb);
}

TEST_F(SegmentationTest, SmoothEdgesMoveNoMoreThanTheEdge) {
  stand_before("red_balloon", 1.0, 0.1);
  const BalloonSight plain = look().red;
  Renderer fine(world_.model(), World::kCamera, kSize, {.quality = "fine"});
  const BalloonSight smooth = segmentation_.look(world_.model(), world_.data(), fine).red;
  EXPECT_NEAR(smooth.pixels, plain.pixels, 0.05 * plain.pixels);
  EXPECT_LT((smooth.centroid - plain.centroid).norm(), 0.3);
}

TEST_F(SegmentationTest, ABlurredBalloonIsWhereItsLightIs) {
  stand_before("red_balloon", 1.0, 0.1);
  const BalloonSight still = look().red;
  constexpr std::size_t kTiles = 160 / 20 * 120 / 8;
  // The camera turned right: all moved left, and was to the right of where it is now.
  const std::vector<Eigen::Vector2f> field(kTiles, {-6.0F, 0.0F});
  const BalloonSight moved =
      segmentation_.look(world_.model(), world_.data(), renderer_, {}, field).red;
  EXPECT_NEAR(moved.centroid.x() - still.centroid.x(), 3.0, 0.4);
  EXPECT_NEAR(moved.centroid.y() - still.centroid.y(), 0.0, 0.3);

  // The sensor's own picture of a white balloon on black agrees.
  std::vector<Rgb> white(static_cast<std::size_t>(world_.model().ngeom), Rgb{0, 0, 0});
  white[static_cast<std::size_t>(mj_name2id(&world_.model(), mjOBJ_GEOM, "red_balloon"))] = {
      200, 200, 200};
  Frame flat, blurred;
  renderer_.render_flat(world_.model(), world_.data(), white, {0, 0, 0}, flat);
  Sensor(lens_, 0.0, Random{1}).expose(flat, field, 1.0, blurred);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  int pixels = 0;
  for (int y = 0; y < kSize.height; ++y) {
    for (int x = 0; x < kSize.width; ++x) {
      if (blurred.rgb[3 * static_cast<std::size_t>(y * kSize.width + x)] <= 100) continue;
      sum += Eigen::Vector2d(x, y);
      ++pixels;
    }
  }
  ASSERT_GT(pixels, 200);
  EXPECT_LT((moved.centroid - sum / pixels).norm(), 0.5);
  EXPECT_NEAR(moved.pixels, pixels, 0.1 * pixels);  // the knot is not in it
}

}  // namespace
}  // namespace pacer::sim
