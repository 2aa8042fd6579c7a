// SPDX-License-Identifier: Apache-2.0
#include "learning/baselines/detector_training.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <mutex>
#include <numeric>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/xobjdetect.hpp>
#include <string>
#include <system_error>
#include <vector>

#include "core/check.h"

namespace pacer::baselines {
namespace {

constexpr int kWindow = 24;  // pixels; OpenCV's
constexpr int kCopies = 2;   // of each target, scattered

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

/// Discards what is printed to std::cerr, and leaves it as it was. One at a time: a second waits.
class Quiet {
 public:
  Quiet() : alone_(mutex()), format_(nullptr), old_(std::cerr.rdbuf()) {
    format_.copyfmt(std::cerr);
    std::cerr.rdbuf(nullptr);
  }
  ~Quiet() {
    std::cerr.rdbuf(old_);
    std::cerr.copyfmt(format_);
  }
  Quiet(const Quiet&) = delete;
  Quiet& operator=(const Quiet&) = delete;

 private:
  static std::mutex& mutex() {
    static std::mutex mutex;
    return mutex;
  }

  std::scoped_lock<std::mutex> alone_;
  std::ios format_;
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
  const double side = kWindowMargin * std::sqrt(target.width / aspect * target.height);
  return {(target.x + 0.5) / aspect - 0.5 * side, target.y + 0.5 - 0.5 * side, side, side};
}

/// The window as a person's marks, and the places that are looked at, scatter about it: windows lie
/// on a grid of a sixth of their side, and in scales that differ by a tenth. A place counts where
/// several windows about it are accepted.
cv::Rect2d scattered(const cv::Rect2d& window, Random& dice) {
  constexpr double kShift = 0.125;  // of the side, at most
  constexpr double kScale = 0.1;    // of its logarithm, at most
  const double side = window.width * std::exp(dice.uniform(-kScale, kScale));
  const double x = window.x + 0.5 * window.width + window.width * dice.uniform(-kShift, kShift);
  const double y = window.y + 0.5 * window.height + window.height * dice.uniform(-kShift, kShift);
  return {x - 0.5 * side, y - 0.5 * side, side, side};
}

/// What `part` of `picture` shows, as a window; beyond the picture, its edge goes on.
void cut_out(const cv::Mat1b& picture, const cv::Rect2d& part, cv::Mat1b& window) {
  const int side = std::max(1, cvRound(part.width));
  const cv::Point2f middle(static_cast<float>(part.x + 0.5 * part.width - 0.5),
                           static_cast<float>(part.y + 0.5 * part.height - 0.5));
  cv::getRectSubPix(picture, {side, side}, middle, window);
  cv::resize(window, window, {kWindow, kWindow}, 0.0, 0.0,
             side > kWindow ? cv::INTER_AREA : cv::INTER_LINEAR);
}

/// Puts the rectangles of `squeezed` beside, above and below `target` that are large enough.
void add_background(const cv::Mat1b& squeezed, const cv::Rect2d& target, PictureFolder& folder) {
  const cv::Rect whole(0, 0, squeezed.cols, squeezed.rows);
  const cv::Rect around =
      cv::Rect(cv::Point(cvFloor(target.x), cvFloor(target.y)),
               cv::Point(cvCeil(target.x + target.width), cvCeil(target.y + target.height))) &
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
    aspects.push_back(picture.target.width / picture.target.height);
  }
  const auto middle = aspects.begin() + static_cast<std::ptrdiff_t>(aspects.size() / 2);
  std::ranges::nth_element(aspects, middle);
  return std::clamp(*middle, 0.25, 4.0);
}

}  // namespace

WaldBoost train_detector(std::span<const MarkedPicture> pictures, const Random& random) {
  constexpr std::size_t kFewest = 10;
  if (pictures.size() < kFewest) {
    throw UsageError(
        fmt::format("the target is marked in {} of the frames looked at, and {} are wanted at "
                    "least; demonstrate with it in view",
                    pictures.size(), kFewest));
  }
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
    const cv::Rect2d around = window_about(picture.target, boost.aspect);
    for (int copy = 0; copy < kCopies; ++copy) {
      cut_out(squeezed, scattered(around, dice), window);
      targets.add(window);
    }
    add_background(squeezed, around, backgrounds);
  }
  if (backgrounds.count() == 0) {
    throw UsageError(
        "the target leaves no room beside it in any frame looked at, so there is nothing to tell "
        "it from; demonstrate from further away");
  }
  const cv::Ptr<cv::xobjdetect::WBDetector> detector = cv::xobjdetect::WBDetector::create();
  {
    const Quiet quiet;
    detector->train(targets.path(), backgrounds.path());
  }
  boost.weak = weak_of(*detector);
  // A pattern that tells all pictures apart has a weight without end.
  constexpr float kMost = 1e6F;
  for (WaldBoost::Weak& one : boost.weak) {
    if (std::isnan(one.weight) || std::isnan(one.least)) {
      throw UsageError("the marked pictures are too alike to learn a detector from; record more");
    }
    one.weight = std::clamp(one.weight, -kMost, kMost);
    one.least = std::clamp(one.least, -kMost, 0.5F * kMost);  // a window passes above it only
  }
  return boost;
}

}  // namespace pacer::baselines
