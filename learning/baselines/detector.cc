// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/detector.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/xobjdetect.hpp>
#include <string>
#include <system_error>

#include "core/check.h"
#include "learning/sealed_file.h"

namespace pacer::baselines {
namespace {

constexpr int kWindow = 24;       // pixels; OpenCV's
constexpr double kMargin = 1.15;  // of a window about the target: its outline is to be seen
constexpr const char* kNode = "detector";

/// The picture with the usual target as wide as it is high.
void squeeze(const cv::Mat1b& grey, double aspect, cv::Mat1b& squeezed) {
  const cv::Size size(std::max(1, cvRound(grey.cols / aspect)), grey.rows);
  cv::resize(grey, squeezed, size, 0.0, 0.0, aspect > 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
}

/// A folder for files that live as long as it.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "pacer-XXXXXX").string();
    if (::mkdtemp(name.data()) == nullptr) {
      throw std::system_error(errno, std::generic_category(), "cannot make the folder " + name);
    }
    path_ = name;
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::filesystem::path& path() const noexcept { return path_; }

 private:
  std::filesystem::path path_;
};

/// Discards what is printed to std::cerr.
class Quiet {
 public:
  Quiet() : old_(std::cerr.rdbuf(nullptr)) {}
  ~Quiet() {
    std::cerr.rdbuf(old_);
    std::cerr.clear();
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  std::streambuf* old_;
};

/// Writes pictures into one folder, named in order.
class PictureFolder {
 public:
  explicit PictureFolder(std::filesystem::path path) : path_(std::move(path)) {
    std::filesystem::create_directory(path_);
  }
  void add(const cv::Mat1b& picture) {
    const std::filesystem::path file = path_ / fmt::format("{:06}.pgm", count_++);
    std::ofstream out(file, std::ios::binary);
    out << fmt::format("P5 {} {} 255\n", picture.cols, picture.rows);
    for (int row = 0; row < picture.rows; ++row) {
      out.write(reinterpret_cast<const char*>(picture.ptr(row)), picture.cols);
    }
    if (!out.flush()) {
      throw std::runtime_error(file.string() +
                               ": cannot be written; training needs room for temporary files");
    }
  }
  [[nodiscard]] int count() const noexcept { return count_; }
  [[nodiscard]] std::string path() const { return path_.string(); }

