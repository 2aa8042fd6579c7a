// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>

#include "sim/chassis.h"
#include "sim/sequences/indoors.h"
#include "sim/sequences/keyframes.h"
#include "sim/sequences/person.h"
#include "sim/sequences/scenes.h"

// A talking face. A hand passes over it from frame 203 to 223 and takes the glasses off at about
// 364; then he leans to the camera, the light changes, he smiles, turns, goes back and comes again.
namespace pacer::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

struct FaceHand {
  Keyframes yaw{{0, 4},     {60, -6},   {120, 5},  {155, -18}, {185, -4}, {230, 3},  {300, 12},
                {350, 0},   {400, -4},  {470, 10}, {540, -12}, {600, 4},  {650, 34}, {700, 20},
                {740, -38}, {790, -10}, {850, 22}, {920, -30}, {1000, 0}};  // degrees, left
  Keyframes pitch{{0, 0},     {80, 4},  {155, -6},  {200, 0}, {290, 7},  {350, 2},
                  {375, 10},  {400, 0}, {480, -8},  {560, 6}, {650, -4}, {720, 16},
                  {780, -12}, {860, 8}, {930, -14}, {1000, 0}};  // degrees, down
  Keyframes roll{{0, 0},   {90, 4},   {155, -7}, {203, 0},   {290, -5}, {364, 4},   {420, 0},
                 {520, 8}, {620, -8}, {700, 12}, {770, -10}, {850, 6},  {940, -14}, {1000, 0}};
  Keyframes aside{{0, 0},       {110, 0.03},  {160, -0.05}, {210, 0},    {300, 0.05},
                  {380, 0},     {470, -0.06}, {560, 0.03},  {640, 0.08}, {720, -0.02},
                  {790, -0.17}, {870, 0.10},  {940, 0.05},  {1000, 0}};  // metres, left
  Keyframes ahead{{0, 0},       {200, 0.01},  {420, 0},     {490, 0.16}, {545, 0.14}, {600, 0.0},
                  {700, -0.04}, {800, -0.30}, {850, -0.28}, {930, 0.06}, {1000, 0}};  // metres
  // The hand that passes, metres from the middle of the face to the left.
  Keyframes passing{{196, 0.62}, {203, 0.128}, {213, 0.0}, {223, -0.09}, {231, -0.62}};
  // The hand that takes the glasses: metres below and beside its grip on them.
  Keyframes reach{{338, 0.5}, {357, 0.0}, {364, 0.0}, {372, 0.04}, {392, 0.55}};
  Keyframes lamp{{0, 1.0},    {560, 1.0},  {590, 0.25}, {660, 0.35}, {690, 1.1},
                 {760, 0.95}, {835, 0.45}, {900, 1.05}, {1000, 1.0}};  // factor
  Keyframes day{{0, 1.0}, {555, 1.0}, {600, 2.2}, {690, 1.6}, {760, 0.5}, {860, 1.4}, {1000, 1.0}};
  Sway nod{"face-hand nod", 70.0};
  Sway turn{"face-hand turn", 110.0};
  Sway hold{"face-hand hold", 60.0};  // whoever holds the camera
  Sway lift{"face-hand lift", 83.0};
};

Expression expression_at(double frame) {
  const int i = static_cast<int>(std::floor(frame));
  for (const int blink : {24, 96, 171, 250, 322, 366, 441, 515, 588, 671, 733, 812, 905, 962}) {
    if (i >= blink && i < blink + 4) return Expression::kBlink;
  }
  const bool talks =
      (i > 30 && i < 150) || (i > 235 && i < 335) || (i > 430 && i < 560) || (i > 860 && i < 960);
  constexpr std::array<bool, 11> kOpen = {true, false, true,  true, false, false,
                                          true, false, false, true, false};
  if (talks && kOpen.at(static_cast<std::size_t>(i / 4 % 11))) return Expression::kTalk;
  if ((i > 610 && i < 690) || i > 965) return Expression::kSmile;
  return Expression::kNeutral;
}

