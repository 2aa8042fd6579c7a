// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <numbers>

#include "sim/chassis.h"
#include "sim/sequences/desk.h"
#include "sim/sequences/indoors.h"
#include "sim/sequences/keyframes.h"
#include "sim/sequences/scenes.h"

// A telephone on a desk, seen through a camera in somebody's hand, which from frame 280 on is
// shaken: it is written as where in the picture the keys are to be, and the camera turned so that
// they are there. From frame 374 to 375 they go 33 pixels aside and 16 down, as in the thesis, and
// farther than between any other two frames.
namespace pacer::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;

struct CameraShake {
  // The camera, metres: from the keys to the viewer, to the right, above them.
  Keyframes back{{0, 0.86},   {90, 0.80},  {180, 0.92}, {270, 0.84},
                 {330, 0.80}, {374, 0.86}, {440, 0.70}, {500, 0.88}};
  Keyframes aside{{0, 0.0},     {70, -0.22}, {150, 0.18}, {230, -0.10}, {300, 0.06},
                  {345, -0.14}, {400, 0.16}, {450, -0.2}, {500, 0.05}};
  Keyframes above{{0, 0.46},   {100, 0.55}, {200, 0.40}, {290, 0.50},
                  {350, 0.42}, {420, 0.62}, {500, 0.45}};
  Keyframes roll{{0, 0},    {60, 5},  {140, -7}, {220, 6},   {275, 0}, {310, 9},
                 {345, -8}, {374, 3}, {410, 14}, {455, -12}, {500, 2}};  // degrees
  // Where the keys are in the picture but for the shaking, pixels from its middle.
  Keyframes right{{0, 10},  {50, -25}, {110, 40}, {170, -35}, {240, 25},  {279, 0}, {320, -20},
                  {355, 5}, {366, 0},  {384, 0},  {420, 25},  {460, -20}, {500, 10}};
  Keyframes below{{0, 15},   {60, -10}, {120, 25}, {190, -5},  {250, 20}, {279, 5},
                  {330, 20}, {366, 10}, {384, 10}, {430, -10}, {470, 15}, {500, 5}};
  Keyframes force{{279, 0.0},  {283, 0.6},  {297, 0.85}, {315, 0.35}, {333, 0.75},
                  {350, 0.55}, {366, 1.0},  {384, 1.0},  {402, 0.6},  {416, 0.25},
                  {432, 0.8},  {452, 0.92}, {472, 0.45}, {500, 0.85}};  // of the shaking
  Sway hand{"camera-shake hand", 34.0};
  Sway wrist{"camera-shake wrist", 41.0};
};

/// A sine that goes `pixels` from frame 374 to 375, its fastest moment between the two.
double shaken(double pixels, double hertz, double frame) {
  constexpr double kRate = 25.0;   // frames a second
  constexpr double kPeak = 374.5;  // frames
  const double step = 2.0 * pi * hertz / kRate;
  return pixels / (2.0 * std::sin(0.5 * step)) * std::sin(step * (frame - kPeak));
}

}  // namespace

Scene camera_shake(const Random& random) {
  Scene scene;
  const Isometry3d room = furnish(scene, "workshop", 0.9, random);
  add_desk(scene, scene.add_body("desk"), random.fork("desk"));
  add_telephone(scene, scene.add_body("telephone"), random.fork("telephone"));
  add_keypad(scene, scene.add_body(Scene::kTarget), random.fork("keypad"));
  scene.outline = keypad_outline();
  scene.view_angle = 50.0;
  scene.distortion = -0.05;
  scene.noise = 3.0;
  scene.shutter = 0.5;

  const Isometry3d keys = room * telephone_place();
  scene.act = [room, keys, script = CameraShake{}](Stage& stage, double frame) {
    stage.place("desk", room);
    stage.place("telephone", keys);
    stage.place(Scene::kTarget, keys);

    const double force = script.force.at(frame);
    const Vector3d eye =
        keys.translation() +
        room.linear() * Vector3d(script.back.at(frame),
                                 script.aside.at(frame) + 0.03 * force * shaken(0.3, 1.9, frame),
                                 script.above.at(frame) + 0.02 * force * shaken(0.3, 2.6, frame));
    const double roll = radians(script.roll.at(frame) + 1.5 * script.wrist.at(frame)) +
                        force * radians(shaken(3.5, 2.1, frame + 2.0));
    const Vector2d wanted =
        stage.lens().centre() +
        Vector2d(script.right.at(frame) + 2.5 * (1.0 - force) * script.hand.at(frame) +
                     force * shaken(33.0, 2.9, frame),
                 script.below.at(frame) + 2.0 * (1.0 - force) * script.hand.at(frame + 300.0) +
                     force * shaken(16.0, 2.3, frame));
    stage.frame(eye, keys.translation(), wanted, roll);
  };
  return scene;
}

}  // namespace pacer::sim
