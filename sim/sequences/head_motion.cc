// SPDX-License-Identifier: Apache-2.0
#include "sim/chassis.h"
#include "sim/sequences/indoors.h"
#include "sim/sequences/keyframes.h"
#include "sim/sequences/person.h"
#include "sim/sequences/scenes.h"

// A head and torso before a fixed camera: the head turns, nods and tilts as far as heads go, and
// behind a mug it hides for a hundred frames, from number 300.
namespace pacer::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;

struct HeadMotion {
  Keyframes yaw{{0, 0},     {35, -35}, {75, 40},   {110, 0},  {150, -72},
                {185, -60}, {230, 70}, {262, 55},  {290, 0},  {400, 6},
                {440, -50}, {475, 62}, {520, -78}, {565, 25}, {600, 0}};  // degrees, left
  Keyframes pitch{{0, 0},    {60, -12},  {95, 26},  {130, -28}, {165, 6},
                  {200, 22}, {245, -12}, {290, 0},  {335, -12}, {395, 0},
                  {430, 30}, {460, -30}, {500, 16}, {545, -22}, {600, 4}};  // degrees, down
  Keyframes roll{{0, 0},   {50, 15}, {100, -20}, {140, 10},  {210, -32}, {250, 26},
                 {290, 0}, {400, 0}, {450, 30},  {490, -26}, {540, 12},  {600, 0}};  // degrees
  Keyframes aside{{0, 0},      {70, 0.07},   {130, -0.08}, {190, 0.10},  {250, -0.09}, {300, 0},
                  {400, 0.01}, {455, -0.12}, {505, 0.12},  {560, -0.04}, {600, 0}};  // metres, left
  Keyframes ahead{{0, 0},   {90, 0.06},  {160, -0.08}, {220, 0.07}, {300, 0},
                  {400, 0}, {470, 0.10}, {530, -0.10}, {600, 0}};  // metres, to the camera
  // Where the mug is below the place where it hides the face, metres; beyond 0.3 it is out of view.
  Keyframes mug{{288, 0.42}, {300, 0.03}, {304, 0.0},  {330, 0.015}, {350, -0.02},
                {375, 0.01}, {395, 0.0},  {400, 0.03}, {412, 0.42}};
  Keyframes tip{{305, 0}, {335, 50}, {370, 40}, {392, 0}};  // degrees that one drinks at
  Sway nod{"head-motion nod", 55.0};
  Sway drift{"head-motion drift", 90.0};
};

}  // namespace

Scene head_motion(const Random& random) {
  Scene scene;
  const double distance = 0.86;  // metres from the camera to the head
  const Isometry3d room = furnish(scene, "living", distance, random);
  HeadLook look;
  look.skin = {206, 154, 122};
  look.hair = {46, 30, 24};
  look.hair_depth = 0.027;
  look.side_hairline = -0.02;
  const Head head(look);
  add_head(scene, scene.add_body(Scene::kTarget), head, random.fork("head"));
  add_torso(scene, scene.add_body("torso"), look.skin, {150, 60, 52}, {222, 196, 150},
            random.fork("torso"));
  add_hand(scene, scene.add_body("hand"), "hand", 0.75, look.skin, {150, 60, 52},
           random.fork("hand"));
  add_mug(scene, scene.add_body("mug"), random.fork("mug"));
  scene.outline = head.outline();
  scene.view_angle = 50.0;
  scene.noise = 2.5;
  scene.shutter = 0.4;

  scene.act = [room, distance, script = HeadMotion{}](Stage& stage, double frame) {
    const auto degrees = [frame](const Keyframes& keys) { return radians(keys.at(frame)); };
    stage.aim(room * Translation3d(distance, 0.02, 1.24) * look_at({0, 0, 0}, {-1.0, 0.0, -0.055}));
    const Vector3d neck(script.ahead.at(frame), script.aside.at(frame), 1.07);
    const Isometry3d torso = pose_at(neck, 0.25 * degrees(script.yaw), 0.1 * degrees(script.pitch),
                                     0.25 * degrees(script.roll) - 0.6 * script.aside.at(frame));
    const Isometry3d turned =
        pose_at(neck, degrees(script.yaw) + 0.02 * script.drift.at(frame),
                degrees(script.pitch) + 0.02 * script.nod.at(frame), degrees(script.roll));
    const Isometry3d head_pose = turned * Translation3d(0.015, 0.0, 0.13);
    stage.place(Scene::kTarget, room * head_pose);
    stage.place("torso", room * torso);

    const double low = script.mug.at(frame);
    const Isometry3d mug =
        Translation3d(head_pose.translation() + Vector3d(0.175, 0.0, -0.03 - low)) *
        pose_at({0, 0, 0}, 0.3, -degrees(script.tip), 0.0);
    stage.place("mug", room * mug);
    Isometry3d grip = Isometry3d::Identity();  // the palm on the mug's side, fingers around it
    grip.linear().col(2) = Vector3d(0.62, 0.25, 0.74).normalized();
    grip.linear().col(0) =
        (Vector3d(0.25, 1.0, 0.0) -
         grip.linear().col(2) * grip.linear().col(2).dot(Vector3d(0.25, 1.0, 0.0)))
            .normalized();
    grip.linear().col(1) = grip.linear().col(2).cross(grip.linear().col(0));
    grip.translation() = Vector3d(-0.03, -0.057, -0.03);
    stage.place("hand", room * Translation3d(mug.translation()) * grip);

    const int beat = static_cast<int>(frame) % 97;
    show_expression(stage, beat < 3 ? Expression::kBlink
                           : frame > 415.0 && frame < 545.0 && static_cast<int>(frame / 5) % 3 == 0
                               ? Expression::kTalk
                           : frame > 180.0 && frame < 250.0 ? Expression::kSmile
                                                            : Expression::kNeutral);
  };
  return scene;
}

}  // namespace pacer::sim
