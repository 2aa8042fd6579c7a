// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#include <stdexcept>
#include <utility>

#include "core/check.h"
#include "dataset/picture_file.h"
#include "dataset/sequence.h"
#include "dataset/video.h"

namespace pacer::dataset {
namespace {

class PictureFiles final : public PictureSource {
 public:
  explicit PictureFiles(std::vector<std::filesystem::path> files) : files_(std::move(files)) {}

  [[nodiscard]] bool next(cv::Mat& picture) override {
    if (at_ == files_.size()) return false;
    read_picture(files_[at_++], picture);
    return true;
  }

 private:
  std::vector<std::filesystem::path> files_;
  std::size_t at_ = 0;
};

class Video final : public PictureSource {
 public:
  explicit Video(const std::filesystem::path& file) : decoder_(file) {}

  [[nodiscard]] bool next(cv::Mat& picture) override {
    if (!decoder_.next(frame_)) return false;
    const cv::Mat rgb(frame_.size.height, frame_.size.width, CV_8UC3, frame_.rgb.data());
    cv::cvtColor(rgb, picture, cv::COLOR_RGB2BGR);
    return true;
  }

 private:
  VideoDecoder decoder_;
  Frame frame_;
};

/// Keeps OpenCV from printing what becomes an exception here.
class QuietOpenCv {
 public:
  QuietOpenCv() : before_(cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT)) {}
  ~QuietOpenCv() { cv::utils::logging::setLogLevel(before_); }
  QuietOpenCv(const QuietOpenCv&) = delete;
  QuietOpenCv& operator=(const QuietOpenCv&) = delete;

 private:
  cv::utils::logging::LogLevel before_;
};

class Camera final : public PictureSource {
 public:
  explicit Camera(int number) {
    if (number < 0) {
      throw UsageError(fmt::format("camera {}: no such number; cameras count from 0", number));
    }
    const QuietOpenCv quiet;
    try {
      // Not whatever takes the number: other backends search USB and FireWire, and leak.
      capture_.open(number, cv::CAP_V4L2);
    } catch (const cv::Exception&) {
      capture_.release();
    }
    if (!capture_.isOpened()) {
      throw std::runtime_error(fmt::format(
          "camera {0}: cannot be opened as /dev/video{0}; connect it, end what else uses "
          "it, or see that you may read it (group video)",
          number));
    }
  }

  [[nodiscard]] bool next(cv::Mat& picture) override {
    const QuietOpenCv quiet;
    try {
      return capture_.read(picture);
    } catch (const cv::Exception&) {
      return false;  // it has gone
    }
  }

 private:
  cv::VideoCapture capture_;
};

}  // namespace

std::unique_ptr<PictureSource> read_pictures(const Sequence& sequence) {
  if (sequence.pictures.empty()) return std::make_unique<Video>(sequence.path);
  return std::make_unique<PictureFiles>(sequence.pictures);
}

std::unique_ptr<PictureSource> open_camera(int number) { return std::make_unique<Camera>(number); }

}  // namespace pacer::dataset