/// The pose of a hand whose palm looks along `palm` and whose fingers point along `fingers`.
Isometry3d hand_at(const Vector3d& place, const Vector3d& palm, const Vector3d& fingers) {
  Isometry3d pose = Isometry3d::Identity();
  const Vector3d z = fingers.normalized();
  const Vector3d x = (palm - palm.dot(z) * z).normalized();
  pose.linear() << x, z.cross(x), z;
  pose.translation() = place;
  return pose;
}

}  // namespace

Scene face_hand(const Random& random) {
  Scene scene;
  const double distance = 0.84;  // metres from the camera to the face
  const Isometry3d room = furnish(scene, "office", distance, random);
  HeadLook look;
  look.stubble = true;
  const Head head(look);
  add_head(scene, scene.add_body(Scene::kTarget), head, random.fork("head"));
  add_torso(scene, scene.add_body("torso"), look.skin, {74, 92, 128}, {196, 186, 168},
            random.fork("torso"));
  add_glasses(scene, scene.add_body("glasses"), random.fork("glasses"));
  add_hand(scene, scene.add_body("passing"), "passing", 0.12, look.skin, {74, 92, 128},
           random.fork("passing"));
  add_hand(scene, scene.add_body("taking"), "taking", 0.55, look.skin, {74, 92, 128},
           random.fork("taking"));
  scene.outline = head.face_outline();
  scene.view_angle = 48.0;
  scene.distortion = -0.02;
  scene.shutter = 0.4;

  scene.act = [room, distance, script = FaceHand{}](Stage& stage, double frame) {
    const auto degrees = [frame](const Keyframes& keys) { return radians(keys.at(frame)); };
    const Vector3d hold(0.0, 0.008 * script.hold.at(frame), 0.006 * script.lift.at(frame));
    stage.aim(room * Translation3d(distance + 0.1, 0.0, 1.27) * Translation3d(hold) *
              look_at({0, 0, 0}, Vector3d(-1.0, 0.0, -0.045) + 1.2 * hold,
                      0.012 * script.hold.at(frame + 40.0)));

    const Vector3d neck(script.ahead.at(frame), script.aside.at(frame), 1.12);
    const Isometry3d torso = pose_at(neck, 0.2 * degrees(script.yaw), 0.4 * script.ahead.at(frame),
                                     0.2 * degrees(script.roll) - 0.4 * script.aside.at(frame));
    const Isometry3d face =
        pose_at(neck, degrees(script.yaw) + 0.05 * script.turn.at(frame),
                degrees(script.pitch) + 0.03 * script.nod.at(frame), degrees(script.roll)) *
        Translation3d(0.015, 0.0, 0.13);
    stage.place(Scene::kTarget, room * face);
    stage.place("torso", room * torso);
    show_expression(stage, expression_at(frame));

    const double beside = script.passing.at(frame);
    stage.place("passing",
                room * hand_at(face * Vector3d(0.22, 0.0, 0.0) +
                                   Vector3d(0.0, beside, -0.03 - 0.15 * std::abs(beside)),
                               {-1.0, 0.0, 0.1}, {0.0, -0.35 - 0.5 * beside, 1.0}));
    // Glasses stay on the nose until the hand that has them goes.
    const double away = script.reach.at(frame);
    const Vector3d gone = frame < 364.0
                              ? Vector3d::Zero()
                              : Vector3d(0.05 * std::min(1.0, 20.0 * away), -0.3 * away, -away);
    stage.place("glasses", room * Translation3d(gone) * face);
    const Vector3d grip = face * Vector3d(0.085, -0.082, -0.03);
    stage.place("taking", room * hand_at(grip + Vector3d(0.035, -0.3 * away, -0.03 - away),
                                         {-0.25, 1.0, 0.0}, {-0.35, 0.15, 1.0}));
    for (const char* light : {"lamp_0", "lamp_1"}) stage.shine(light, script.lamp.at(frame));
    stage.shine("", 0.25 + 0.75 * script.lamp.at(frame));
    stage.shine("day", script.day.at(frame));
  };
  return scene;
}

}  // namespace pacer::sim
