// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <cmath>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/sequence.h"
#include "dataset/sequence_annotation.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;

constexpr int kQuality = 95;           // JPEG's
constexpr int kLongestSide = 8192;     // pixels: what can be read again
constexpr double kFarthest = 1e6 - 2;  // pixels; likewise

bool is_within(const Box& box) {
  return is_proper(box) && std::abs(box.left()) < kFarthest && std::abs(box.top()) < kFarthest &&
         box.width < kFarthest && box.height < kFarthest;
}

}  // namespace

struct SequenceWriter::Impl {
  fs::path folder;
  bool made = false;  // the folder is ours
  ImageSize size;
  std::size_t count = 0;
  std::string annotation;
  bool closed = false;
  cv::Mat bgr;
  std::vector<std::uint8_t> encoded;

  [[nodiscard]] fs::path pictures() const { return folder / "img"; }
  [[nodiscard]] fs::path unfinished() const { return folder / ".groundtruth_rect.part"; }
  [[nodiscard]] fs::path picture(std::size_t number) const {
    return pictures() / fmt::format("{:04d}.jpg", number);
  }
};

SequenceWriter::SequenceWriter(fs::path folder) : impl_(std::make_unique<Impl>()) {
  Impl& my = *impl_;
  my.folder = std::move(folder);
  std::error_code error;
  my.made = !fs::exists(my.folder, error);
  if (!my.made && !(fs::is_directory(my.folder, error) && fs::is_empty(my.folder, error))) {
    throw UsageError(fmt::format("{}: is there and not empty; name a new folder, or remove it",
                                 my.folder.string()));
  }
  make_folder(my.pictures());
}

SequenceWriter::~SequenceWriter() {
  Impl& my = *impl_;
  if (my.closed) return;
  std::error_code ignored;
  // One more than was counted, in case its writing failed.
  for (std::size_t i = 1; i <= my.count + 1; ++i) fs::remove(my.picture(i), ignored);
  fs::remove(my.pictures(), ignored);
  fs::remove(my.unfinished(), ignored);
  if (my.made) fs::remove(my.folder, ignored);
}

void SequenceWriter::write(const Frame& frame, const std::optional<Box>& truth) {
  Impl& my = *impl_;
  const auto [width, height] = frame.size;
  require(!my.closed, "SequenceWriter: closed");
  require(my.count < kMostPictures, "SequenceWriter: too many frames");
  require(width >= 1 && height >= 1 && width <= kLongestSide && height <= kLongestSide &&
              frame.rgb.size() ==
                  static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3U,
          fmt::format("frame.size: {} x {} pixels with {} bytes", width, height, frame.rgb.size()));
  require(my.count == 0 || frame.size == my.size,
          fmt::format("frame.size: {} x {} pixels after {} x {}", width, height, my.size.width,
                      my.size.height));
  require(!truth || is_within(*truth), "truth: must be proper, and within 1e6 pixels");
  my.size = frame.size;

  // The matrix is only read.
  const cv::Mat rgb(height, width, CV_8UC3, const_cast<std::uint8_t*>(frame.rgb.data()));
  cv::cvtColor(rgb, my.bgr, cv::COLOR_RGB2BGR);
  cv::imencode(".jpg", my.bgr, my.encoded, {cv::IMWRITE_JPEG_QUALITY, kQuality});
  write_text(my.picture(my.count + 1),
             {reinterpret_cast<const char*>(my.encoded.data()), my.encoded.size()});
  my.annotation += truth ? fmt::format("{:.4f},{:.4f},{:.4f},{:.4f}\n", truth->left() + 1.0,
                                       truth->top() + 1.0, truth->width, truth->height)
                         : "NaN,NaN,NaN,NaN\n";
  ++my.count;
}

void SequenceWriter::close() {
  Impl& my = *impl_;
  if (my.closed) return;
  require(my.count > 0, "SequenceWriter: closed without a frame");
  sync(my.pictures());
  replace_text(my.folder / "groundtruth_rect.txt", my.unfinished(), my.annotation);
  my.closed = true;
  sync(my.folder);
}

}  // namespace pacer::dataset
