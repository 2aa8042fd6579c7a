// SPDX-License-Identifier: Apache-2.0
#include "sim/sequences/athlete.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "sim/chassis.h"
#include "sim/print.h"
#include "sim/sequences/head.h"

namespace pacer::sim {
namespace {

using Eigen::Vector3d;
using std::numbers::pi;
using texture::Colour;
using texture::shade;

constexpr double kThigh = 0.43;  // metres
constexpr double kShank = 0.42;
constexpr double kSole = 0.075;  // from the ankle down
constexpr double kUpperArm = 0.29;
constexpr double kWidth = 0.3 * kAthleteHeight;

/// What a figure is dressed in, finished before its parts are added.
struct Wardrobe {
  Atlas atlas{560};
  Skin skin, shirt, shorts, shoe, head, ear;
};

cv::Mat shirt_print(const AthleteLook& look, Random random) {
  cv::Mat picture = texture::plain({384, 192}, look.shirt, 6.0, random.fork("cloth"));
  const Colour accent = shade(print::bright(random), 0.2);
  for (const int x : {84, 276}) {  // panels under the arms
    cv::rectangle(picture, cv::Rect(x, 0, 26, 192), accent, cv::FILLED);
  }
  cv::line(picture, {0, 30}, {384, 30}, shade(look.shirt, 0.6), 5);
  for (const int middle : {192, 0, 384}) {  // the number in front, and behind over the seam
    const cv::Rect bib(middle - 44, 58, 88, 66);
    cv::rectangle(picture, bib, {244, 243, 238}, cv::FILLED);
    cv::rectangle(picture, cv::Rect(bib.x, bib.y, bib.width, 14), shade(accent, -0.3), cv::FILLED);
    print::write(picture, std::to_string(look.number), {bib.x + 8, bib.y + 16, 72, 46},
                 {20, 20, 24});
  }
  for (int i = 0; i < 5; ++i) {  // folds
    const int y = 130 + 12 * i;
    cv::line(picture, {110 + 14 * i, y}, {180 + 20 * i, y + 8}, shade(look.shirt, -0.3), 2,
             cv::LINE_AA);
  }
  return picture;
}

mjsBody& part(mjsBody& parent, const std::string& joint, const Vector3d& at, mjtJoint type,
              const Vector3d& axis) {
  mjsBody* const body = mjs_addBody(&parent, nullptr);
  body->mass = 1.0;  // MuJoCo wants some in whatever has a joint; nothing is simulated
  body->explicitinertial = 1;
  for (int i = 0; i < 3; ++i) {
    body->pos[i] = at[i];
    body->inertia[i] = 1.0;
  }
  mjsJoint* const added = mjs_addJoint(body, nullptr);
  mjs_setName(added->element, joint.c_str());
  added->type = type;
  for (int i = 0; i < 3; ++i) added->axis[i] = axis[i];
  return *body;
}

void finish(const Scene& scene, mjsBody& body, const Shape& shape, const std::string& geom,
            const std::string& name, const Wardrobe& worn) {
  (void)shape.add_to(*scene.spec, body, geom, name, worn.atlas.size());
}

void add_leg(const Scene& scene, mjsBody& hips, const std::string& name, const char* which,
             double side, const Wardrobe& worn) {
  const std::string id = name + which;
  const Vector3d front = Vector3d::UnitX();
  mjsBody& thigh = part(hips, id + "hip", {0.0, 0.09 * side, 0.0}, mjJNT_HINGE, Vector3d::UnitY());
  Shape upper;
  upper.limb({0.0, 0.0, -0.1}, {0.0, 0.0, -kThigh}, 0.075, 0.052, front, worn.skin, 12);
  upper.limb({0.0, 0.0, 0.02}, {0.0, 0.0, -0.22}, 0.096, 0.088, front, worn.shorts, 12);
  finish(scene, thigh, upper, id + "thigh", name, worn);
  mjsBody& shank = part(thigh, id + "knee", {0.0, 0.0, -kThigh}, mjJNT_HINGE, Vector3d::UnitY());
  Shape lower;
  lower.limb({-0.006, 0.0, -0.03}, {-0.01, 0.0, -0.22}, 0.053, 0.056, front, worn.skin, 12);
  lower.limb({-0.01, 0.0, -0.2}, {0.0, 0.0, -kShank}, 0.055, 0.036, front, worn.skin, 12);
  finish(scene, shank, lower, id + "shank", name, worn);
  mjsBody& foot = part(shank, id + "ankle", {0.0, 0.0, -kShank}, mjJNT_HINGE, Vector3d::UnitY());
  Shape shoe;
  shoe.limb({-0.04, 0.0, -0.03}, {0.15, 0.0, -0.05}, 0.042, 0.030, Vector3d::UnitZ(), worn.shoe,
            10);
  finish(scene, foot, shoe, id + "shoe", name, worn);
}

void add_arm(const Scene& scene, mjsBody& chest, const std::string& name, const char* which,
             double side, const Wardrobe& worn) {
  const std::string id = name + which;
  const Vector3d front = Vector3d::UnitX();
  mjsBody& upper =
      part(chest, id + "shoulder", {0.0, 0.18 * side, 0.425}, mjJNT_HINGE, Vector3d::UnitY());
  Shape shape;
  shape.limb({0.0, 0.0, 0.0}, {0.0, 0.02 * side, -kUpperArm}, 0.05, 0.038, front, worn.skin, 10);
  shape.limb({0.0, -0.03 * side, 0.01}, {0.0, 0.0, -0.04}, 0.056, 0.051, front, worn.shirt, 10);
  finish(scene, upper, shape, id + "upper_arm", name, worn);
  mjsBody& fore =
      part(upper, id + "elbow", {0.0, 0.02 * side, -kUpperArm}, mjJNT_HINGE, Vector3d::UnitY());
  Shape lower;
  lower.limb({0.0, 0.0, 0.0}, {0.0, -0.05 * side, -0.23}, 0.038, 0.028, front, worn.skin, 10);
  lower.limb({0.0, -0.05 * side, -0.24}, {0.01, -0.06 * side, -0.31}, 0.036, 0.03, front, worn.skin,
             10);
  finish(scene, fore, lower, id + "forearm", name, worn);
}

void add_chest(const Scene& scene, mjsBody& chest, const Head& head, const std::string& name,
               const Wardrobe& worn) {
  Shape shape;
  shape.surface(
      24, 14,
      [](double s, double t) -> Vector3d {
        const double z = 0.50 - 0.54 * t;
        const double round = std::pow(std::max(0.0, std::sin(pi * std::clamp(t, 0.0, 1.0))), 0.35);
        const double wide = 0.115 + 0.085 * std::clamp((z - 0.02) / 0.36, 0.0, 1.0);
        const double shoulder = 1.0 - 0.45 * std::clamp((z - 0.42) / 0.08, 0.0, 1.0);
        const double around = 2.0 * pi * (s - 0.5);
        return {0.115 * round * std::cos(around) * (0.85 + 0.4 * z),
                wide * round * shoulder * std::sin(around), z};
      },
      worn.shirt);
  shape.limb({0.0, 0.0, 0.46}, {0.03, 0.0, 0.58}, 0.06, 0.055, Vector3d::UnitX(), worn.skin, 12);
  finish(scene, chest, shape, name + "chest", name, worn);
  Shape above;
  head.add_to(above, Expression::kTalk, worn.head, worn.ear, 26, 26);
  finish(scene, part(chest, name + "neck", {0.045, 0.0, 0.675}, mjJNT_HINGE, Vector3d::UnitY()),
         above, name + "head", name, worn);
}

}  // namespace

void add_athlete(const Scene& scene, mjsBody& ground, const std::string& name,
                 const AthleteLook& look, const Random& random) {
  HeadLook face;
  face.skin = look.skin;
  face.hair = look.hair;
  const Head head(face);
  Wardrobe worn;
  worn.skin = worn.atlas.add(texture::plain({96, 96}, look.skin, 10.0, random.fork("skin")));
  worn.shirt = worn.atlas.add(shirt_print(look, random.fork("shirt")));
  cv::Mat shorts = texture::plain({128, 64}, look.shorts, 7.0, random.fork("shorts"));
  cv::rectangle(shorts, cv::Rect(26, 0, 12, 64), {238, 236, 230}, cv::FILLED);
  cv::rectangle(shorts, cv::Rect(90, 0, 12, 64), {238, 236, 230}, cv::FILLED);
  worn.shorts = worn.atlas.add(shorts);
  Random shoes = random.fork("shoes");
  cv::Mat shoe = texture::plain({64, 64}, shade(print::bright(shoes), 0.2), 5.0, shoes);
  cv::line(shoe, {10, 20}, {54, 40}, {245, 245, 245}, 6, cv::LINE_AA);
  worn.shoe = worn.atlas.add(shoe);
  worn.head = worn.atlas.add(head_print(head, Expression::kTalk, {384, 320}, random.fork("head")));
  worn.ear = worn.atlas.add(texture::plain({32, 32}, look.skin, 6.0, random.fork("ear")));
  worn.atlas.add_to(*scene.spec, name);

  mjsBody& lifted = part(ground, name + "rise", {0.0, 0.0, 0.0}, mjJNT_SLIDE, Vector3d::UnitZ());
  mjsBody& banked = part(lifted, name + "bank", {0.0, 0.0, 0.0}, mjJNT_HINGE, Vector3d::UnitX());
  mjsBody& hips = part(banked, name + "turn", {0.0, 0.0, 0.0}, mjJNT_HINGE, Vector3d::UnitZ());
  Shape seat;
  seat.limb({0.0, 0.0, 0.10}, {0.0, 0.0, -0.03}, 0.115, 0.125, Vector3d::UnitX(), worn.shorts, 16);
  finish(scene, hips, seat, name + "seat", name, worn);
  add_leg(scene, hips, name, "_left_", 1.0, worn);
  add_leg(scene, hips, name, "_right_", -1.0, worn);
  mjsBody& leaning = part(banked, name + "lean", {0.0, 0.0, 0.06}, mjJNT_HINGE, Vector3d::UnitY());
  mjsBody& chest = part(leaning, name + "twist", {0.0, 0.0, 0.0}, mjJNT_HINGE, Vector3d::UnitZ());
  add_chest(scene, chest, head, name, worn);
  add_arm(scene, chest, name, "_left_", 1.0, worn);
  add_arm(scene, chest, name, "_right_", -1.0, worn);
}

void stride(Stage& stage, const std::string& name, double phase, double bank) {
  double highest = 0.0;  // of the hips above the lower foot
  for (const auto& [which, shift] : {std::pair("_left_", 0.0), std::pair("_right_", 0.5)}) {
    const double angle = 2.0 * pi * (phase + shift);
    const double hip = radians(14.0 + 44.0 * std::sin(angle));  // ahead
    // Bent while it swings to the front, nearly straight on the ground.
    const double knee = radians(18.0 + 92.0 * std::pow(std::max(0.0, std::cos(angle)), 1.4));
    stage.bend(name + which + "hip", -hip);
    stage.bend(name + which + "knee", knee);
    stage.bend(name + which + "ankle", radians(12.0 - 28.0 * std::sin(angle)));
    highest = std::max(highest, kThigh * std::cos(hip) + kShank * std::cos(hip - knee));
    stage.bend(name + which + "shoulder", radians(12.0 + 46.0 * std::sin(angle)));
    stage.bend(name + which + "elbow", -radians(92.0 + 18.0 * std::cos(angle)));
  }
  stage.bend(name + "rise", highest + kSole + 0.02 * (1.0 - std::cos(4.0 * pi * phase)));
  stage.bend(name + "bank", -bank);
  stage.bend(name + "turn", radians(7.0) * std::sin(2.0 * pi * phase));
  stage.bend(name + "lean", radians(9.0));
  stage.bend(name + "twist", -radians(12.0) * std::sin(2.0 * pi * phase));
  stage.bend(name + "neck", -radians(6.0));
}

std::vector<Vector3d> athlete_outline() {
  std::vector<Vector3d> points;
  for (int i = 0; i < 24; ++i) {
    const double angle = 2.0 * pi * i / 24.0;
    for (const double z : {0.0, kAthleteHeight}) {
      points.emplace_back(0.05 + 0.5 * kWidth * std::cos(angle), 0.5 * kWidth * std::sin(angle), z);
    }
  }
  return points;
}

}  // namespace pacer::sim
