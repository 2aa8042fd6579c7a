// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "sim/chassis.h"
#include "sim/print.h"
#include "sim/sequences/athlete.h"
#include "sim/sequences/keyframes.h"
#include "sim/sequences/outdoors.h"
#include "sim/sequences/scenes.h"

// A race, as television shows it: out of the bend and down the straight towards the camera, which
// turns and zooms after the one athlete who is in the picture from the first frame to the last.
namespace pacer::sim {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using std::numbers::pi;
using texture::Colour;
using texture::shade;

constexpr double kInner = 36.8;  // metres: radius of the innermost lane's inner edge
constexpr double kLane = 1.22;   // its width
constexpr int kLanes = 8;
constexpr double kOuter = kInner + kLanes * kLane;
constexpr double kStraight = 84.4;
constexpr double kBend = 52.0;   // metres of the bend still to run at frame 0
constexpr double kPace = 0.305;  // metres a frame

struct Race {
  Keyframes tall{
      {0, 126},   {90, 118},  {170, 108}, {240, 118},
      {310, 140}, {370, 132}, {420, 165}};  // pixels that the operator wants the athlete to be
  Sway aside{"runner aside", 95.0};
  Sway down{"runner down", 120.0};
  Sway late{"runner late", 43.0};
};

struct Entrant {
  std::string name;
  int lane;
  Keyframes lead;  // metres ahead of the athlete who is followed
  double cadence;  // strides a frame
};

const std::array<Entrant, 5>& field() {
  static const std::array<Entrant, 5> all = {{
      {Scene::kTarget, 4, {{0, 0.0}}, 0.0805},
      {"second", 5, {{0, 1.4}, {120, 0.6}, {260, -2.5}, {420, -9.0}}, 0.0790},
      {"third", 3, {{0, -1.2}, {100, 0.5}, {200, 2.2}, {300, 4.0}, {420, 8.0}}, 0.0820},
      {"fourth", 6, {{0, 3.5}, {150, 2.0}, {300, -4.0}, {420, -8.0}}, 0.0775},
      {"fifth", 2, {{0, -4.5}, {200, -3.0}, {420, -5.5}}, 0.0812},
  }};
  return all;
}

/// Where one is in a lane who has run `way` metres past the end of the bend (before it: below 0).
Eigen::Isometry3d on_track(int lane, double way) {
  const double radius = kInner + (lane - 0.5) * kLane;
  if (way >= 0.0) return pose_at({radius, way, 0.0}, 0.5 * pi);
  const double angle = way / radius;
  return pose_at({radius * std::cos(angle), radius * std::sin(angle), 0.0}, angle + 0.5 * pi);
}

cv::Mat lanes(Random random) {
  const Colour red(172, 82, 62);
  cv::Mat picture(cv::Size(320, 640), CV_8UC3, red);
  for (const int cells : {5, 20, 70}) {
    texture::modulate(picture, texture::noise(picture.size(), cells, 2 * cells, random), 9.0);
  }
  for (int lane = 0; lane < kLanes; ++lane) {  // each worn in its middle
    const int y = 80 * lane + 40;
    cv::Mat worn = picture(cv::Rect(0, y - 16, 320, 32));
    worn.convertTo(worn, -1, 0.93, 0.0);
    cv::rectangle(picture, cv::Rect(0, 80 * lane, 320, 4), {232, 228, 220}, cv::FILLED);
  }
  cv::rectangle(picture, cv::Rect(0, 636, 320, 4), {232, 228, 220}, cv::FILLED);
  for (int i = 0; i < 90; ++i) {  // scuffs
    const cv::Point at(static_cast<int>(random.below(320)), static_cast<int>(random.below(640)));
    cv::line(picture, at, at + cv::Point(static_cast<int>(random.below(22)), 2),
             shade(red, random.uniform(-0.35, 0.25)), 2, cv::LINE_AA);
  }
  return picture;
}

/// A band around the bend between two radii and heights, in pieces that wear the skins in turn.
void band(Shape& shape, double near, double near_z, double far, double far_z, double from,
          double to, int pieces, const std::vector<Skin>& skins) {
  for (int i = 0; i < pieces; ++i) {
    shape.surface(
        4, 1,
        [&](double s, double t) -> Vector3d {
          const double angle = to - (to - from) * (i + s) / pieces;  // left to right, from within
          const double radius = far + (near - far) * t;
          return {radius * std::cos(angle), radius * std::sin(angle), far_z + (near_z - far_z) * t};
        },
        skins.at(static_cast<std::size_t>(i) % skins.size()));
  }
}

void build_stadium(const Scene& scene, const Random& random) {
  Atlas atlas(1320);
  const auto skin = [&](const cv::Mat& picture, double metres = 0.0) {
    return atlas.add(picture, metres);
  };
  const Skin track = skin(lanes(random.fork("lanes")));
  const Skin lawn = skin(outdoors::grass({448, 448}, {96, 138, 66}, random.fork("lawn")), 6.0);
  const Skin apron = skin(outdoors::asphalt({256, 256}, {140, 138, 134}, random.fork("apron")));
  const Skin slab = skin(texture::concrete({192, 192}, {150, 148, 144}, random.fork("slab")), 5.0);
  const Skin leaves = skin(print::leaves({160, 160}, random.fork("leaves")));
  const Skin bark = skin(texture::wood({64, 96}, {92, 74, 58}, random.fork("bark")));
  std::vector<Skin> people;
  std::vector<Skin> adverts;
  for (std::uint64_t i = 0; i < 3; ++i) {
    people.push_back(skin(outdoors::crowd({400, 400}, random.fork("crowd", i))));
    adverts.push_back(skin(outdoors::boards({512, 64}, 2, random.fork("boards", i))));
  }
  std::vector<Skin> goods;
  for (std::uint64_t i = 0; i < 4; ++i) {
    goods.push_back(skin(print::product({96, 96}, random.fork("goods", i))));
  }

  Shape shape;
  const double low = -pi - 0.1;
  shape.rectangle({-kInner - 10.0, -kInner - 1.0, -0.05}, {2.0 * kInner + 20.0, 0.0, 0.0},
                  {0.0, kStraight + 90.0, 0.0}, lawn);
  band(shape, kInner, 0.0, kOuter, 0.0, low, 0.0, 26, {track});
  band(shape, kOuter, -0.02, kOuter + 7.0, -0.02, low, 0.0, 26, {apron});
  band(shape, kOuter + 7.0, 0.0, kOuter + 7.05, 1.0, low, 0.0, 24, adverts);
  band(shape, kOuter + 9.0, 1.0, kOuter + 27.0, 12.0, low, 0.0, 20, people);
  band(shape, kOuter + 27.0, 12.0, kOuter + 27.1, 15.0, low, 0.0, 24, {slab});
  const double piece = kStraight * 1.4 / 24.0;
  for (int i = 0; i < 24; ++i) {  // the straight, its lanes counted from the infield
    const double y = piece * i;
    shape.quad({Vector3d(kOuter, y, 0.0), Vector3d(kOuter, y + piece, 0.0),
                Vector3d(kInner, y + piece, 0.0), Vector3d(kInner, y, 0.0)},
               track, {{{0.0F, 0.0F}, {1.0F, 0.0F}, {1.0F, 1.0F}, {0.0F, 1.0F}}});
  }
  shape.rectangle({kOuter, 0.0, -0.02}, {7.0, 0.0, 0.0}, {0.0, 1.4 * kStraight, 0.0}, slab);
  for (int i = 0; i < 12; ++i) {  // boards and stand along the straight
    const double y = 10.0 * i;
    const auto which = static_cast<std::size_t>(i) % 3;
    shape.rectangle({kOuter + 7.0, y + 10.0, 0.0}, {0.0, -10.0, 0.0}, {0.05, 0.0, 1.0},
                    adverts[which]);
    shape.rectangle({kOuter + 9.0, y + 10.0, 1.0}, {0.0, -10.0, 0.0}, {18.0, 0.0, 11.0},
                    people[which]);
  }
  Random draw = random.fork("infield");
  for (int i = 0; i < 26; ++i) {  // mats, crates and signs on the grass, along the track
    const double angle = draw.uniform(-2.6, 0.0);
    const bool straight = draw.chance(0.5);
    const double inside = draw.uniform(2.0, 11.0);
    const Vector3d at = straight ? Vector3d(kInner - inside, draw.uniform(0.0, kStraight), 0.0)
                                 : Vector3d((kInner - inside) * std::cos(angle),
                                            (kInner - inside) * std::sin(angle), 0.0);
    const double half = draw.uniform(0.15, 0.35);
    shape.box(at + Vector3d(0.0, 0.0, half), {draw.uniform(0.2, 0.9), draw.uniform(0.2, 0.9), half},
              BoxSkins::all(goods.at(draw.below(4))), draw.uniform(0.0, pi));
  }
  for (int i = 0; i < 18; ++i) {  // trees beyond the stand
    const double angle = -2.9 + 0.17 * i;
    outdoors::tree(shape, (kOuter + 33.0) * Vector3d(std::cos(angle), std::sin(angle), 0.0),
                   draw.uniform(16.0, 22.0), leaves, bark,
                   draw.fork("tree", static_cast<std::uint64_t>(i)));
  }
  atlas.add_to(*scene.spec, "stadium");
  (void)shape.add_to(*scene.spec, *mjs_findBody(scene.spec.get(), "world"), "stadium", "stadium",
                     atlas.size());
}

}  // namespace

