// SPDX-License-Identifier: Apache-2.0
#include "runs/tracking/tracking_view.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/check.h"
#include "runs/report/canvas.h"
#include "runs/report/marker.h"

namespace pacer {
namespace {

namespace canvas = report::canvas;

constexpr int kCaption = 26;  // height of the line of text
constexpr int kRow = 20;      // of a row of the legend
constexpr int kPatches = 84;
constexpr int kMargin = 8;
constexpr int kNarrowest = 64;
constexpr int kSwatch = 22;
constexpr double kLetters = 10.0;

/// Pixels that a name of the legend takes, swatch included.
int width_of(const std::string& name) {
  constexpr int kPerCharacter = 10;
  return kSwatch + 6 + kPerCharacter * static_cast<int>(std::min<std::size_t>(name.size(), 40)) +
         16;
}

}  // namespace

BoxStyle truth_style() { return {.name = "truth", .colour = "#F5F7FA", .dashed = true}; }

TrackingView::TrackingView(ImageSize picture, std::vector<BoxStyle> styles, const Layout& layout)
    : styles_(std::move(styles)), layout_(layout) {
  require(picture.width > 0 && picture.height > 0, "view: a picture without pixels");
  for (const BoxStyle& style : styles_) (void)report::colour_of(style.colour);
  const auto scaled = [&](int side) {
    return std::max(1, static_cast<int>(std::lround(side * layout.scale)));
  };
  picture_ = {scaled(picture.width), scaled(picture.height)};
  if (layout_.legend) {
    int room = 0;
    for (const BoxStyle& style : styles_) {
      const int width = width_of(style.name);
      if (width > room) {
        rows_.push_back(0);
        room = picture_.width - 2 * kMargin;
      }
      ++rows_.back();
      room -= width;
    }
  }
  const auto even = [](int side) { return side + side % 2; };
  const int head = kCaption + kRow * static_cast<int>(rows_.size());
  size_ = {even(std::max(picture_.width, kNarrowest)),
           even(head + picture_.height + (layout_.patches ? kPatches : 0))};
}

double TrackingView::magnification(ImageSize picture) {
  constexpr int kWanted = 480;  // pixels across
  constexpr double kMost = 1920.0;
  const int larger = std::max({1, picture.width, picture.height});
  return std::min<double>(std::clamp((kWanted + larger - 1) / larger, 1, 8), kMost / larger);
}

void TrackingView::draw_head(cv::Mat head, const std::string& caption) const {
  canvas::text(head, caption, {kMargin, 18},
               {.height_px = 11, .most_width_px = head.cols - 2 * kMargin});
  std::size_t next = 0;
  int y = kCaption;
  for (const std::size_t count : rows_) {
    int x = kMargin;
    for (std::size_t i = 0; i < count; ++i, ++next) {
      const BoxStyle& style = styles_[next];
      const cv::Scalar colour = report::colour_of(style.colour);
      const int middle = y + kRow / 2 - 2;
      for (int from = 0; from < kSwatch; from += style.dashed ? 8 : kSwatch) {
        const int to = std::min(kSwatch, from + (style.dashed ? 5 : kSwatch));
        cv::line(head, {x + from, middle}, {x + to, middle}, colour, 3);
      }
      canvas::text(head, style.name, {x + kSwatch + 6, middle + 5},
                   {.height_px = kLetters, .most_width_px = width_of(style.name)});
      x += width_of(style.name);
    }
    y += kRow;
  }
}

void TrackingView::draw(const cv::Mat& bgr, const std::string& caption,
                        std::span<const std::optional<Box>> boxes, const Annotations& marks,
                        Frame& into) const {
  require(boxes.size() <= styles_.size(), "view: more boxes than styles");
  cv::Mat whole = canvas::resized(into, size_);
  whole.setTo(canvas::kBackground);
  const int head = kCaption + kRow * static_cast<int>(rows_.size());
  draw_head(whole.rowRange(0, head), caption);

  cv::Mat picture = whole(cv::Rect(0, head, picture_.width, picture_.height));
  cv::Mat shown;
  cv::resize(bgr, shown, picture.size(), 0, 0,
             layout_.scale < 1.0 ? cv::INTER_AREA : cv::INTER_CUBIC);
  cv::cvtColor(shown, picture, cv::COLOR_BGR2RGB);
  report::Marker marker(picture, layout_.scale);
  marker.marks(marks);
  for (std::size_t i = boxes.size(); i-- > 0;) {  // the first, the truth, on top
    if (boxes[i]) {
      marker.outline(*boxes[i], report::colour_of(styles_[i].colour), styles_[i].dashed);
    }
  }
  canvas::text(picture, marks.label, {kMargin, picture.rows - 10},
               {.height_px = 11, .most_width_px = picture.cols - 2 * kMargin, .outlined = true});
  if (layout_.patches) {
    const int below = head + picture_.height;
    report::draw_patches(marks.patches, whole.rowRange(below, below + kPatches));
  }
}

}  // namespace pacer
