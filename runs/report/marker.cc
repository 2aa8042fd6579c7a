// SPDX-License-Identifier: Apache-2.0
#include "runs/report/marker.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>

#include "core/check.h"
#include "runs/report/canvas.h"

namespace pacer::report {
namespace {

constexpr int kShift = 3;  // OpenCV draws at an eighth of a pixel

/// What `stroke_once(colour, width)` draws, on its dark rim.
template <class Stroke>
void stroke(const cv::Scalar& colour, int width, const Stroke& stroke_once) {
  stroke_once(canvas::kShadow, width + 2);
  stroke_once(colour, width);
}

int width_of(Tone tone) { return tone == Tone::kIgnored || tone == Tone::kNeutral ? 1 : 2; }

}  // namespace

cv::Scalar colour_of(Tone tone) {
  switch (tone) {
    case Tone::kMatched:
      return {63, 201, 116};
    case Tone::kTarget:
      return {255, 159, 28};
    case Tone::kIgnored:
      return {150, 156, 166};
    case Tone::kNeutral:
      break;
  }
  return {245, 247, 250};
}

cv::Scalar colour_of(std::string_view code) {
  unsigned value = 0;
  const char* const end = code.data() + code.size();
  const bool good = code.size() == 7 && code.front() == '#' &&
                    std::from_chars(code.data() + 1, end, value, 16).ptr == end;
  require(good, "colour: want #rrggbb, got " + std::string(code));
  return {static_cast<double>(value >> 16U), static_cast<double>(value >> 8U & 255U),
          static_cast<double>(value & 255U)};
}

Marker::Marker(cv::Mat& image, double scale)
    : image_(image), scale_(scale), reach_(4.0 * std::max(image.cols, image.rows)) {}

void Marker::marks(const Annotations& annotations) {
  for (const LineMark& mark : annotations.lines) line(mark);
  for (const BoxMark& mark : annotations.boxes) box(mark);
  for (const bool ignored : {true, false}) {
    for (const PointMark& mark : annotations.points) {
      if ((mark.tone == Tone::kIgnored) == ignored) point(mark);
    }
  }
}

void Marker::line(const LineMark& mark) {
  if (!shown(mark.from) || !shown(mark.to)) return;
  stroke(colour_of(mark.tone), width_of(mark.tone), [&](const cv::Scalar& colour, int width) {
    cv::line(image_, fixed(mark.from), fixed(mark.to), colour, width, cv::LINE_AA, kShift);
  });
}

void Marker::box(const BoxMark& mark) {
  if (!shown(mark.low) || !shown(mark.high)) return;
  stroke(colour_of(mark.tone), width_of(mark.tone), [&](const cv::Scalar& colour, int width) {
    cv::rectangle(image_, fixed(mark.low), fixed(mark.high), colour, width, cv::LINE_AA, kShift);
  });
}

void Marker::point(const PointMark& mark) {
  if (!shown(mark.at) || !std::isfinite(mark.radius)) return;
  const double radius = std::clamp(static_cast<double>(mark.radius) * scale_, 2.5, reach_);
  const int fixed_radius = static_cast<int>(std::lround(radius * (1 << kShift)));
  if (radius < 4.0) {  // too small for a ring: a dot
    cv::circle(image_, fixed(mark.at), fixed_radius + (3 << (kShift - 1)), canvas::kShadow,
               cv::FILLED, cv::LINE_AA, kShift);
    cv::circle(image_, fixed(mark.at), fixed_radius, colour_of(mark.tone), cv::FILLED, cv::LINE_AA,
               kShift);
    return;
  }
  stroke(colour_of(mark.tone), width_of(mark.tone), [&](const cv::Scalar& colour, int width) {
    cv::circle(image_, fixed(mark.at), fixed_radius, colour, width, cv::LINE_AA, kShift);
  });
}

void Marker::outline(const Box& box, const cv::Scalar& colour, bool dashed) {
  const PixelPoint low{static_cast<float>(box.x - 0.5 * box.width),
                       static_cast<float>(box.y - 0.5 * box.height)};
  const PixelPoint high{static_cast<float>(box.x + 0.5 * box.width),
                        static_cast<float>(box.y + 0.5 * box.height)};
  if (!shown(low) || !shown(high)) return;
  const cv::Point a = fixed(low);
  const cv::Point b = fixed(high);
  constexpr int kWidth = 2;
  stroke(colour, kWidth, [&](const cv::Scalar& paint, int width) {
    if (!dashed) {
      cv::rectangle(image_, a, b, paint, width, cv::LINE_AA, kShift);
      return;
    }
    const std::array<cv::Point, 5> corners = {a, {b.x, a.y}, b, {a.x, b.y}, a};
    for (std::size_t i = 0; i + 1 < corners.size(); ++i) {
      dashes(corners[i], corners[i + 1], paint, width);
    }
  });
}

void Marker::dashes(cv::Point from, cv::Point to, const cv::Scalar& colour, int width) {
  constexpr double kPeriod = 12 << kShift;
  const cv::Point2d along = to - from;
  const double length = std::hypot(along.x, along.y);
  const int count = std::max(1, static_cast<int>(std::lround(length / kPeriod)));
  for (int i = 0; i < count; ++i) {
    const auto at = [&](double share) {
      const cv::Point2d here = cv::Point2d(from) + along * ((i + share) / count);
      return cv::Point(cvRound(here.x), cvRound(here.y));
    };
    cv::line(image_, at(0.0), at(0.5), colour, width, cv::LINE_AA, kShift);
  }
}

bool Marker::shown(PixelPoint at) const {
  const auto inside = [this](float value) {
    return std::isfinite(value) && std::abs(static_cast<double>(value)) * scale_ <= reach_;
  };
  return inside(at.x) && inside(at.y);
}

/// From pixel centres of the frame to OpenCV's fixed-point pixel centres of the picture.
cv::Point Marker::fixed(PixelPoint at) const {
  const auto one = [this](float value) {
    const double moved = (static_cast<double>(value) + 0.5) * scale_ - 0.5;
    return static_cast<int>(std::lround(moved * (1 << kShift)));
  };
  return {one(at.x), one(at.y)};
}

void draw_patches(std::span<const PatchMark> patches, cv::Mat strip) {
  constexpr int kGap = 6;
  const int height = strip.rows - 2 * kGap;
  int left = kGap;
  for (const PatchMark& patch : patches) {
    const auto [across, down] = patch.size;
    if (across <= 0 || down <= 0 || height <= 0 ||
        patch.grey.size() != static_cast<std::size_t>(across) * static_cast<std::size_t>(down)) {
      continue;
    }
    const double share = std::min(static_cast<double>(height) / down, 2.0 * height / across);
    const cv::Rect place(left, kGap, std::max(1, cvRound(share * across)),
                         std::clamp(cvRound(share * down), 1, height));
    if (place.x + place.width + kGap > strip.cols) break;
    // OpenCV has no view of constant pixels; nobody writes through this one.
    const cv::Mat grey(down, across, CV_8UC1, const_cast<std::uint8_t*>(patch.grey.data()));
    cv::Mat rgb;
    cv::cvtColor(grey, rgb, cv::COLOR_GRAY2RGB);
    cv::resize(rgb, strip(place), place.size(), 0, 0,
               share < 1.0 ? cv::INTER_AREA : cv::INTER_NEAREST);
    const cv::Scalar colour = colour_of(patch.tone);
    cv::rectangle(strip, place, colour, width_of(patch.tone));
    if (patch.tone == Tone::kMatched) {
      const int radius = std::clamp(std::min(place.width, place.height) / 6, 3, 9);
      const cv::Point eye(place.x + place.width - radius - 4, place.y + radius + 4);
      cv::circle(strip, eye, radius + 1, canvas::kShadow, cv::FILLED, cv::LINE_AA);
      cv::circle(strip, eye, radius, colour, 2, cv::LINE_AA);
      cv::circle(strip, eye, std::max(1, radius / 3), colour, cv::FILLED, cv::LINE_AA);
    }
    left += place.width + kGap;
  }
}

}  // namespace pacer::report
