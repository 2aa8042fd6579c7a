// SPDX-License-Identifier: Apache-2.0
#include "studies/drawing.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "runs/report/picture.h"

namespace pacer {
namespace {

constexpr int kThin = 2;   // pixels of the drawing
constexpr int kThick = 4;  // the rim's
const cv::Scalar kRim(12, 14, 18);

cv::Scalar scalar(Ink ink) { return {double(ink[0]), double(ink[1]), double(ink[2])}; }

cv::Mat3b magnified(const cv::Mat& rgb, int scale) {
  cv::Mat3b large;
  cv::resize(rgb, large, {}, scale, scale, cv::INTER_NEAREST);
  return large;
}

}  // namespace

Drawing::Drawing(cv::Mat3b rgb, int scale) : rgb_(std::move(rgb)), scale_(scale) {}

Drawing::Drawing(const cv::Mat1b& grey, int scale) : scale_(scale) {
  cv::Mat3b rgb;
  cv::cvtColor(grey, rgb, cv::COLOR_GRAY2RGB);
  rgb_ = magnified(rgb, scale);
}

Drawing Drawing::of_surface(const cv::Mat1f& values, int scale) {
  cv::Mat1b bytes;
  cv::normalize(values, bytes, 0, 255, cv::NORM_MINMAX, CV_8U);
  cv::Mat3b colours;
  cv::applyColorMap(bytes, colours, cv::COLORMAP_VIRIDIS);
  cv::cvtColor(colours, colours, cv::COLOR_BGR2RGB);
  return {magnified(colours, scale), scale};
}

cv::Point Drawing::place(const Eigen::Vector2d& at) const {
  return {cvRound((at.x() + 0.5) * scale_ - 0.5), cvRound((at.y() + 0.5) * scale_ - 0.5)};
}

Drawing& Drawing::marker(const Eigen::Vector2d& at, Ink ink, int kind, int size) {
  cv::drawMarker(rgb_, place(at), kRim, kind, size + 2, kThick, cv::LINE_AA);
  cv::drawMarker(rgb_, place(at), scalar(ink), kind, size, kThin, cv::LINE_AA);
  return *this;
}

Drawing& Drawing::circle(const Eigen::Vector2d& at, Ink ink, int radius) {
  cv::circle(rgb_, place(at), radius, kRim, kThick, cv::LINE_AA);
  cv::circle(rgb_, place(at), radius, scalar(ink), kThin, cv::LINE_AA);
  return *this;
}

Drawing& Drawing::cross(const Eigen::Vector2d& at, Ink ink, int size) {
  return marker(at, ink, cv::MARKER_CROSS, size);
}

Drawing& Drawing::saltire(const Eigen::Vector2d& at, Ink ink, int size) {
  return marker(at, ink, cv::MARKER_TILTED_CROSS, size);
}

Drawing& Drawing::star(const Eigen::Vector2d& at, Ink ink, int size) {
  return marker(at, ink, cv::MARKER_STAR, size);
}

Drawing& Drawing::line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, Ink ink) {
  cv::line(rgb_, place(from), place(to), kRim, kThick, cv::LINE_AA);
  cv::line(rgb_, place(from), place(to), scalar(ink), kThin, cv::LINE_AA);
  return *this;
}

Drawing& Drawing::square(const Eigen::Vector2d& centre, double reach, Ink ink) {
  const Eigen::Vector2d corner(reach + 0.5, reach + 0.5);
  cv::rectangle(rgb_, place(centre - corner), place(centre + corner), scalar(ink), kThin);
  return *this;
}

std::vector<std::uint8_t> Drawing::png() const {
  Frame frame;
  frame.size = {.width = rgb_.cols, .height = rgb_.rows};
  frame.rgb.assign(rgb_.datastart, rgb_.dataend);
  return report::encode_png(frame);
}

}  // namespace pacer
