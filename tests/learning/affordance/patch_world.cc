// SPDX-License-Identifier: Apache-2.0
#include "tests/learning/affordance/patch_world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace pacer::testing {
namespace {

/// Random shapes of random greys, blurred a little: corners and blobs at many scales.
cv::Mat texture(int width, int height, int shapes, double largest, Random random) {
  cv::Mat image(height, width, CV_8UC3, cv::Scalar::all(128));
  for (int i = 0; i < shapes; ++i) {
    const cv::Point2d at(random.uniform(0.0, width), random.uniform(0.0, height));
    const double size = random.uniform(2.0, largest);
    const cv::Scalar colour(random.uniform(20, 235), random.uniform(20, 235),
                            random.uniform(20, 235));
    const double angle = random.uniform(0.0, 180.0);
    if (random.chance(0.5)) {
      cv::ellipse(image, at, cv::Size2d(size, size * random.uniform(0.3, 1.0)), angle, 0.0, 360.0,
                  colour, cv::FILLED, cv::LINE_AA);
    } else {
      cv::Point2f corners[4];
      cv::RotatedRect(at, cv::Size2d(size, 2.0 * size), static_cast<float>(angle)).points(corners);
      const std::vector<cv::Point> points(corners, corners + 4);
      cv::fillConvexPoly(image, points, colour, cv::LINE_AA);
    }
  }
  cv::GaussianBlur(image, image, {3, 3}, 0.7);
  return image;
}

constexpr int kPatchTexture = 160;

}  // namespace

BoxMark PatchStep::box() const {
  const auto half = static_cast<float>(0.5 * side);
  const auto px = static_cast<float>(x);
  const auto py = static_cast<float>(y);
  return {{px - half, py - half}, {px + half, py + half}, Tone::kTarget};
}

std::vector<PatchStep> wander(int frames, Random random) {
  const double p = random.uniform(0.0, 6.28);
  const double q = random.uniform(0.0, 6.28);
  const double r = random.uniform(0.0, 6.28);
  const double pace = random.uniform(0.9, 1.1) / kPatchRate;
  std::vector<PatchStep> steps;
  for (int i = 0; i < frames; ++i) {
    const double t = i * pace;
    PatchStep step;
    step.side = 46.0 + 12.0 * std::sin(0.9 * t + p) + 4.0 * std::sin(2.3 * t + q);
    step.x = 0.5 * kPatchImage.width + 45.0 * std::sin(1.3 * t + q) + 8.0 * std::sin(3.1 * t + r);
    step.y = 66.0 + 0.25 * step.side + 2.0 * std::sin(5.0 * t + r);
    step.pan = 170.0 * t + 30.0 * std::sin(1.7 * t + r);
    step.command.steering =
        std::clamp((0.5 * kPatchImage.width - step.x) / (0.5 * kPatchImage.width), -1.0, 1.0);
    step.command.throttle = std::clamp((66.0 - step.side) / 60.0, 0.0, 1.0);
    steps.push_back(step);
  }
  return steps;
}

struct PatchPainter::Impl {
  cv::Mat patch;
  cv::Mat background;
};

PatchPainter::PatchPainter(std::uint64_t background) : impl_(std::make_unique<Impl>()) {
  impl_->patch = texture(kPatchTexture, kPatchTexture, 60, 22.0, Random(77).fork("patch"));
  impl_->background =
      texture(1024, kPatchImage.height, 260, 16.0, Random(78).fork("background", background));
}
PatchPainter::~PatchPainter() = default;
PatchPainter::PatchPainter(PatchPainter&&) noexcept = default;

void PatchPainter::paint(const PatchStep& step, std::uint64_t index, Frame& frame) const {
  frame.index = index;
  frame.time = Seconds{static_cast<double>(index) / kPatchRate};
  frame.size = kPatchImage;
  frame.rgb.resize(static_cast<std::size_t>(3 * kPatchImage.width * kPatchImage.height));
  cv::Mat image(kPatchImage.height, kPatchImage.width, CV_8UC3, frame.rgb.data());
  const double room = impl_->background.cols - kPatchImage.width;
  const int left = static_cast<int>(std::abs(std::fmod(std::abs(step.pan), 2.0 * room) - room));
  impl_->background(cv::Rect(left, 0, kPatchImage.width, kPatchImage.height)).copyTo(image);
  if (!step.visible) return;
  const double scale = step.side / kPatchTexture;
  const cv::Matx23d place(scale, 0.0, step.x - 0.5 * step.side, 0.0, scale,
                          step.y - 0.5 * step.side);
  cv::Mat smooth;
  const double blur = std::max(0.1, 0.45 / scale - 0.4);  // against aliasing
  cv::GaussianBlur(impl_->patch, smooth, {0, 0}, blur);
  cv::warpAffine(smooth, image, place, image.size(), cv::INTER_LINEAR, cv::BORDER_TRANSPARENT);
}

namespace {

class PatchStream final : public DemonstrationStream {
 public:
  PatchStream(const std::vector<PatchStep>& steps, std::uint64_t background)
      : steps_(steps), painter_(background) {}

  const DemonstratedStep* next() override {
    if (index_ == steps_.size()) return nullptr;
    painter_.paint(steps_[index_], index_, frame_);
    step_ = {&frame_, steps_[index_].command};
    ++index_;
    return &step_;
  }

 private:
  const std::vector<PatchStep>& steps_;
  PatchPainter painter_;
  std::size_t index_ = 0;
  Frame frame_;
  DemonstratedStep step_;
};

}  // namespace

PatchDemonstration::PatchDemonstration(int episodes, int frames, std::uint64_t seed) {
  for (int e = 0; e < episodes; ++e) {
    episodes_.push_back(
        wander(frames, Random(seed).fork("episode", static_cast<std::uint64_t>(e))));
  }
}

std::unique_ptr<DemonstrationStream> PatchDemonstration::open(std::size_t episode) const {
  return std::make_unique<PatchStream>(episodes_.at(episode), episode);
}

}  // namespace pacer::testing