 private:
  std::filesystem::path path_;
  int count_ = 0;
};

/// The square window about `target` in the squeezed picture.
cv::Rect2d window_about(const Box& target, double aspect) {
  const double side = kMargin * std::sqrt(target.width / aspect * target.height);
  return {(target.x + 0.5) / aspect - 0.5 * side, target.y + 0.5 - 0.5 * side, side, side};
}

/// Puts the rectangles of `squeezed` beside, above and below `target` that are large enough.
void add_background(const cv::Mat1b& squeezed, const std::optional<cv::Rect2d>& target,
                    PictureFolder& folder) {
  const cv::Rect whole(0, 0, squeezed.cols, squeezed.rows);
  if (!target) {
    folder.add(squeezed);
    return;
  }
  const cv::Rect around =
      cv::Rect(cv::Point(cvFloor(target->x), cvFloor(target->y)),
               cv::Point(cvCeil(target->x + target->width), cvCeil(target->y + target->height))) &
      whole;
  const int right = around.x + around.width;
  const int bottom = around.y + around.height;
  for (const cv::Rect& part : {cv::Rect(0, 0, around.x, whole.height),
                               {right, 0, whole.width - right, whole.height},
                               {around.x, 0, around.width, around.y},
                               {around.x, bottom, around.width, whole.height - bottom}}) {
    constexpr int kLeast = kWindow + 8;
    if (part.width >= kLeast && part.height >= kLeast) folder.add(squeezed(part).clone());
  }
}

/// The targets' median width over height.
double usual_aspect(std::span<const MarkedPicture> pictures) {
  std::vector<double> aspects;
  for (const MarkedPicture& picture : pictures) {
    if (picture.target) aspects.push_back(picture.target->width / picture.target->height);
  }
  if (aspects.empty()) return 1.0;
  const auto middle = aspects.begin() + static_cast<std::ptrdiff_t>(aspects.size() / 2);
  std::ranges::nth_element(aspects, middle);
  return std::clamp(*middle, 0.25, 4.0);
}

cv::FileStorage storage_to_write() {
  return {".yml", cv::FileStorage::WRITE | cv::FileStorage::MEMORY};
}

/// What OpenCV learnt.
std::vector<WaldBoost::Weak> weak_of(const cv::xobjdetect::WBDetector& detector) {
  cv::FileStorage out = storage_to_write();
  out << kNode;
  detector.write(out);
  const cv::FileStorage in(out.releaseAndGetString(),
                           cv::FileStorage::READ | cv::FileStorage::MEMORY);
  const cv::FileNode node = in[kNode];
  std::vector<WaldBoost::Weak> weak(node["feature_indices"].size());
  for (std::size_t i = 0; i < weak.size(); ++i) {
    const auto at = static_cast<int>(i);
    weak[i] = {.feature = static_cast<int>(node["feature_indices"][at]),
               .polarity = static_cast<int>(node["polarities"][at]),
               .threshold = static_cast<float>(node["thresholds"][at]),
               .weight = static_cast<float>(node["alphas"][at]),
               .least = static_cast<float>(node["cascade_thresholds"][at])};
  }
  return weak;
}

/// The same, for OpenCV to read.
std::string text_of(const std::vector<WaldBoost::Weak>& weak) {
  cv::FileStorage out = storage_to_write();
  out << kNode << "{"
      << "waldboost_params"
      << "{"
      << "weak_count" << static_cast<int>(weak.size()) << "}";
  const auto list = [&](const char* name, const auto& field) {
    out << name << "[";
    for (const WaldBoost::Weak& one : weak) out << one.*field;
    out << "]";
  };
  list("thresholds", &WaldBoost::Weak::threshold);
  list("alphas", &WaldBoost::Weak::weight);
  list("polarities", &WaldBoost::Weak::polarity);
  list("cascade_thresholds", &WaldBoost::Weak::least);
  list("feature_indices", &WaldBoost::Weak::feature);
  out << "}";
  return out.releaseAndGetString();
}

}  // namespace

void WaldBoost::write(ByteWriter& out) const {
  out.value(aspect);
  out.value(static_cast<std::uint64_t>(weak.size()));
  for (const Weak& one : weak) {
    out.value(one.feature);
    out.value(one.polarity);
    out.value(one.threshold);
    out.value(one.weight);
    out.value(one.least);
  }
}

WaldBoost WaldBoost::read(ByteReader& in) {
  WaldBoost boost;
  boost.aspect = in.value<double>();
  sane(boost.aspect >= 0.25 && boost.aspect <= 4.0, "the target's aspect");
  const std::size_t count = in.count(5 * sizeof(float));
  sane(count >= 1 && count <= kFeatures, "number of weak classifiers");
  boost.weak.resize(count);
  for (Weak& one : boost.weak) {
    one.feature = in.value<std::int32_t>();
    one.polarity = in.value<std::int32_t>();
    one.threshold = in.value<float>();
    one.weight = in.value<float>();
    one.least = in.value<float>();
    // OpenCV takes any of these on trust.
    sane(one.feature >= 0 && one.feature < kFeatures, "a weak classifier's feature");
    sane(one.polarity == 1 || one.polarity == -1, "a weak classifier's polarity");
    sane(std::isfinite(one.threshold) && std::isfinite(one.weight) && std::isfinite(one.least),
         "a weak classifier");
  }
  return boost;
}

Detector::Detector(const WaldBoost& boost, ImageSize size)
    : aspect_(boost.aspect), size_(size), detector_(cv::xobjdetect::WBDetector::create()) {
  const cv::FileStorage in(text_of(boost.weak), cv::FileStorage::READ | cv::FileStorage::MEMORY);
  detector_->read(in[kNode]);
}

Detector::~Detector() = default;
Detector::Detector(Detector&&) noexcept = default;

std::optional<Detection> Detector::detect(const Frame& frame) {
  check(frame.size == size_, "a detector looks at frames of its size");
  const cv::Mat rgb(size_.height, size_.width, CV_8UC3,
                    const_cast<std::uint8_t*>(frame.rgb.data()));  // only read from
  cv::cvtColor(rgb, grey_, cv::COLOR_RGB2GRAY);
  squeeze(grey_, aspect_, squeezed_);
  detector_->detect(squeezed_, boxes_, confidences_);
  const auto surest = std::ranges::max_element(confidences_);
  if (surest == confidences_.end()) return std::nullopt;
  const cv::Rect& found = boxes_[static_cast<std::size_t>(surest - confidences_.begin())];
  const double height = found.height / kMargin;
  return Detection{.box = {.x = (found.x + 0.5 * found.width) * aspect_ - 0.5,
                           .y = found.y + 0.5 * found.height - 0.5,
                           .width = aspect_ * height,
                           .height = height},
                   .confidence = *surest};
}

WaldBoost train_detector(std::span<const MarkedPicture> pictures, const Random& random) {
  WaldBoost boost;
  boost.aspect = usual_aspect(pictures);
  const TemporaryFolder folder;
  PictureFolder targets(folder.path() / "targets");
  PictureFolder backgrounds(folder.path() / "backgrounds");
  std::vector<std::size_t> order(pictures.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  Random dice = random.fork("pictures");
  for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[dice.below(i)]);
  cv::Mat1b squeezed;
  cv::Mat1b window;
  for (const std::size_t i : order) {
    const MarkedPicture& picture = pictures[i];
    squeeze(picture.grey, boost.aspect, squeezed);
    std::optional<cv::Rect2d> around;
    if (picture.target) {
      around = window_about(*picture.target, boost.aspect);
      const cv::Point2d middle(around->x + 0.5 * around->width - 0.5,
                               around->y + 0.5 * around->height - 0.5);
      cv::getRectSubPix(squeezed, cv::Size(cvRound(around->width), cvRound(around->height)), middle,
                        window);
      cv::resize(window, window, {kWindow, kWindow}, 0.0, 0.0, cv::INTER_AREA);
      targets.add(window);
    }
    add_background(squeezed, around, backgrounds);
  }
  constexpr int kFewest = 10;
  if (targets.count() < kFewest || backgrounds.count() == 0) {
    throw UsageError(
        fmt::format("the target is marked in {} of the frames looked at, and {} are wanted at "
                    "least; demonstrate with it in view",
                    targets.count(), kFewest));
  }
  const cv::Ptr<cv::xobjdetect::WBDetector> detector = cv::xobjdetect::WBDetector::create();
  {
    const Quiet quiet;
    detector->train(targets.path(), backgrounds.path());
  }
  boost.weak = weak_of(*detector);
  return boost;
}

}  // namespace pacer::baselines
