// SPDX-License-Identifier: Apache-2.0
#include "sim/person.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <opencv2/core.hpp>

#include "core/check.h"
#include "embedded/models.h"
#include "sim/panel.h"
#include "sim/print.h"
#include "sim/room.h"
#include "sim/texture.h"

namespace pacer::sim {
namespace {

using texture::Colour;
using texture::hsv;
using texture::shade;

const Colour kSkin(214, 164, 132);
const Colour kHair(66, 44, 30);

struct SpecDeleter {
  void operator()(mjSpec* spec) const noexcept { mj_deleteSpec(spec); }
};

/// The pictures of a thing's sides as it is looked at: x ahead, y left, z up.
struct Sides {
  cv::Mat front, back, left, right, top;
};

/// The texel of `sides` in the direction (x, y, z) from the middle of a cube.
cv::Vec3b texel(const Sides& sides, double x, double y, double z) {
  const double most = std::max({std::abs(x), std::abs(y), std::abs(z)});
  const cv::Mat* side = &sides.top;
  double right = -y;
  double down = -x;
  if (std::abs(x) == most) {
    side = x > 0.0 ? &sides.front : &sides.back;
    right = x > 0.0 ? y : -y;
    down = -z;
  } else if (std::abs(y) == most) {
    side = y > 0.0 ? &sides.left : &sides.right;
    right = y > 0.0 ? -x : x;
    down = -z;
  }
  const auto index = [most](double along, int count) {
    return std::clamp(static_cast<int>(0.5 * (along / most + 1.0) * count), 0, count - 1);
  };
  return side->at<cv::Vec3b>(index(down, side->rows), index(right, side->cols));
}

/// Wraps `sides` about whatever wears the material: OpenGL's cube map of them.
void dress(mjSpec& spec, const std::string& material, const Sides& sides) {
  constexpr int kFace = 96;  // texels: a print of 10 cm at its own resolution
  cv::Mat faces(6 * kFace, kFace, CV_8UC3);
  for (int row = 0; row < kFace; ++row) {
    const double t = (2.0 * row + 1.0) / kFace - 1.0;
    for (int column = 0; column < kFace; ++column) {
      const double s = (2.0 * column + 1.0) / kFace - 1.0;
      const std::array<cv::Vec3d, 6> towards = {
          {{1.0, -t, -s}, {-1.0, -t, s}, {s, 1.0, t}, {s, -1.0, -t}, {s, -t, 1.0}, {-s, -t, -1.0}}};
      for (int face = 0; face < 6; ++face) {
        const cv::Vec3d& d = towards.at(static_cast<std::size_t>(face));
        faces.at<cv::Vec3b>(face * kFace + row, column) = texel(sides, d[0], d[1], d[2]);
      }
    }
  }
  mjsTexture* const texture = mjs_addTexture(&spec, nullptr);
  check(mjs_setName(texture->element, material.c_str()) == 0, "a figure is dressed once");
  texture->type = mjTEXTURE_CUBE;
  texture->colorspace = mjCOLORSPACE_LINEAR;
  texture->width = faces.cols;
  texture->height = faces.rows;
  texture->nchannel = 3;
  mjs_setBuffer(texture->data, faces.data, static_cast<int>(faces.total() * 3));
  mjsMaterial* const worn =
      mjs_asMaterial(mjs_findElement(&spec, mjOBJ_MATERIAL, material.c_str()));
  check(worn != nullptr, "models/person.xml has the materials that are printed");
  mjs_setInStringVec(worn->textures, mjTEXROLE_RGB, material.c_str());
  worn->specular = 0.0F;
  worn->shininess = 0.0F;
}

/// A picture for each side, made by `paint(panel, random)` on `width` x `height` metres of
/// `ground`.
template <class Paint>
Sides printed(double width, double height, const Colour& ground, const Random& random,
              Paint&& paint) {
  const auto side = [&](const char* name) {
    Panel panel(width, height, ground);
    paint(panel, random.fork(name));
    return panel.picture().clone();
  };
  return {side("front"), side("back"), side("left"), side("right"), side("top")};
}

Sides backpack(const Colour& body, const Colour& second, double e, const Random& random) {
  const std::string number = std::to_string(10 + random.fork("number").below(90));
  return printed(0.072, 0.078, body, random, [&](Panel& panel, const Random& side) {
    panel.checker(0.003, 0.004, 4, 2, 0.6 * e, Panel::kWhite, Panel::kBlack);
    panel.disc(0.055, 0.016, 0.014, Panel::kWhite);
    panel.text(0.045, 0.008, 0.02, 0.016, number, Panel::kBlack);
    panel.marks(0.004, 0.032, 4, 2, e, side);
    panel.slash(0.004, 0.064, 0.03, 0.010, 0.012, second);
    panel.fill(0.050, 0.064, 0.018, 0.010, Panel::kBlack);
  });
}

Sides coat(const Colour& body, const Colour& second, double e, const Random& random) {
  return printed(0.084, 0.112, body, random, [&](Panel& panel, const Random& side) {
    panel.fill(0.0, 0.036, 0.084, 0.5 * e, second);
    panel.marks(0.006, 0.052, 5, 1, e, side.fork("row"));
    panel.checker(0.0, 0.074, 10, 2, 0.6 * e, Panel::kWhite, second);
    panel.marks(0.004, 0.096, 5, 1, e, side.fork("hem"));
    panel.fill(0.040, 0.0, 0.003, 0.112, Panel::kBlack);  // the zip
  });
}

Sides sleeve(const Colour& body, const Colour& second, double e, const Random& random) {
  return printed(0.045, 0.06, body, random, [&](Panel& panel, const Random& side) {
    panel.fill(0.0, 0.006, 0.045, 0.6 * e, Panel::kWhite);
    panel.marks(0.003, 0.018, 3, 1, e, side);
    panel.slash(0.004, 0.038, 0.014, 0.018, 0.014, second);
    panel.slash(0.026, 0.038, 0.008, 0.018, 0.010, Panel::kWhite);
  });
}

Sides trousers(const Colour& cloth, const Colour& accent, double e, const Random& random) {
  return printed(0.05, 0.075, cloth, random, [&](Panel& panel, const Random& side) {
    panel.slash(0.002, 0.004, 0.012, 0.022, 0.010, accent);
    panel.marks(0.022, 0.006, 2, 1, e, side.fork("pocket"));
    panel.checker(0.004, 0.030, 4, 2, 0.7 * e, Panel::kWhite, Panel::kBlack);
    panel.marks(0.006, 0.056, 3, 1, e, side.fork("knee"));
  });
}

Sides head(const Random& random) {
  Sides sides = printed(0.046, 0.058, kSkin, random, [](Panel& panel, const Random&) {
    panel.fill(0.0, 0.0, 0.046, 0.022, kHair);
  });
  Panel face(0.046, 0.058, kSkin);
  face.fill(0.0, 0.0, 0.046, 0.012, kHair);
  for (const double x : {0.013, 0.033}) {
    face.disc(x, 0.026, 0.0045, Panel::kWhite);
    face.disc(x, 0.026, 0.0022, Panel::kBlack);
    face.fill(x - 0.005, 0.018, 0.010, 0.002, kHair);
  }
  face.fill(0.0215, 0.028, 0.003, 0.010, shade(kSkin, -0.2));
  face.fill(0.015, 0.044, 0.016, 0.003, {150, 60, 60});
  sides.front = face.picture();
  Panel hair(0.046, 0.058, kHair);
  hair.fill(0.0, 0.040, 0.046, 0.018, kSkin);
  for (double x = 0.003; x < 0.045; x += 0.006)
    hair.fill(x, 0.006, 0.002, 0.030, shade(kHair, 0.3));
  sides.back = hair.picture();
  return sides;
}

Sides hat(const Colour& body, const Colour& accent, double e, const Random& random) {
  return printed(0.05, 0.04, body, random, [&](Panel& panel, const Random& side) {
    panel.checker(0.0, 0.004, 8, 1, 0.5 * e, Panel::kWhite, accent);
    panel.marks(0.003, 0.018, 3, 1, e, side);
  });
}

Sides boot(const Random& random) {
  return printed(0.06, 0.03, {74, 50, 34}, random, [](Panel& panel, const Random&) {
    panel.fill(0.0, 0.022, 0.06, 0.008, {226, 220, 204});
    for (double x = 0.01; x < 0.055; x += 0.012) panel.fill(x, 0.008, 0.005, 0.004, Panel::kWhite);
  });
}

}  // namespace

void add_person(mjSpec& spec, mjsBody& chassis, const std::string& prefix, const Random& random,
                const LiveryConfig& config) {
  config.validate();
  const std::string xml{embedded::models("person.xml")};
  std::array<char, 512> error{};
  const std::unique_ptr<mjSpec, SpecDeleter> person{
      mj_parseXMLString(xml.c_str(), nullptr, error.data(), static_cast<int>(error.size()))};
  check(person != nullptr, error.data());

  Random draw = random.fork("clothes");
  const double hue = config.hue.draw(draw);
  const double e = 0.8 * config.element.draw(draw);  // narrower than a van
  const Colour body = hsv(hue, draw.uniform(0.65, 0.9), draw.uniform(0.7, 0.95));
  const Colour second = hsv(std::fmod(hue + draw.uniform(140.0, 220.0), 360.0), 0.6, 0.4);
  const Colour accent = hsv(std::fmod(hue + draw.uniform(40.0, 80.0), 360.0), 0.7, 0.97);
  mjSpec& own = *person;
  dress(own, "coat", coat(body, second, e, draw.fork("coat")));
  dress(own, "sleeve", sleeve(body, second, e, draw.fork("sleeve")));
  dress(own, "backpack", backpack(accent, second, e, draw.fork("backpack")));
  dress(own, "trousers", trousers(shade(second, -0.2), accent, e, draw.fork("trousers")));
  dress(own, "head", head(draw.fork("head")));
  dress(own, "hat", hat(second, accent, e, draw.fork("hat")));
  dress(own, "boot", boot(draw.fork("boot")));
  dress(own, "glove", printed(0.02, 0.02, kSkin, draw, [](Panel&, const Random&) {}));

  // The chassis carries the figure and is not seen.
  for (mjsElement* geom = mjs_firstChild(&chassis, mjOBJ_GEOM, 1); geom != nullptr;
       geom = mjs_nextChild(&chassis, geom, 1)) {
    mjs_asGeom(geom)->group = kProxy;
  }
  mjs_setDeepCopy(&spec, 1);  // `person` dies here
  mjsFrame* const place = mjs_addFrame(&chassis, nullptr);
  mjsBody* const figure = mjs_findBody(person.get(), "person");
  check(mjs_attach(place->element, figure->element, prefix.c_str(), "") != nullptr,
        "a figure can be attached to a chassis");
}

Gait::Gait(const mjModel& model, const std::string& prefix) : time_step_(model.opt.timestep) {
  const auto id = [&](const std::string& name) {
    const int found = mj_name2id(&model, mjOBJ_ACTUATOR, (prefix + name).c_str());
    check(found >= 0, "models/person.xml has every joint that Gait looks for");
    return found;
  };
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const std::string side = i == 0 ? "left_" : "right_";
    sides_.at(i) = {.hip = id(side + "hip"),
                    .knee = id(side + "knee"),
                    .shoulder = id(side + "shoulder"),
                    .ahead = 0.5 * static_cast<double>(i)};
  }
}

