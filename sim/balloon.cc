// SPDX-License-Identifier: Apache-2.0
#include "sim/balloon.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "core/check.h"

namespace pacer::sim {
namespace {

struct Look {
  const char* name;
  std::array<float, 4> rgba;
};

constexpr std::array<Look, 2> kBalloons = {{
    {"red_balloon", {0.86F, 0.07F, 0.08F, 1.0F}},
    {"green_balloon", {0.10F, 0.62F, 0.16F, 1.0F}},
}};

constexpr double kSkin = 0.012;    // kg: rubber and gas
constexpr double kLift = 0.045;    // newtons that the string holds back
constexpr double kDamping = 0.18;  // of critical
constexpr double kWeight = 0.028;  // metres: radius of the weight on the floor

mjsGeom& drawn(mjsBody& body, mjtGeom type, const float* rgba) {
  mjsGeom* const geom = mjs_addGeom(&body, nullptr);
  geom->type = type;
  geom->group = kDecoration;
  geom->contype = 0;
  geom->conaffinity = 0;
  geom->mass = 0.0;
  std::copy_n(rgba, 4, geom->rgba);
  return *geom;
}

}  // namespace

std::vector<Footprint> add_balloons(mjSpec& spec, const std::array<Eigen::Vector2d, 2>& tethers,
                                    const Range& height_range, const Random& random) {
  std::vector<Footprint> taken;
  mjsBody* const world = mjs_findBody(&spec, "world");
  mjsMaterial* const rubber = mjs_addMaterial(&spec, nullptr);
  check(mjs_setName(rubber->element, "rubber") == 0, "balloons are added once");
  rubber->specular = 0.9F;
  rubber->shininess = 0.7F;
  for (std::size_t i = 0; i < kBalloons.size(); ++i) {
    const Look& look = kBalloons.at(i);
    Random draw = random.fork(look.name);
    const double radius = draw.uniform(0.125, 0.15);
    const double height = height_range.draw(draw);

    mjsBody* const body = mjs_addBody(world, nullptr);
    mjs_setName(body->element, look.name);
    body->pos[0] = tethers.at(i).x();
    body->pos[1] = tethers.at(i).y();
    body->gravcomp = 1.0;
    mjsJoint* const tether = mjs_addJoint(body, nullptr);
    mjs_setName(tether->element, (std::string(look.name) + "_tether").c_str());
    tether->type = mjJNT_BALL;
    // Small swings: I a'' + c a' + k a = 0 with k = lift x height, as of a pendulum upside down.
    const double inertia = kSkin * height * height;
    const double stiffness = kLift * height;
    tether->stiffness[0] = stiffness;
    tether->damping[0] = 2.0 * kDamping * std::sqrt(stiffness * inertia);

    mjsGeom* const hull = mjs_addGeom(body, nullptr);
    mjs_setName(hull->element, look.name);
    hull->type = mjGEOM_ELLIPSOID;
    hull->group = kFurniture;
    hull->mass = kSkin;
    hull->pos[2] = height;
    hull->size[0] = hull->size[1] = 0.94 * radius;
    hull->size[2] = 1.1 * radius;
    mjs_setString(hull->material, "rubber");
    std::copy(look.rgba.begin(), look.rgba.end(), hull->rgba);

    mjsGeom& knot = drawn(*body, mjGEOM_ELLIPSOID, look.rgba.data());
    knot.pos[2] = height - 1.13 * radius;
    knot.size[0] = knot.size[1] = 0.016;
    knot.size[2] = 0.018;
    constexpr std::array<float, 4> kString = {0.92F, 0.91F, 0.86F, 1.0F};
    mjsGeom& string = drawn(*body, mjGEOM_CYLINDER, kString.data());
    string.size[0] = 0.0022;
    string.size[1] = 0.5 * (height - 1.1 * radius);
    string.pos[2] = string.size[1];

    mjsGeom* const weight = mjs_addGeom(world, nullptr);
    mjs_setName(weight->element, (std::string(look.name) + "_weight").c_str());
    weight->type = mjGEOM_CYLINDER;
    weight->group = kFurniture;
    weight->pos[0] = tethers.at(i).x();
    weight->pos[1] = tethers.at(i).y();
    weight->pos[2] = 0.015;
    weight->size[0] = kWeight;
    weight->size[1] = 0.015;
    const auto dimmed = [&](std::size_t c) { return 0.45F * look.rgba.at(c); };
    for (std::size_t c = 0; c < 3; ++c) weight->rgba[c] = dimmed(c);
    taken.push_back({tethers.at(i), {kWeight, kWeight}, 0.0});
  }
  return taken;
}

}  // namespace pacer::sim
