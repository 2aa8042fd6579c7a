// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <type_traits>

#include "learning/tracking/tracker.h"

namespace pacer::testing {

/// A picture whose grey level is `number`, for trackers that read it.
inline tracking::Picture numbered_picture(int number, cv::Size size = {64, 48}) {
  tracking::Picture picture;
  picture.grey = cv::Mat1b(size, static_cast<std::uint8_t>(number));
  picture.bgr = cv::Mat3b(size, cv::Vec3b::all(static_cast<std::uint8_t>(number)));
  return picture;
}

/// Stays where it was started.
class Still : public tracking::Tracker {
 private:
  void begin(const tracking::Picture&, const Box& target) override { box_ = target; }
  [[nodiscard]] tracking::Track follow(const tracking::Picture&) override {
    return {.box = box_, .confidence = 1.0};
  }

 protected:
  Box box_;
};

/// Stays, and throws in the picture of grey level 7.
class Throwing final : public Still {
  [[nodiscard]] tracking::Track follow(const tracking::Picture& picture) override {
    if (std::abs(picture.grey(0, 0) - 7) <= 1) throw std::runtime_error("seven");
    return {.box = box_, .confidence = 1.0};
  }
};

/// Walks to the right, two pixels plus its seed a picture.
class Walking final : public Still {
 public:
  explicit Walking(std::uint64_t seed) : step_(2.0 + static_cast<double>(seed)) {}

 private:
  [[nodiscard]] tracking::Track follow(const tracking::Picture&) override {
    box_.x += step_;
    return {.box = box_, .confidence = 0.5};
  }
  double step_;
};

/// Follows the bright pixels. It has an appearance to show once it has followed.
class Bright final : public Still {
  [[nodiscard]] tracking::Track follow(const tracking::Picture& picture) override {
    followed_ = true;
    const cv::Mat bright = picture.grey > 150;
    if (cv::countNonZero(bright) == 0) return {.box = box_, .confidence = 0.0};
    const cv::Moments moments = cv::moments(bright, true);
    box_.x = moments.m10 / moments.m00;
    box_.y = moments.m01 / moments.m00;
    return {.box = box_, .confidence = 1.0};
  }
  void annotate(Annotations& annotations) const override {
    annotations.points.push_back(
        {.at = {static_cast<float>(box_.x), static_cast<float>(box_.y)}, .radius = 5.0F});
    if (!followed_) return;
    annotations.patches.push_back(
        {.size = {2, 2}, .grey = {0, 255, 255, 0}, .tone = Tone::kMatched});
  }
  bool followed_ = false;
};

template <class T>
std::unique_ptr<tracking::Tracker> make(std::uint64_t seed) {
  if constexpr (std::is_constructible_v<T, std::uint64_t>) {
    return std::make_unique<T>(seed);
  } else {
    return std::make_unique<T>();
  }
}

template <class T>
tracking::TrackerKind kind(const char* name) {
  return {.name = name, .about = "for tests", .make = &make<T>};
}

}  // namespace pacer::testing