void Gait::step(mjData& data, double speed) noexcept {
  constexpr double kHip = 0.38;                       // radians, either way
  constexpr double kKnee = 0.55;                      // radians, of the leg that swings
  constexpr double kShoulder = 0.42;                  // radians, either way
  constexpr double kLeg = 0.14;                       // metres, hip to ankle
  constexpr double kBrisk = 0.2;                      // m/s: slower strides are shorter
  constexpr double kEase = 0.25;                      // seconds until a stride has its length
  const double stride = 4.0 * kLeg * std::sin(kHip);  // metres: two steps
  const double wanted = std::min(std::abs(speed) / kBrisk, 1.0);
  reach_ += (wanted - reach_) * time_step_ / kEase;
  phase_ = std::fmod(phase_ + std::abs(speed) * time_step_ / stride, 1.0);
  for (const Side& side : sides_) {
    const double turn = 2.0 * std::numbers::pi * (phase_ + side.ahead);
    data.ctrl[side.hip] = reach_ * kHip * std::cos(turn);
    // Bent while the leg comes ahead, in the second half of its turn.
    data.ctrl[side.knee] = -reach_ * kKnee * std::max(0.0, -std::sin(turn));
    data.ctrl[side.shoulder] = -reach_ * kShoulder * std::cos(turn);
  }
}

}  // namespace pacer::sim
