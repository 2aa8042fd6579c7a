// SPDX-License-Identifier: Apache-2.0
#include "sim/person.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/channels.h"
#include "sim/renderer.h"
#include "sim/sim_car.h"
#include "sim/visibility.h"
#include "sim/world.h"
#include "tests/sim/flat_floor.h"

namespace pacer::sim {
namespace {

constexpr ImageSize kSize{.width = 320, .height = 240};
constexpr double kFovy = 50.0;

WorldConfig bare_with_a_person() {
  WorldConfig config;
  config.furnished = false;
  config.balloons = false;
  config.lead_body = "person";
  config.room.length = config.room.width = {12.0, 12.0};
  return config;
}

/// A person who walks away from a car that stands.
class PersonTest : public ::testing::Test {
 protected:
  PersonTest() : world_(bare_with_a_person(), Seconds{0.005}, kFovy, Random{3}) {}

  void walk(double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / 0.005); ++i) {
      world_.observe();
      world_.advance({});
    }
    world_.observe();
  }

  /// The geoms of the person that are drawn and not seen through.
  [[nodiscard]] std::vector<int> parts() const {
    const mjModel& model = world_.model();
    std::vector<int> found;
    for (int geom = 0; geom < model.ngeom; ++geom) {
      if (model.body_rootid[model.geom_bodyid[geom]] == world_.lead()->body() &&
          model.geom_group[geom] <= kDecoration && model.geom_rgba[4 * geom + 3] > 0.5F) {
        found.push_back(geom);
      }
    }
    return found;
  }

  /// Of a joint, radians.
  [[nodiscard]] double angle(const char* joint) const {
    const int id = mj_name2id(&world_.model(), mjOBJ_JOINT, joint);
    return world_.data().qpos[world_.model().jnt_qposadr[id]];
  }

  World world_;
};

TEST_F(PersonTest, TheTruthsBoxHoldsWhatIsDrawnOfItAtEveryMomentOfTheStride) {
  Renderer renderer(world_.model(), World::kCamera, kSize);
  const double focal = 0.5 * kSize.height / std::tan(0.5 * kFovy * std::numbers::pi / 180.0);
  Visibility visibility(world_.model(), world_.camera(), world_.lead()->body(),
                        {.fx = focal,
                         .fy = focal,
                         .cx = 0.5 * (kSize.width - 1),
                         .cy = 0.5 * (kSize.height - 1),
                         .size = kSize,
                         .lens = {}});
  std::vector<Rgb> colours(static_cast<std::size_t>(world_.model().ngeom), Rgb{0, 0, 0});
  for (const int part : parts()) colours[static_cast<std::size_t>(part)] = {255, 0, 0};
  Frame flat;
  for (int look = 0; look < 25; ++look) {
    walk(0.09);
    renderer.render_flat(world_.model(), world_.data(), colours, Rgb{0, 0, 255}, flat);
    Eigen::Vector2d low(1e9, 1e9);
    Eigen::Vector2d high(-1e9, -1e9);
    for (int y = 0; y < kSize.height; ++y) {
      for (int x = 0; x < kSize.width; ++x) {
        if (flat.rgb[static_cast<std::size_t>(3 * (y * kSize.width + x))] < 128) continue;
        low = low.cwiseMin(Eigen::Vector2d(x, y));
        high = high.cwiseMax(Eigen::Vector2d(x, y));
      }
    }
    ASSERT_LT(low.x(), high.x()) << "it is in the picture";
    const LeadView view = visibility.look(world_.data());
    for (const int axis : {0, 1}) {
      EXPECT_LE(view.box_low[axis], low[axis] + 1.0) << look << " " << axis;
      EXPECT_GE(view.box_high[axis], high[axis] - 1.0) << look << " " << axis;
    }
    // And is no larger than it must be: a stride and a third about it, from the side at most.
    EXPECT_LT(view.box_high.y() - view.box_low.y(), 1.25 * (high.y() - low.y()) + 2.0);
    EXPECT_LT(view.box_high.x() - view.box_low.x(), 2.6 * (high.x() - low.x()) + 2.0);
    EXPECT_TRUE(view.sight.seen);
  }
}

TEST_F(PersonTest, IsThirtyCentimetresTallAndStandsOnTheFloor) {
  const Visibility visibility(
      world_.model(), world_.camera(), world_.lead()->body(),
      {.fx = 1.0, .fy = 1.0, .cx = 0.0, .cy = 0.0, .size = kSize, .lens = {}});
  EXPECT_NEAR(visibility.middle().z() + visibility.half_extent().z(), kPersonOutline.roof, 0.01);
  EXPECT_NEAR(visibility.middle().z() - visibility.half_extent().z(), 0.0, 0.01);
  EXPECT_LT(visibility.half_extent().y(), 0.08);
}

