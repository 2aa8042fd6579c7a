// SPDX-License-Identifier: Apache-2.0
#include "runs/report/draw.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "runs/report/canvas.h"
#include "runs/report/marker.h"

namespace pacer::report {
namespace {

constexpr int kStrip = 56;  // height of the strip above a picture

const cv::Scalar kGreen(63, 201, 116);
const cv::Scalar kBlue(84, 160, 240);
const cv::Scalar kRail(58, 66, 78);
const cv::Scalar kSoft(160, 170, 184);

void draw_marks(cv::Mat& picture, const Annotations& annotations, int scale) {
  Marker(picture, scale).marks(annotations);
  if (!annotations.patches.empty()) {
    const int height = std::min(96, picture.rows / 4);
    draw_patches(annotations.patches, picture.rowRange(picture.rows - height, picture.rows));
  }
  canvas::text(picture, annotations.label, {10, 24},
               {.height_px = 13, .most_width_px = picture.cols - 20, .outlined = true});
}

void magnify(const Frame& frame, cv::Mat picture) {
  cv::resize(canvas::view(frame), picture, picture.size(), 0, 0, cv::INTER_CUBIC);
}

/// One command on a rail with its neutral in the middle. `sign` is -1 where +1 goes to the left.
struct Gauge {
  cv::Mat& image;
  int left, right, y;
  double sign;

  [[nodiscard]] int x(double value) const {
    const double clear = std::isfinite(value) ? std::clamp(sign * value, -1.0, 1.0) : 0.0;
    return static_cast<int>(std::lround(0.5 * (left + right) + 0.5 * clear * (right - left)));
  }
  void rail() const { cv::rectangle(image, {left, y - 4}, {right, y + 4}, kRail, cv::FILLED); }
  void bar(double value) const {
    const int from = x(0.0);
    const int to = x(value);
    cv::rectangle(image, {std::min(from, to), y - 4}, {std::max(from, to), y + 4}, kBlue,
                  cv::FILLED);
    cv::line(image, {from, y - 7}, {from, y + 7}, kSoft, 1);
  }
  void tick(double value) const {
    cv::rectangle(image, {x(value) - 1, y - 7}, {x(value) + 1, y + 7}, canvas::kInk, cv::FILLED);
  }
  void triangle(double value) const {
    const int at = x(value);
    const std::array<cv::Point, 3> corners = {{{at, y + 4}, {at - 6, y + 13}, {at + 6, y + 13}}};
    cv::fillConvexPoly(image, corners.data(), 3, kGreen, cv::LINE_AA);
  }
};

void gauge(cv::Mat& strip, int left, int right, const std::string& name, double sign,
           double Command::*field, const Hud& hud) {
  canvas::text(strip, name, {left, 18}, {.height_px = 10, .colour = kSoft});
  const Gauge gauge{strip, left, right, 34, sign};
  gauge.rail();
  gauge.bar(hud.sent.*field);
  if (hud.wanted) gauge.tick((*hud.wanted).*field);
  if (hud.teacher) gauge.triangle((*hud.teacher).*field);
}

void draw_strip(cv::Mat strip, const Hud& hud) {
  strip.setTo(canvas::kBackground);
  const int width = strip.cols;
  const int words = width * 36 / 100;
  canvas::text(strip, hud.caption, {12, 22}, {.height_px = 11, .most_width_px = words - 20});
  int x = 12;
  const auto legend = [&](const char* name, const cv::Scalar& colour) {
    cv::rectangle(strip, {x, 36}, {x + 7, 43}, colour, cv::FILLED);
    x += 12 + canvas::text(strip, name, {x + 12, 44}, {.height_px = 9, .colour = kSoft}) + 12;
  };
  legend("sent", kBlue);
  if (hud.wanted) legend("wanted", canvas::kInk);
  if (hud.teacher) legend("teacher", kGreen);
  gauge(strip, words + 10, width * 66 / 100, "steering", -1.0, &Command::steering, hud);
  gauge(strip, width * 70 / 100, width - 14, "throttle", 1.0, &Command::throttle, hud);
}

void require_scale(int scale) { require(scale >= 1 && scale <= 8, "scale: must be 1 to 8"); }

}  // namespace

ImageSize drawn_size(ImageSize size, int scale) {
  require_scale(scale);
  const auto even = [](int side) { return side + side % 2; };
  return {even(size.width * scale), even(size.height * scale + kStrip)};
}

void draw(const Frame& frame, const Annotations& annotations, Frame& into, int scale) {
  require_scale(scale);
  require(&frame != &into, "draw: a frame cannot be drawn into itself");
  into.index = frame.index;
  into.time = frame.time;
  cv::Mat picture = canvas::resized(into, {frame.size.width * scale, frame.size.height * scale});
  magnify(frame, picture);
  draw_marks(picture, annotations, scale);
}

void draw(const Frame& frame, const Annotations& annotations, const Hud& hud, Frame& into,
          int scale) {
  require(&frame != &into, "draw: a frame cannot be drawn into itself");
  into.index = frame.index;
  into.time = frame.time;
  cv::Mat whole = canvas::resized(into, drawn_size(frame.size, scale));
  whole.setTo(canvas::kBackground);
  const cv::Rect place(0, kStrip, frame.size.width * scale, frame.size.height * scale);
  cv::Mat picture = whole(place);
  magnify(frame, picture);
  draw_marks(picture, annotations, scale);
  draw_strip(whole.rowRange(0, kStrip), hud);
}

}  // namespace pacer::report
