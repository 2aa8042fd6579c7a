// SPDX-License-Identifier: Apache-2.0
#include "runs/report/picture.h"

#include <algorithm>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "runs/report/canvas.h"

namespace pacer::report {
namespace {

std::vector<std::uint8_t> encoded(const Frame& frame, const char* kind,
                                  const std::vector<int>& options) {
  cv::Mat bgr;
  cv::cvtColor(canvas::view(frame), bgr, cv::COLOR_RGB2BGR);
  std::vector<std::uint8_t> bytes;
  check(cv::imencode(kind, bgr, bytes, options), "OpenCV encodes PNG and JPEG");
  return bytes;
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Frame& frame) {
  return encoded(frame, ".png", {cv::IMWRITE_PNG_COMPRESSION, 6});
}

std::vector<std::uint8_t> encode_jpeg(const Frame& frame, int quality) {
  require(quality >= 1 && quality <= 100, "quality: must be 1 to 100");
  return encoded(frame, ".jpg", {cv::IMWRITE_JPEG_QUALITY, quality});
}

Frame contact_sheet(std::span<const Tiled> pictures, int columns, ImageSize tile) {
  constexpr int kGap = 8;
  constexpr int kCaption = 26;
  require(!pictures.empty() && pictures.size() <= 10'000,
          "contact_sheet: want 1 to 10,000 pictures");
  require(columns > 0 && columns <= 100, "contact_sheet: columns must be 1 to 100");
  require(tile.width > 0 && tile.height > 0 && tile.width <= 4096 && tile.height <= 4096,
          "contact_sheet: tile sides must be 1 to 4096 pixels");
  const int count = static_cast<int>(pictures.size());
  columns = std::min(columns, count);
  const int rows = (count + columns - 1) / columns;
  const bool captions = std::any_of(pictures.begin(), pictures.end(),
                                    [](const Tiled& one) { return !one.caption.empty(); });
  const int pitch_x = tile.width + kGap;
  const int pitch_y = tile.height + (captions ? kCaption : 0) + kGap;

  Frame sheet;
  cv::Mat paper = canvas::resized(sheet, {columns * pitch_x + kGap, rows * pitch_y + kGap});
  paper.setTo(canvas::kBackground);
  for (int i = 0; i < count; ++i) {
    const Tiled& one = pictures[static_cast<std::size_t>(i)];
    const cv::Point corner(kGap + i % columns * pitch_x, kGap + i / columns * pitch_y);
    const cv::Mat picture = canvas::view(one.frame);
    const double scale = std::min(static_cast<double>(tile.width) / picture.cols,
                                  static_cast<double>(tile.height) / picture.rows);
    const cv::Size size(std::max(1, static_cast<int>(picture.cols * scale)),
                        std::max(1, static_cast<int>(picture.rows * scale)));
    const cv::Point inset((tile.width - size.width) / 2, (tile.height - size.height) / 2);
    cv::Mat place = paper(cv::Rect(corner + inset, size));
    cv::resize(picture, place, size, 0, 0, scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
    canvas::text(paper, one.caption, {corner.x + 2, corner.y + tile.height + 18},
                 {.height_px = 11, .most_width_px = tile.width - 4});
  }
  return sheet;
}

}  // namespace pacer::report
