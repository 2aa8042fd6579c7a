// SPDX-License-Identifier: Apache-2.0
#include "sim/livery.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "sim/panel.h"
#include "sim/print.h"
#include "sim/shape.h"
#include "sim/texture.h"

namespace pacer::sim {
namespace {

using Eigen::Vector3d;
using texture::Colour;
using texture::hsv;

const Colour& kGlass = Panel::kGlass;
const Colour& kWhite = Panel::kWhite;
const Colour& kBlack = Panel::kBlack;

struct Paint {
  Colour body, second, accent;
  double element;  // metres
  std::string number;
};

cv::Mat rear(const LeadShell& shell, const Paint& paint, Random random) {
  const double width = 2.0 * shell.half_width;
  const double height = shell.roof - shell.bottom;
  const double e = paint.element;
  Panel panel(width, height, paint.body);
  panel.fill(0.028, 0.008, width - 0.056, 0.036, kGlass);
  panel.marks(0.034, 0.013, 2, 2, e, random.fork("glass"));
  panel.text(0.034 + 2.2 * e, 0.012, 0.07, 0.028, paint.number, kWhite);
  panel.marks(width - 0.036 - e, 0.013, 1, 2, e, random.fork("glass right"));
  for (const double x : {0.004, width - 0.024}) {  // lamps
    panel.fill(x, 0.008, 0.02, 0.05, {190, 20, 22});
    panel.fill(x + 0.004, 0.022, 0.012, 0.013, kWhite);
    panel.fill(x + 0.004, 0.041, 0.012, 0.012, {250, 160, 30});
  }
  panel.checker(0.004, 0.064, 4, 3, e, kWhite, kBlack);
  panel.marks(width - 0.004 - 4.0 * e, 0.064, 4, 2, e, random.fork("right"));
  panel.slash(0.068, 0.048, 0.02, height - 0.058, 0.02, paint.second);
  panel.slash(0.098, 0.048, 0.012, height - 0.058, 0.02, paint.accent);
  panel.fill(0.066, height - 0.03, 0.058, 0.017, kWhite);  // number plate
  panel.text(0.068, height - 0.028, 0.054, 0.013, "PA " + paint.number, kBlack);
  panel.fill(0.0, height - 0.01, width, 0.01, {52, 52, 56});
  return panel.picture();
}

cv::Mat front(const LeadShell& shell, const Paint& paint, double height, Random random) {
  const double width = 2.0 * shell.half_width;
  Panel panel(width, height, paint.body);
  panel.fill(0.045, 0.008, width - 0.09, height - 0.026, kBlack);  // grille
  for (double x = 0.05; x < width - 0.055; x += 0.012)
    panel.fill(x, 0.012, 0.005, 0.02, {150, 152, 156});
  for (const double x : {0.024, width - 0.024}) {
    panel.disc(x, 0.02, 0.016, {120, 124, 130});
    panel.disc(x, 0.02, 0.012, {255, 250, 215});
    panel.disc(x, 0.02, 0.004, kBlack);
  }
  panel.marks(0.006, height - 0.017, 12, 1, 0.015, random);
  return panel.picture();
}

/// The left side (as one faces it the van drives to the left) or the right.
cv::Mat side(const LeadShell& shell, const Paint& paint, bool left, Random random) {
  const double length = shell.front - shell.rear;
  const double height = shell.roof - shell.bottom;
  const double e = 1.15 * paint.element;
  Panel panel(length, height, left ? paint.body : paint.second);
  const Colour ground = left ? paint.second : paint.body;
  // Everything is placed from the rear; the left side is mirrored when x is asked for.
  const auto at = [&](double x, double width) { return left ? length - x - width : x; };
  panel.slash(at(0.07, 0.09), 0.0, 0.09, height, left ? 0.04 : -0.04, ground);
  panel.slash(at(0.19, 0.02), 0.0, 0.02, height, left ? 0.04 : -0.04, paint.accent);
  panel.fill(at(0.268, 0.052), 0.01, 0.052, 0.042, kGlass);  // the door's window
  panel.fill(at(0.274, 0.012), 0.014, 0.012, 0.012, {150, 170, 190});
  panel.fill(at(0.262, 0.0025), 0.008, 0.0025, 0.09, kBlack);
  panel.fill(at(0.27, 0.016), 0.06, 0.016, 0.006, kBlack);
  if (left) {
    panel.checker(at(0.008, 5.0 * e), 0.008, 5, 2, e, kWhite, kBlack);
    panel.disc(at(0.135, 0.0), 0.05, 0.037, kWhite);
    panel.text(at(0.102, 0.066), 0.026, 0.066, 0.048, paint.number, kBlack);
    panel.marks(at(0.2, 3.0 * e), 0.058, 3, 2, e, random.fork("door"));
    panel.marks(at(0.008, 3.0 * e), 0.014 + 2.0 * e, 3, 2, e, random.fork("rear"));
  } else {
    panel.text(at(0.01, 0.16), 0.01, 0.16, 0.034, print::word(random), kWhite);
    panel.marks(at(0.01, 9.0 * e), 0.05, 9, 1, e, random.fork("row"));
    panel.checker(at(0.19, 4.0 * e), 0.06, 4, 2, e, paint.accent, kBlack);
    panel.disc(at(0.225, 0.0), 0.032, 0.02, kBlack);
    panel.text(at(0.208, 0.034), 0.018, 0.034, 0.028, paint.number, kWhite);
  }
  panel.marks(at(0.33, 4.0 * e), 0.066, 4, 1, e, random.fork("wing"));
  for (const double x : {-0.1285 - shell.rear, 0.1285 - shell.rear}) {  // wheel arches
    panel.disc(at(x, 0.0), height + 0.012, 0.045, kBlack);
  }
  panel.fill(0.0, height - 0.008, length, 0.008, {60, 60, 64});
  return panel.picture();
}

cv::Mat roof(double length, double width, const Paint& paint, Random random) {
  Panel panel(width, length, paint.body);
  panel.fill(0.5 * width - 0.035, 0.0, 0.03, length, paint.second);
  panel.fill(0.5 * width + 0.01, 0.0, 0.015, length, paint.accent);
  panel.disc(0.5 * width, 0.45 * length, 0.055, kWhite);
  panel.text(0.5 * width - 0.045, 0.45 * length - 0.04, 0.09, 0.08, paint.number, kBlack);
  panel.marks(0.01, 0.01, 2, 4, 0.024, random.fork("left"));
  panel.checker(width - 0.07, length - 0.1, 3, 4, 0.02, kWhite, kBlack);
  return panel.picture();
}

cv::Mat bonnet(double length, double width, const Paint& paint, Random random) {
  Panel panel(width, length, paint.body);
  panel.fill(0.5 * width - 0.035, 0.0, 0.03, length, paint.second);
  panel.fill(0.5 * width + 0.01, 0.0, 0.015, length, paint.accent);
  panel.marks(0.012, 0.015, 3, 2, 0.018, random);
  return panel.picture();
}

cv::Mat windscreen(double length, double width, Random random) {
  Panel panel(width, length, kGlass);
  panel.fill(0.0, 0.0, 0.008, length, kWhite);
  panel.fill(width - 0.008, 0.0, 0.008, length, kWhite);
  panel.marks(0.03, 0.004, 8, 1, 0.016, random);
  panel.slash(0.06, 0.03, 0.012, length - 0.04, 0.03, {70, 84, 104});
  return panel.picture();
}

}  // namespace

void LiveryConfig::validate() const {
  hue.validate("hue_deg", 0.0, 360.0);
  element.validate("element_m", 0.004, 0.03);
}

void dress_lead(mjSpec& spec, mjsBody& chassis, const Random& random, const LiveryConfig& config) {
  config.validate();
  const LeadShell shell;
  Random draw = random.fork("livery");
  const double hue = config.hue.draw(draw);
  Paint paint;
  paint.body = hsv(hue, draw.uniform(0.65, 0.9), draw.uniform(0.7, 0.95));
  paint.second = hsv(std::fmod(hue + draw.uniform(140.0, 220.0), 360.0), 0.55, 0.32);
  paint.accent = hsv(std::fmod(hue + draw.uniform(40.0, 80.0), 360.0), 0.7, 0.97);
  paint.element = config.element.draw(draw);
  paint.number = std::to_string(10 + draw.below(90));

  // The profile: roof, windscreen, bonnet.
  const double w = shell.half_width;
  const std::array<double, 4> x = {shell.rear, 0.085, 0.135, shell.front};
  const std::array<double, 4> z = {shell.roof, shell.roof, 0.118, 0.102};
  const auto along = [&](std::size_t i) {
    return std::hypot(x.at(i + 1) - x.at(i), z.at(i + 1) - z.at(i));
  };

  Atlas atlas(512);
  const Skin right = atlas.add(side(shell, paint, false, draw.fork("right")));
  const Skin left = atlas.add(side(shell, paint, true, draw.fork("left")));
  const Skin back = atlas.add(rear(shell, paint, draw.fork("rear")));
  const Skin nose = atlas.add(front(shell, paint, z[3] - shell.bottom, draw.fork("front")));
  const Skin top = atlas.add(roof(along(0), 2.0 * w, paint, draw.fork("roof")));
  const Skin glass = atlas.add(windscreen(along(1), 2.0 * w, draw.fork("windscreen")));
  const Skin lid = atlas.add(bonnet(along(2), 2.0 * w, paint, draw.fork("bonnet")));
  const Skin trim = atlas.add(texture::plain({32, 32}, {48, 48, 52}, 6.0, draw.fork("trim")));

  Shape body;
  const double low = shell.bottom;
  body.rectangle({shell.rear, w, low}, {0.0, -2.0 * w, 0.0}, {0.0, 0.0, shell.roof - low}, back);
  body.rectangle({shell.front, -w, low}, {0.0, 2.0 * w, 0.0}, {0.0, 0.0, z[3] - low}, nose);
  const std::array<const Skin*, 3> decks = {&top, &glass, &lid};
  for (std::size_t i = 0; i < 3; ++i) {  // pictures stand upright for who drives behind
    body.rectangle({x.at(i), w, z.at(i)}, {0.0, -2.0 * w, 0.0},
                   {x.at(i + 1) - x.at(i), 0.0, z.at(i + 1) - z.at(i)}, *decks.at(i));
  }
  // The sides: one strip a stretch of the profile, its picture in proportion.
  for (std::size_t i = 0; i < 3; ++i) {
    const auto share = [&](double at) {
      return static_cast<float>((at - shell.rear) / (shell.front - shell.rear));
    };
    const auto drop = [&](double at) {
      return static_cast<float>((shell.roof - at) / (shell.roof - low));
    };
    const Vector3d a(x.at(i), -w, low);
    const Vector3d b(x.at(i + 1), -w, low);
    const Vector3d c(x.at(i + 1), -w, z.at(i + 1));
    const Vector3d d(x.at(i), -w, z.at(i));
    const Vector3d over(0.0, 2.0 * w, 0.0);
    const float u0 = share(x.at(i));
    const float u1 = share(x.at(i + 1));
    const float v0 = drop(z.at(i));
    const float v1 = drop(z.at(i + 1));
    body.quad({a, b, c, d}, right, {{{u0, 1.0F}, {u1, 1.0F}, {u1, v1}, {u0, v0}}});
    body.quad({b + over, a + over, d + over, c + over}, left,
              {{{1.0F - u1, 1.0F}, {1.0F - u0, 1.0F}, {1.0F - u0, v0}, {1.0F - u1, v1}}});
  }
  body.box({0.0, 0.0, 0.034}, {0.088, 0.9 * w, 0.013}, BoxSkins::six(trim));  // sills
  body.box({shell.rear - 0.005, 0.0, 0.044}, {0.008, 0.95 * w, 0.01}, BoxSkins::six(trim));
  body.box({shell.front + 0.004, 0.0, 0.04}, {0.008, 0.95 * w, 0.01}, BoxSkins::six(trim));
  body.rectangle({shell.rear, -w, low}, {0.0, 2.0 * w, 0.0}, {shell.front - shell.rear, 0.0, 0.0},
                 trim);  // from below

  // The dark that goes with it over the floor.
  Shape shadow;
  for (const double more : {0.0, 0.025}) {
    const double x0 = shell.rear - more;
    const double y0 = 0.9 * w + more;
    shadow.rectangle({x0, -y0, 0.004 - 0.05 * more}, {shell.front + more - x0, 0.0, 0.0},
                     {0.0, 2.0 * y0, 0.0}, {cv::Rect2f(0.0F, 0.0F, 1.0F, 1.0F), 0.0F});
  }
  mjsGeom& dark = shadow.add_to(spec, chassis, "lead_shadow", "", {1, 1});
  dark.rgba[0] = dark.rgba[1] = dark.rgba[2] = 0.02F;
  dark.rgba[3] = 0.25F;

  atlas.add_to(spec, "lead_livery");
  (void)body.add_to(spec, chassis, "lead_shell", "lead_livery", atlas.size());
}

}  // namespace pacer::sim
