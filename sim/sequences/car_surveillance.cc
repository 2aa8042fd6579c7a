// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sim/chassis.h"
#include "sim/print.h"
#include "sim/sequences/keyframes.h"
#include "sim/sequences/motor_car.h"
#include "sim/sequences/outdoors.h"
#include "sim/sequences/scenes.h"

// A yard from a high, fixed camera: a car comes by on the road, turns away into the yard, along its
// far end, and back towards the camera, seen from every side, while clouds pass.
namespace pacer::sim {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;
using texture::Colour;

constexpr int kFrames = 282;
constexpr int kSteps = 8;  // of the drive, a frame

struct Drive {
  Keyframes heading{{0, 4},    {14, 2},    {52, 62},    {70, 84},   {108, 80}, {150, 8},
                    {176, -8}, {226, -92}, {246, -104}, {282, -170}};  // degrees, 0 to the right
  Keyframes speed{{0, 0.25},   {30, 0.19},  {60, 0.17},  {95, 0.22}, {130, 0.17},
                  {165, 0.22}, {205, 0.17}, {250, 0.21}, {282, 0.19}};  // metres a frame
  Keyframes cloud{{0, 1.0},   {25, 1.0},   {48, 0.55},  {95, 0.4}, {128, 1.0}, {175, 1.1},
                  {200, 0.5}, {240, 0.75}, {262, 1.05}, {282, 1.0}};  // factor on the sun
};

/// Where the drive has come to at each step, from one frame before the first to one after the last.
std::vector<Vector2d> driven(const Drive& drive) {
  std::vector<Vector2d> way = {Vector2d(-9.0, 1.0)};
  for (int i = 0; i < (kFrames + 2) * kSteps; ++i) {
    const double frame = (i + 0.5) / kSteps - 1.0;
    const double heading = radians(drive.heading.at(frame));
    way.emplace_back(way.back() + drive.speed.at(frame) / kSteps *
                                      Vector2d(std::cos(heading), std::sin(heading)));
  }
  return way;
}

Vector2d place_at(const std::vector<Vector2d>& way, double frame) {
  const double step = (frame + 1.0) * kSteps;
  const auto i = static_cast<std::size_t>(std::floor(step));
  return way.at(i) + (step - std::floor(step)) * (way.at(i + 1) - way.at(i));
}

void lay_ground(Shape& shape, Atlas& atlas, const Random& random) {
  const Skin yard =
      atlas.add(outdoors::asphalt({448, 448}, {132, 130, 126}, random.fork("yard")), 9.0);
  const Skin road =
      atlas.add(outdoors::asphalt({320, 320}, {96, 97, 102}, random.fork("road")), 7.0);
  const Skin lawn = atlas.add(outdoors::grass({384, 384}, {92, 124, 62}, random.fork("lawn")), 6.0);
  const Skin slabs = atlas.add(
      texture::tiles({256, 256}, {168, 160, 148}, {110, 104, 98}, 5, random.fork("slabs")), 2.5);
  const Skin line = atlas.add(texture::plain({32, 32}, {226, 224, 214}, 8.0, random.fork("line")));
  const auto lay = [&shape](double left, double low, double right, double high, double z,
                            const Skin& skin) {
    shape.rectangle({left, low, z}, {right - left, 0.0, 0.0}, {0.0, high - low, 0.0}, skin);
  };
  lay(-60.0, -45.0, 60.0, -5.5, 0.0, lawn);
  lay(-60.0, -5.5, 60.0, -3.2, 0.05, slabs);
  lay(-60.0, -3.2, 60.0, 4.2, 0.0, road);
  lay(-60.0, 4.2, -14.0, 6.0, 0.05, slabs);
  lay(22.0, 4.2, 60.0, 6.0, 0.05, slabs);
  lay(-60.0, 6.0, -14.0, 60.0, 0.02, lawn);
  lay(22.0, 6.0, 60.0, 60.0, 0.02, lawn);
  lay(-14.0, 4.2, 22.0, 32.0, 0.0, yard);
  lay(-14.0, 32.0, 22.0, 60.0, 0.02, lawn);
  for (double x = -58.0; x < 58.0; x += 4.0) lay(x, 0.42, x + 2.0, 0.58, 0.03, line);
  for (double y = 8.0; y < 29.0; y += 2.8) lay(-13.5, y, -8.6, y + 0.12, 0.03, line);  // bays
  for (double x = -5.0; x < 20.0; x += 2.8) lay(x, 26.0, x + 0.12, 31.0, 0.03, line);
  for (double y = 9.0; y < 18.0; y += 2.8) lay(5.6, y, 11.2, y + 0.12, 0.03, line);
  lay(5.2, 8.6, 5.6, 17.8, 0.06, slabs);
  lay(-4.0, -20.0, -2.2, -5.5, 0.03, slabs);                                            // a path
  for (int i = 0; i < 5; ++i) lay(4.6 + 1.6 * i, 4.3, 5.5 + 1.6 * i, 6.4, 0.03, line);  // zebra
}

void build_yard(Scene& scene, const Random& random) {
  Atlas atlas(1100);
  Shape shape;
  lay_ground(shape, atlas, random.fork("ground"));
  const Skin works =
      atlas.add(outdoors::facade({960, 256}, {164, 92, 70}, 15, 3, random.fork("works")));
  const Skin house =
      atlas.add(outdoors::facade({448, 288}, {196, 178, 140}, 6, 4, random.fork("house")));
  const Skin roof = atlas.add(
      texture::tiles({192, 192}, {110, 66, 56}, {70, 44, 40}, 12, random.fork("roof")), 4.0);
  const Skin leaves = atlas.add(print::leaves({160, 160}, random.fork("leaves")));
  const Skin bark = atlas.add(texture::wood({64, 96}, {92, 74, 58}, random.fork("bark")));
  const Skin boards = atlas.add(outdoors::boards({640, 64}, 5, random.fork("boards")));
  const Skin metal = atlas.add(texture::metal({96, 96}, {122, 126, 132}, random.fork("metal")));

  shape.box({3.0, 37.0, 4.0}, {20.0, 5.0, 4.0}, {{}, works, house, house, roof, {}});
  shape.box({-32.0, 33.0, 5.0}, {8.0, 6.0, 5.0}, {{}, house, house, house, roof, {}});
  shape.box({36.0, 30.0, 4.5}, {9.0, 7.0, 4.5}, {{}, house, house, house, roof, {}});
  shape.box({-18.0, 5.4, 0.6}, {3.8, 0.08, 0.55}, {{}, boards, {}, {}, metal, {}});
  shape.box({30.0, 6.4, 0.6}, {7.0, 0.08, 0.55}, {{}, boards, {}, {}, metal, {}});
  for (const double x : {-13.8, 21.8}) {  // hedges along the yard
    shape.box({x, 18.0, 0.7}, {0.5, 12.0, 0.7}, BoxSkins::all(leaves));
  }
  Random draw = random.fork("trees");
  constexpr std::array<std::array<double, 3>, 14> kTrees = {{{-19.0, 12.0, 7.0},
                                                             {-22.0, 20.0, 8.0},
                                                             {-17.5, 27.0, 6.0},
                                                             {26.0, 12.0, 6.5},
                                                             {25.0, 21.0, 8.0},
                                                             {31.0, 17.0, 7.0},
                                                             {-8.5, -9.0, 3.2},
                                                             {10.5, -8.0, 2.6},
                                                             {5.0, -12.0, 2.2},
                                                             {-5.5, -13.0, 1.6},
                                                             {0.5, -8.0, 1.5},
                                                             {12.5, -10.5, 3.4},
                                                             {5.4, 18.4, 3.2},
                                                             {-26.0, 9.0, 6.0}}};
  for (const auto& [x, y, height] : kTrees) {
    outdoors::tree(shape, {x, y, 0.0}, height, leaves, bark, draw.fork("tree", draw.next()));
  }
  for (const double x : {-16.0, 2.0, 20.0}) {  // lamp posts
    shape.limb({x, -4.6, 0.0}, {x, -4.6, 5.0}, 0.07, 0.05, Vector3d::UnitX(), metal, 6);
    shape.limb({x, -4.6, 5.0}, {x, -3.2, 5.2}, 0.05, 0.09, Vector3d::UnitX(), metal, 6);
  }
  for (const double x : {-11.0, -7.0, 4.0, 8.0, 15.0}) {  // shrubs along the pavement
    shape.box({x, -6.2, 0.4}, {1.4, 0.4, 0.4}, BoxSkins::all(leaves));
  }
  shape.box({18.0, 29.4, 0.9}, {1.8, 1.0, 0.9}, BoxSkins::all(metal), 0.2);  // a skip
  atlas.add_to(*scene.spec, "yard");
  (void)shape.add_to(*scene.spec, *mjs_findBody(scene.spec.get(), "world"), "yard", "yard",
                     atlas.size());
}

struct Parked {
  double x, y, heading;  // metres, degrees
  std::array<double, 3> paint;
};
constexpr std::array<Parked, 12> kParked = {{{-11.0, 9.4, 2.0, {206, 208, 210}},
                                             {-11.2, 15.0, 178.0, {60, 66, 78}},
                                             {-11.0, 17.8, 1.0, {150, 34, 38}},
                                             {-11.1, 23.4, 182.0, {190, 178, 140}},
                                             {-3.5, 28.6, 91.0, {40, 84, 64}},
                                             {2.0, 28.4, 268.0, {52, 70, 120}},
                                             {10.4, 28.6, 90.0, {214, 212, 204}},
                                             {8.5, 10.5, 0.0, {186, 188, 192}},
                                             {8.4, 13.3, 181.0, {36, 38, 44}},
                                             {8.6, 16.1, 1.0, {164, 96, 40}},
                                             {16.5, -2.2, 180.0, {120, 124, 130}},
                                             {14.6, 28.4, 271.0, {128, 40, 60}}}};

}  // namespace

