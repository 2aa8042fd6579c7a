// SPDX-License-Identifier: Apache-2.0
#include "sim/visibility.h"

#include <gtest/gtest.h>

#include <array>
#include <chrono>
#include <cmath>
#include <memory>
#include <string>

namespace pacer::sim {
namespace {

/// A camera at the origin, 0.2 m up, that looks along x; a lead of 0.4 x 0.2 x 0.2 m; a board.
class Scene {
 public:
  explicit Scene(const std::string& more = "") {
    const std::string xml = R"(<mujoco><worldbody>
      <geom name="floor" type="plane" size="5 5 1"/>
      <body name="car"><freejoint/><inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>
        <geom type="box" size=".1 .1 .02" pos=".1 0 .05"/>
        <camera name="eye" pos="0 0 .2" xyaxes="0 -1 0 0 0 1"/></body>
      <body name="lead" pos="2 0 .1"><freejoint/><geom type="box" size=".2 .1 .1"/></body>)" +
                            more + "</worldbody></mujoco>";
    std::array<char, 500> error{};
    mjVFS vfs;
    mj_defaultVFS(&vfs);
    mj_addBufferVFS(&vfs, "scene.xml", xml.data(), static_cast<int>(xml.size()));
    model_.reset(mj_loadXML("scene.xml", &vfs, error.data(), error.size()));
    mj_deleteVFS(&vfs);
    if (!model_) throw std::runtime_error(error.data());
    data_.reset(mj_makeData(model_.get()));
    place(2.0, 0.0, 0.0);
  }

  /// Stands the lead there.
  void place(double x, double y, double yaw) {
    const int lead = mj_name2id(model_.get(), mjOBJ_BODY, "lead");
    mjtNum* const q = data_->qpos + model_->jnt_qposadr[model_->body_jntadr[lead]];
    q[0] = x;
    q[1] = y;
    q[2] = 0.1;
    q[3] = std::cos(0.5 * yaw);
    q[6] = std::sin(0.5 * yaw);
    mj_forward(model_.get(), data_.get());
  }

  Visibility visibility() const {
    return Visibility(*model_, 0, mj_name2id(model_.get(), mjOBJ_BODY, "lead"),
                      {.fx = 200.0,
                       .fy = 200.0,
                       .cx = 159.5,
                       .cy = 119.5,
                       .size = {.width = 320, .height = 240},
                       .lens = {}});
  }
  LeadView look(std::span<const RowBand> covered = {}) const {
    Visibility visibility = this->visibility();
    return visibility.look(*data_, covered);
  }
  const mjData& data() const { return *data_; }

