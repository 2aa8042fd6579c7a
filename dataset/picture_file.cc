// SPDX-License-Identifier: Apache-2.0
#include "dataset/picture_file.h"

#include <fmt/format.h>

#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>

#include "dataset/files.h"
#include "dataset/picture_header.h"

namespace pacer::dataset {
namespace {

constexpr std::uintmax_t kMostBytes = 256U << 20U;
constexpr std::int64_t kMostPixels = 8192LL * 8192;

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw std::runtime_error(fmt::format(
      "{}: not a readable picture: {}; put it back as it was, or take it out", path.string(), why));
}

}  // namespace

void read_picture(const std::filesystem::path& path, cv::Mat& picture) {
  std::string bytes = read_text(path, kMostBytes);
  if (bytes.empty()) fail(path, "it is empty");
  const std::optional<PictureHeader> header = read_picture_header(bytes);
  if (!header) fail(path, "neither a JPEG, PNG, BMP nor binary PNM");
  const auto& [width, height, whole] = *header;
  if (width <= 0 || height <= 0 || width > kMostPixels / height) {
    fail(path, fmt::format("it is {} x {} pixels", width, height));
  }
  if (!whole) fail(path, "it was cut short or damaged");
  try {
    const cv::Mat encoded(1, static_cast<int>(bytes.size()), CV_8UC1, bytes.data());
    cv::imdecode(encoded, cv::IMREAD_UNCHANGED, &picture);
  } catch (const cv::Exception& error) {
    fail(path, error.err.substr(0, error.err.find('\n')));
  }
  if (picture.empty()) fail(path, "it is damaged");
  const int channels = picture.channels();
  const bool deep = picture.depth() != CV_8U && picture.depth() != CV_16U;
  if (deep || (channels != 1 && channels != 3 && channels != 4)) {
    fail(path, fmt::format("it has {} channels of {} bytes", channels, picture.elemSize1()));
  }
}

}  // namespace pacer::dataset