TEST_F(PersonTest, SwingsItsLegsAgainstEachOtherAsItWalksAndStandsUprightAtRest) {
  EXPECT_NEAR(angle("lead/left_hip"), 0.0, 0.02);
  double widest = 0.0;
  double sum = 0.0;
  walk(1.0);
  for (int i = 0; i < 80; ++i) {
    walk(0.01);
    widest = std::max(widest, std::abs(angle("lead/left_hip") - angle("lead/right_hip")));
    sum = std::max(sum, std::abs(angle("lead/left_hip") + angle("lead/right_hip")));
    EXPECT_LT(angle("lead/left_hip") * angle("lead/left_shoulder"), 0.02)
        << "an arm swings against the leg of its side";
  }
  EXPECT_GT(widest, 0.5);
  EXPECT_LT(sum, 0.1);
}

TEST_F(PersonTest, ItsFeetDoNotSinkIntoTheFloor) {
  for (int look = 0; look < 60; ++look) {
    walk(0.03);
    for (const int part : parts()) {
      // The lowest point of the box about the geom.
      const mjtNum* const box = world_.model().geom_aabb + 6L * part;
      const mjtNum* const turn = world_.data().geom_xmat + 9L * part;
      double low = world_.data().geom_xpos[3 * part + 2];
      for (int axis = 0; axis < 3; ++axis) {
        low += turn[6 + axis] * box[axis] - std::abs(turn[6 + axis]) * box[3 + axis];
      }
      EXPECT_GT(low, -0.012) << mj_id2name(&world_.model(), mjOBJ_GEOM, part);
    }
  }
  testing::expect_no_warnings(world_.data());
}

SimCarConfig behind_a_person() {
  SimCarConfig config;
  config.duration = Seconds{2.0};
  config.world = bare_with_a_person();
  config.camera.link.corrupted = 0.0;
  return config;
}

TEST(Person, IsFollowedAsAVehicleIsWithTheSameColumns) {
  SimCar car(behind_a_person(), Random{5});
  ASSERT_NE(car.look(), nullptr);
  const Privileged& truth = car.truth();
  EXPECT_NEAR(truth.lead_distance, 1.2, 0.25);
  EXPECT_TRUE(car.lead_sight().seen);
  EXPECT_EQ(truth.lead_in_view, 1.0);
  const Eigen::Vector2d side = truth.box_high - truth.box_low;
  EXPECT_GT(side.y(), 1.5 * side.x()) << "it is upright";
  EXPECT_NO_THROW((void)offset_of(car.signal_columns(), "privileged.lead_box"));
}

TEST(Person, ShowsTheSameFramesForTheSameSeedAndTheSameClothesForAnother) {
  const auto drive = [](std::uint64_t seed) {
    SimCar car(behind_a_person(), Random{seed});
    std::vector<std::uint8_t> bytes;
    for (const Frame* frame = car.look(); frame != nullptr; frame = car.look()) {
      bytes.insert(bytes.end(), frame->rgb.begin(), frame->rgb.end());
      car.send({Pulse{1500}, Pulse{1600}});
    }
    return bytes;
  };
  const auto clothes = [](std::uint64_t seed) {
    const SimCar car(behind_a_person(), Random{seed});
    const mjModel& model = car.world().model();
    const int coat = mj_name2id(&model, mjOBJ_TEXTURE, "lead/coat");
    const mjtByte* const first = model.tex_data + model.tex_adr[coat];
    return std::vector<mjtByte>(first, first + 3L * model.tex_width[coat] * model.tex_height[coat]);
  };
  EXPECT_EQ(drive(1), drive(1));
  EXPECT_NE(drive(1), drive(2));
  EXPECT_EQ(clothes(1), clothes(2));
}

TEST(Person, BlocksTheWayAsAVehicleDoes) {
  SimCarConfig config = behind_a_person();
  config.duration = Seconds{6.0};
  SimCar car(config, Random{5});
  bool hit = false;
  while (!hit && car.look() != nullptr) {
    const double wheel = std::clamp(2.0 * car.truth().lead_bearing, -1.0, 1.0);
    car.send(Channels{}.encode({.steering = wheel, .throttle = 1.0}));
    hit = car.truth().collision;
  }
  EXPECT_TRUE(hit);
  EXPECT_LT(car.truth().lead_distance, 0.5);
}

}  // namespace
}  // namespace pacer::sim