 private:
  struct Delete {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
  };
  std::unique_ptr<mjModel, Delete> model_;
  std::unique_ptr<mjData, Delete> data_;
};

TEST(Visibility, TakesTheBodyForTheBoxAboutItsDrawnGeoms) {
  const Visibility visibility = Scene().visibility();
  EXPECT_TRUE(visibility.half_extent().isApprox(Eigen::Vector3d(0.2, 0.1, 0.1), 1e-9));
  EXPECT_LT(visibility.middle().norm(), 1e-9);
}

TEST(Visibility, ALeadAheadIsSeenWholeWhereThePinholePutsIt) {
  const LeadView view = Scene().look();
  ASSERT_TRUE(view.sight.seen);
  EXPECT_NEAR(view.in_view, 1.0, 1e-9);
  EXPECT_NEAR(view.sight.visible, 1.0, 1e-9);
  EXPECT_NEAR(view.sight.bearing, 0.0, 1e-9);
  // Its near face is 1.8 m away: 0.2 m wide, from the floor to the height of the camera.
  const double near = 200.0 / 1.8;
  EXPECT_NEAR(view.sight.low.x(), 159.5 - 0.1 * near, 1e-6);
  EXPECT_NEAR(view.sight.high.x(), 159.5 + 0.1 * near, 1e-6);
  EXPECT_NEAR(view.box_high.y(), 119.5 + 0.2 * near, 1e-6);
  EXPECT_NEAR(view.sight.size, 2.0 * std::atan(0.1 / 1.8), 1e-6);
}

TEST(Visibility, BearingIsPositiveToTheLeft) {
  Scene scene;
  scene.place(2.0, 0.5, 0.0);
  EXPECT_NEAR(scene.look().sight.bearing, std::atan2(0.5, 2.0), 0.03);
  scene.place(2.0, -0.5, 0.0);
  EXPECT_NEAR(scene.look().sight.bearing, -std::atan2(0.5, 2.0), 0.03);
}

TEST(Visibility, ALeadBehindOrBesideIsNotSeen) {
  Scene scene;
  scene.place(-2.0, 0.0, 0.0);
  EXPECT_FALSE(scene.look().sight.seen);
  EXPECT_EQ(scene.look().box_low, scene.look().box_high);
  scene.place(0.5, 2.0, 0.0);
  EXPECT_FALSE(scene.look().sight.seen);
  EXPECT_EQ(scene.look().in_view, 0.0);
}

TEST(Visibility, APartlyVisibleLeadReachesThePicturesEdge) {
  Scene scene;
  scene.place(1.5, 1.2, 1.57);  // its side on, half of it beyond the left edge
  const LeadView view = scene.look();
  ASSERT_TRUE(view.sight.seen);
  EXPECT_NEAR(view.sight.low.x(), -0.5, 1e-9);
  EXPECT_LT(view.box_low.x(), -0.5);
  EXPECT_GT(view.in_view, 0.1);
  EXPECT_LT(view.in_view, 0.9);
}

TEST(Visibility, WhatStandsBetweenHidesIt) {
  const Scene scene(R"(<geom type="box" size=".02 .5 .5" pos="1 0 .5" group="1"/>)");
  EXPECT_FALSE(scene.look().sight.seen);
  EXPECT_EQ(scene.look().in_view, 0.0);
  EXPECT_LT(scene.look().box_low.x(), scene.look().box_high.x())
      << "the box is the truth all the same";
}

TEST(Visibility, WhatHidesOneHalfLeavesTheOther) {
  const Scene scene(R"(<geom type="box" size=".02 .5 .5" pos="1 .5 .5" group="0"/>)");
  const LeadSight sight = scene.look().sight;
  ASSERT_TRUE(sight.seen);
  EXPECT_LT(sight.bearing, -0.01);
  EXPECT_GT(sight.low.x(), 155.0);
  EXPECT_LT(sight.visible, 0.8);
}

TEST(Visibility, WhatIsBehindTheLeadOrNotDrawnOrClearHidesNothing) {
  const Scene scene(R"(
    <geom type="box" size=".02 .5 .5" pos="2.5 0 .5" group="1"/>
    <geom type="box" size=".02 .5 .5" pos="1 0 .5" group="3"/>
    <geom type="box" size=".02 .5 .5" pos="1.2 0 .5" group="1" rgba="1 1 1 .1"/>)");
  EXPECT_NEAR(scene.look().sight.visible, 1.0, 1e-9);
}

TEST(Visibility, ARugUnderTheLeadHidesNothing) {
  const Scene scene(R"(<geom type="box" size="1 .5 .005" pos="1.6 0 .005" group="2"/>)");
  EXPECT_NEAR(scene.look().sight.visible, 1.0, 1e-9);
}

TEST(Visibility, CoveredRowsAreNotSeenButStillInView) {
  const Scene scene;
  const std::array<RowBand, 1> all = {{{.first = 0, .last = 240}}};
  EXPECT_FALSE(scene.look(all).sight.seen);
  EXPECT_NEAR(scene.look(all).in_view, 1.0, 1e-9);
  const std::array<RowBand, 1> lower = {{{.first = 128, .last = 240}}};
  const LeadSight sight = scene.look(lower).sight;
  ASSERT_TRUE(sight.seen);
  EXPECT_LT(sight.high.y(), 128.0);
  EXPECT_LT(sight.visible, 1.0);
}

TEST(Visibility, FarSidesAreNotCounted) {
  Scene scene;
  scene.place(2.0, 0.0, 1.5708);  // side on: as much of what faces us is seen as from behind
  const LeadSight sight = scene.look().sight;
  EXPECT_NEAR(sight.visible, 1.0, 1e-9);
  EXPECT_NEAR(sight.high.x() - sight.low.x(), 0.4 * 200.0 / 1.9, 1e-6);
}

}  // namespace
}  // namespace pacer::sim
