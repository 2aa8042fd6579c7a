// SPDX-License-Identifier: Apache-2.0
#include "sim/room.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "sim/balloon.h"
#include "sim/livery.h"

namespace pacer::sim {
namespace {

struct Delete {
  void operator()(mjSpec* spec) const { mj_deleteSpec(spec); }
  void operator()(mjModel* model) const { mj_deleteModel(model); }
};
using Spec = std::unique_ptr<mjSpec, Delete>;
using Model = std::unique_ptr<mjModel, Delete>;

constexpr double kCell = 0.05;   // metres
constexpr double kRadius = 0.2;  // about what a car needs beside its middle

bool inside(const Footprint& footprint, const Eigen::Vector2d& at, double margin) {
  const Eigen::Vector2d from = at - footprint.centre;
  const double c = std::cos(footprint.yaw);
  const double s = std::sin(footprint.yaw);
  return std::abs(c * from.x() + s * from.y()) < footprint.half.x() + margin &&
         std::abs(-s * from.x() + c * from.y()) < footprint.half.y() + margin;
}

/// Square metres of the largest connected region in which a car's middle can be.
double drivable(const RoomPlan& plan) {
  const int columns = static_cast<int>(2.0 * plan.half_extent.x() / kCell);
  const int rows = static_cast<int>(2.0 * plan.half_extent.y() / kCell);
  std::vector<char> open(static_cast<std::size_t>(columns * rows), 0);
  const auto cell = [&](int x, int y) -> char& {
    return open[static_cast<std::size_t>(y * columns + x)];
  };
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      const Eigen::Vector2d at = Eigen::Vector2d(x + 0.5, y + 0.5) * kCell - plan.half_extent;
      const bool clear = (at.cwiseAbs().array() < plan.half_extent.array() - kRadius).all();
      cell(x, y) = clear && std::ranges::none_of(plan.obstacles, [&at](const Footprint& one) {
                     return inside(one, at, kRadius);
                   });
    }
  }
  int largest = 0;
  for (int y = 0; y < rows; ++y) {
    for (int x = 0; x < columns; ++x) {
      int count = 0;
      std::vector<std::pair<int, int>> open_ends = {{x, y}};
      while (!open_ends.empty()) {
        const auto [i, j] = open_ends.back();
        open_ends.pop_back();
        if (i < 0 || j < 0 || i >= columns || j >= rows || cell(i, j) == 0) continue;
        cell(i, j) = 0;
        ++count;
        open_ends.insert(open_ends.end(), {{i + 1, j}, {i - 1, j}, {i, j + 1}, {i, j - 1}});
      }
      largest = std::max(largest, count);
    }
  }
  return largest * kCell * kCell;
}

class RoomKinds : public testing::TestWithParam<std::string> {
 protected:
  RoomKinds() { config_.kinds = {GetParam()}; }
  RoomConfig config_;
};

TEST_P(RoomKinds, CompileAndLeaveRoomToDriveForManySeeds) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const Spec spec(mj_makeSpec());
    const RoomPlan plan = build_room(*spec, config_, Random(seed));
    EXPECT_EQ(plan.kind, GetParam());
    EXPECT_GT(drivable(plan), 12.0) << "seed " << seed;
    const Model model(mj_compile(spec.get(), nullptr));
    ASSERT_TRUE(model) << "seed " << seed << ": " << mjs_getError(spec.get());
    int drawn = 0;
    for (int i = 0; i < model->ngeom; ++i) drawn += model->geom_group[i] != kProxy ? 1 : 0;
    EXPECT_LT(drawn, 100) << seed;  // each is a draw call
  }
}

TEST_P(RoomKinds, ListEverythingThatACarCanHit) {
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    const Spec spec(mj_makeSpec());
    const RoomPlan plan = build_room(*spec, config_, Random(seed));
    const Model model(mj_compile(spec.get(), nullptr));
    ASSERT_TRUE(model);
    for (int i = 0; i < model->ngeom; ++i) {
      if (model->geom_contype[i] == 0 || model->geom_type[i] != mjGEOM_BOX) continue;
      const mjtNum* const at = model->geom_pos + 3 * i;
      const mjtNum* const size = model->geom_size + 3 * i;
      if (at[2] - size[2] > 0.3) continue;  // above any car
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
          std::array<mjtNum, 3> corner = {x * size[0], y * size[1], 0.0};
          std::array<mjtNum, 3> world{};
          mju_rotVecQuat(world.data(), corner.data(), model->geom_quat + 4 * i);
          const Eigen::Vector2d point(at[0] + world[0], at[1] + world[1]);
          EXPECT_TRUE(std::ranges::any_of(
              plan.obstacles, [&](const Footprint& one) { return inside(one, point, 0.03); }))
              << "seed " << seed << " geom " << i << " at " << point.transpose();
          EXPECT_TRUE((point.cwiseAbs().array() < plan.half_extent.array() + 0.01).all());
        }
      }
    }
  }
}

