// SPDX-License-Identifier: Apache-2.0
#include "sim/panel.h"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "sim/print.h"

namespace pacer::sim {
namespace {

using texture::Colour;
using texture::shade;

constexpr double kTexels = 900.0;  // a metre

int px(double metres) { return static_cast<int>(std::lround(metres * kTexels)); }

}  // namespace

const Colour Panel::kGlass(26, 32, 44);
const Colour Panel::kWhite(244, 243, 238);
const Colour Panel::kBlack(18, 18, 22);

Panel::Panel(double width, double height, const Colour& paint)
    : picture_(cv::Size(px(width), px(height)), CV_8UC3, paint) {}

void Panel::fill(double x, double y, double width, double height, const Colour& colour) {
  cv::rectangle(picture_, cv::Rect(px(x), px(y), px(width), px(height)), colour, cv::FILLED);
}

void Panel::disc(double x, double y, double radius, const Colour& colour) {
  cv::circle(picture_, {px(x), px(y)}, px(radius), colour, cv::FILLED, cv::LINE_AA);
}

void Panel::slash(double x, double y, double width, double height, double lean,
                  const Colour& colour) {
  const std::vector<cv::Point> corners = {{px(x + lean), px(y)},
                                          {px(x + lean + width), px(y)},
                                          {px(x + width), px(y + height)},
                                          {px(x), px(y + height)}};
  cv::fillConvexPoly(picture_, corners, colour, cv::LINE_AA);
}

void Panel::text(double x, double y, double width, double height, const std::string& words,
                 const Colour& ink) {
  print::write(picture_, words, {px(x), px(y), px(width), px(height)}, ink);
}

void Panel::checker(double x, double y, int columns, int rows, double side, const Colour& even,
                    const Colour& odd) {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      fill(x + column * side, y + row * side, side, side, (row + column) % 2 == 0 ? even : odd);
    }
  }
}

void Panel::marks(double x, double y, int columns, int rows, double side, Random random) {
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const double left = x + column * side;
      const double top = y + row * side;
      const bool dark = random.chance(0.5);
      const Colour ground = dark ? shade(print::bright(random), -0.65) : kWhite;
      const Colour ink = dark ? shade(print::bright(random), 0.55) : kBlack;
      fill(left, top, 0.92 * side, 0.92 * side, ground);
      switch (random.below(4)) {
        case 0:
          disc(left + 0.46 * side, top + 0.46 * side, 0.3 * side, ink);
          break;
        case 1:
          fill(left + 0.15 * side, top + 0.15 * side, 0.3 * side, 0.62 * side, ink);
          break;
        case 2:
          slash(left + 0.1 * side, top + 0.12 * side, 0.3 * side, 0.68 * side, 0.4 * side, ink);
          break;
        default:
          fill(left + 0.12 * side, top + 0.5 * side, 0.68 * side, 0.28 * side, ink);
      }
    }
  }
}

}  // namespace pacer::sim