Scene runner(const Random& random) {
  Scene scene;
  outdoors::add_daylight(scene, {-0.5, -0.62, -0.75}, 320.0);
  build_stadium(scene, random.fork("stadium"));
  const std::array<AthleteLook, 5> looks = {{
      {{196, 146, 116}, {44, 32, 26}, {228, 206, 62}, {30, 62, 44}, 174},
      {{112, 76, 58}, {24, 20, 20}, {44, 92, 176}, {238, 236, 230}, 208},
      {{218, 174, 146}, {150, 112, 66}, {222, 222, 226}, {176, 32, 40}, 91},
      {{140, 98, 74}, {20, 18, 20}, {176, 40, 46}, {28, 28, 34}, 345},
      {{206, 160, 132}, {80, 52, 34}, {60, 134, 84}, {236, 234, 226}, 62},
  }};
  for (std::size_t i = 0; i < looks.size(); ++i) {
    const std::string& name = field().at(i).name;
    add_athlete(scene, scene.add_body(name), name, looks.at(i), random.fork("athlete", i));
  }
  scene.outline = athlete_outline();
  scene.view_angle = 20.0;
  scene.distortion = 0.0;
  scene.noise = 2.5;
  scene.shutter = 0.3;

  scene.act = [race = Race{}](Stage& stage, double frame) {
    for (const Entrant& one : field()) {
      const double way = kPace * frame - kBend + one.lead.at(frame);
      stage.place(one.name, on_track(one.lane, way));
      stride(stage, one.name, one.cadence * frame + 0.37 * one.lane,
             radians(7.0) * std::clamp(0.5 - way / 8.0, 0.0, 1.0));
    }
    const Vector3d eye(kOuter + 6.0, 1.33 * kStraight, 6.5);
    const Vector3d middle =
        on_track(field().front().lane, kPace * frame - kBend) * Vector3d(0.0, 0.0, 0.9);
    const double focal = stage.lens().focal();
    const double zoom = race.tall.at(frame) * (middle - eye).norm() / (kAthleteHeight * focal);
    const Vector2d wanted =
        stage.lens().centre() + Vector2d(40.0 * race.aside.at(frame) + 10.0 * race.late.at(frame),
                                         16.0 * race.down.at(frame));
    stage.frame(eye, middle, wanted, 0.0, zoom);
  };
  return scene;
}

}  // namespace pacer::sim
