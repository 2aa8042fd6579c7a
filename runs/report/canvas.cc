// SPDX-License-Identifier: Apache-2.0
#include "runs/report/canvas.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"

namespace pacer::report::canvas {
namespace {

constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCapital = 21.0;  // height of the font's capitals at scale 1, pixels

/// A character a byte: what continues a UTF-8 character is dropped, the rest of it becomes `?`.
std::string ascii(const std::string& line) {
  std::string out;
  for (const char c : line) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 && byte < 0xC0) continue;
    out += byte >= 0x20 && byte < 0x7F ? c : '?';
    if (out.size() > 400) break;
  }
  return out;
}

}  // namespace

cv::Mat view(const Frame& frame) {
  const auto [width, height] = frame.size;
  require(width > 0 && height > 0 && width <= 16384 && height <= 16384,
          "frame: sides must be 1 to 16384 pixels");
  const auto wanted = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3;
  require(frame.rgb.size() == wanted, "frame: its bytes do not fit its size");
  // OpenCV has no view of constant pixels; nobody writes through this one.
  return {height, width, CV_8UC3, const_cast<std::uint8_t*>(frame.rgb.data())};
}

cv::Mat resized(Frame& frame, ImageSize size) {
  frame.size = size;
  frame.rgb.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) *
                   3);
  return {size.height, size.width, CV_8UC3, frame.rgb.data()};
}

int text(cv::Mat& image, const std::string& line, cv::Point at, const TextStyle& style) {
  const double scale = style.height_px / kCapital;
  const int thickness = style.height_px > 16.0 ? 2 : 1;
  std::string shown = ascii(line);
  const auto width = [&](const std::string& words) {
    return cv::getTextSize(words, kFont, scale, thickness, nullptr).width;
  };
  if (style.most_width_px > 0 && width(shown) > style.most_width_px) {
    while (!shown.empty() && width(shown + "...") > style.most_width_px) shown.pop_back();
    shown += "...";
  }
  if (shown.empty()) return 0;
  if (style.outlined) {
    cv::putText(image, shown, at, kFont, scale, kShadow, thickness + 3, cv::LINE_AA);
  }
  cv::putText(image, shown, at, kFont, scale, style.colour, thickness, cv::LINE_AA);
  return width(shown);
}

}  // namespace pacer::report::canvas