TEST_P(RoomKinds, AreTheSameForTheSameSeed) {
  const Spec first(mj_makeSpec());
  const Spec second(mj_makeSpec());
  const Spec other(mj_makeSpec());
  (void)build_room(*first, config_, Random(3));
  (void)build_room(*second, config_, Random(3));
  (void)build_room(*other, config_, Random(4));
  const Model a(mj_compile(first.get(), nullptr));
  const Model b(mj_compile(second.get(), nullptr));
  const Model c(mj_compile(other.get(), nullptr));
  ASSERT_EQ(mj_sizeModel(a.get()), mj_sizeModel(b.get()));
  EXPECT_EQ(std::memcmp(a->tex_data, b->tex_data, static_cast<std::size_t>(a->ntexdata)), 0);
  ASSERT_EQ(a->nmeshvert, b->nmeshvert);
  EXPECT_EQ(std::memcmp(a->mesh_vert, b->mesh_vert,
                        sizeof(float) * 3 * static_cast<std::size_t>(a->nmeshvert)),
            0);
  EXPECT_NE(a->nmeshvert, c->nmeshvert);
}

INSTANTIATE_TEST_SUITE_P(All, RoomKinds, testing::ValuesIn(room_kinds()),
                         [](const auto& kind) { return kind.param; });

TEST(RoomConfig, RefusesAKindThatThereIsNot) {
  RoomConfig config;
  config.kinds = {"living", "cellar"};
  EXPECT_THROW(config.validate(), std::invalid_argument);
  config.kinds = {};
  EXPECT_THROW(config.validate(), std::invalid_argument);
}

TEST(Livery, AddsNoMassAndTouchesNothing) {
  const Spec spec(mj_makeSpec());
  mjsBody* const body = mjs_addBody(mjs_findBody(spec.get(), "world"), nullptr);
  mjs_addFreeJoint(body);
  body->mass = 1.5;
  body->inertia[0] = body->inertia[1] = body->inertia[2] = 0.01;
  body->explicitinertial = 1;
  dress_lead(*spec, *body, Random(1));
  const Model model(mj_compile(spec.get(), nullptr));
  ASSERT_TRUE(model) << mjs_getError(spec.get());
  EXPECT_DOUBLE_EQ(model->body_mass[1], 1.5);
  for (int i = 0; i < model->ngeom; ++i) {
    EXPECT_EQ(model->geom_group[i], kDecoration);
    EXPECT_EQ(model->geom_contype[i] | model->geom_conaffinity[i], 0);
  }
}

TEST(Balloons, SwayAndComeBackUpright) {
  const Spec spec(mj_makeSpec());
  const auto taken = add_balloons(*spec, {{{1.0, 0.5}, {-1.0, 0.0}}}, {0.34, 0.55}, Random(2));
  ASSERT_EQ(taken.size(), 2U);
  EXPECT_EQ(taken[0].centre, Eigen::Vector2d(1.0, 0.5));
  const Model model(mj_compile(spec.get(), nullptr));
  ASSERT_TRUE(model) << mjs_getError(spec.get());
  mjData* const data = mj_makeData(model.get());
  const int red = mj_name2id(model.get(), mjOBJ_BODY, "red_balloon");
  ASSERT_GT(red, 0);
  ASSERT_GT(mj_name2id(model.get(), mjOBJ_BODY, "green_balloon"), 0);
  const auto lean = [&] { return data->xipos[3 * red] - 1.0; };
  data->xfrc_applied[6 * red] = 0.01;  // a draught
  for (int i = 0; i < 500; ++i) mj_step(model.get(), data);
  EXPECT_GT(lean(), 0.02);
  EXPECT_LT(lean(), 0.4);
  data->xfrc_applied[6 * red] = 0.0;
  for (int i = 0; i < 10000; ++i) mj_step(model.get(), data);
  EXPECT_NEAR(lean(), 0.0, 0.005);
  EXPECT_GT(data->xipos[3 * red + 2], 0.3);
  mj_deleteData(data);
}

}  // namespace
}  // namespace pacer::sim