Scene car_surveillance(const Random& random) {
  Scene scene;
  outdoors::add_daylight(scene, {0.5, 0.62, -0.75}, 160.0);
  build_yard(scene, random.fork("yard"));
  for (std::size_t i = 0; i < kParked.size(); ++i) {
    const std::string name = "parked_" + std::to_string(i);
    const auto& paint = kParked.at(i).paint;
    add_motor_car(scene, scene.add_body(name), name, {paint[0], paint[1], paint[2]}, false,
                  random.fork("parked", i));
  }
  add_motor_car(scene, scene.add_body(Scene::kTarget), "car", {48, 92, 168}, true,
                random.fork("car"));
  scene.outline = motor_car_outline();
  scene.view_angle = 50.0;
  scene.noise = 2.5;
  scene.shutter = 0.2;

  const Drive drive;
  scene.act = [drive, way = driven(drive)](Stage& stage, double frame) {
    stage.aim(look_at({2.0, -33.0, 15.5}, {2.6, 9.0, 0.0}));
    for (std::size_t i = 0; i < kParked.size(); ++i) {
      const Parked& parked = kParked.at(i);
      stage.place("parked_" + std::to_string(i),
                  pose_at({parked.x, parked.y, 0.0}, radians(parked.heading)));
    }
    const Vector2d at = place_at(way, frame);
    stage.place(Scene::kTarget, pose_at({at.x(), at.y(), 0.0}, radians(drive.heading.at(frame))));
    const double sun = drive.cloud.at(frame);
    stage.shine("sun", sun);
    stage.shine("", 0.75 + 0.25 * sun);
  };
  return scene;
}

}  // namespace pacer::sim
