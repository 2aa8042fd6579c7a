// SPDX-License-Identifier: Apache-2.0
#include "dataset/sequence_annotation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "dataset/annotation_line.h"

namespace pacer::dataset {
namespace {

constexpr double kFarthest = 1e6;  // pixels; no picture is as large

/// What a line's numbers come to: however long it is, it takes no memory.
struct Numbers {
  std::size_t count = 0;
  bool has_nan = false;
  std::array<double, 4> first{};
  // Of a polygon's x and y.
  std::array<double, 2> low{std::numeric_limits<double>::infinity(),
                            std::numeric_limits<double>::infinity()};
  std::array<double, 2> high{-low[0], -low[1]};
};

Numbers read_numbers(AnnotationLine& line) {
  Numbers read;
  while (const std::optional<double> value = line.next()) {
    if (std::isnan(*value)) {
      read.has_nan = true;
    } else if (std::abs(*value) > kFarthest) {
      line.fail(fmt::format("{} lies outside of any picture", *value));
    }
    if (read.count < read.first.size()) read.first[read.count] = *value;
    const std::size_t axis = read.count % 2;
    read.low[axis] = std::min(read.low[axis], *value);
    read.high[axis] = std::max(read.high[axis], *value);
    ++read.count;
  }
  return read;
}

/// None where the target is absent: sides of nothing, as OTB writes it, or of less.
std::optional<Box> box_of_pixels(double left, double top, double width, double height) {
  if (width <= 0.0 || height <= 0.0) return std::nullopt;
  return Box::of_pixels(left, top, width, height);
}

/// A number of a mask's: whole, and in [low, high].
std::int64_t read_whole(AnnotationLine& line, double low, double high, const char* what) {
  const std::optional<double> value = line.next();
  if (!value) line.fail(fmt::format("the mask ends before its {}", what));
  if (!(*value >= low && *value <= high) || *value != std::floor(*value)) {
    line.fail(fmt::format("the mask's {} is {}; a whole number in [{}, {}] is wanted", what, *value,
                          low, high));
  }
  return static_cast<std::int64_t>(*value);
}

/// The bounding box of a mask, which is never drawn.
std::optional<Box> read_mask(AnnotationLine& line) {
  const std::int64_t x = read_whole(line, -kFarthest, kFarthest, "x");
  const std::int64_t y = read_whole(line, -kFarthest, kFarthest, "y");
  const std::int64_t width = read_whole(line, 0.0, kFarthest, "width");
  const std::int64_t height = read_whole(line, 0.0, kFarthest, "height");
  std::int64_t left = width, top = height, right = -1, bottom = -1;  // pixels, both ends included
  std::int64_t at = 0;
  for (bool on = false; line.more(); on = !on) {
    const std::int64_t run =
        read_whole(line, 0.0, static_cast<double>(width * height - at), "run of pixels");
    if (on && run > 0) {
      const std::int64_t last = at + run - 1;
      const bool wraps = at / width != last / width;
      left = std::min(left, wraps ? 0 : at % width);
      right = std::max(right, wraps ? width - 1 : last % width);
      top = std::min(top, at / width);
      bottom = last / width;
    }
    at += run;
  }
  return box_of_pixels(static_cast<double>(x + left), static_cast<double>(y + top),
                       static_cast<double>(right - left + 1),
                       static_cast<double>(bottom - top + 1));
}

std::optional<Box> read_vot(AnnotationLine& line) {
  if (line.take('m')) return read_mask(line);
  const Numbers read = read_numbers(line);
  const auto& [x, y, width, height] = read.first;
  if (read.count == 4) {
    return read.has_nan ? std::nullopt : box_of_pixels(x, y, width, height);
  }
  if (read.count >= 6 && read.count % 2 == 0) {
    const double across = read.high[0] - read.low[0];
    const double down = read.high[1] - read.low[1];
    if (read.has_nan || across <= 0.0 || down <= 0.0) return std::nullopt;
    return Box::of_pixels(read.low[0], read.low[1], across + 1.0, down + 1.0);
  }
  if (read.count == 1 && x == 0.0) return std::nullopt;
  line.fail(fmt::format(
      "{} number{}; a rectangle is x,y,width,height, a polygon x1,y1,x2,y2,x3,y3,..., a mask "
      "mx,y,width,height,runs...; NaN,NaN,NaN,NaN where the target is absent",
      read.count, read.count == 1 ? "" : "s"));
}

std::optional<Box> read_rectangle(AnnotationLine& line, SequenceLayout layout) {
  const bool corners = layout == SequenceLayout::kTld;
  const Numbers read = read_numbers(line);
  if (read.count != 4) {
    line.fail(fmt::format("{} number{}; a box is {}, or NaN,NaN,NaN,NaN where the target is absent",
                          read.count, read.count == 1 ? "" : "s",
                          corners ? "x1,y1,x2,y2" : "x,y,width,height"));
  }
  if (read.has_nan) return std::nullopt;
  const auto& [x, y, third, fourth] = read.first;
  return corners ? box_of_pixels(x - 1.0, y - 1.0, third - x + 1.0, fourth - y + 1.0)
                 : box_of_pixels(x - 1.0, y - 1.0, third, fourth);
}

}  // namespace

std::vector<std::optional<Box>> parse_boxes(std::string_view text, SequenceLayout layout,
                                            std::string_view file) {
  std::vector<std::optional<Box>> boxes;
  for_each_line(text, file, kMostPictures, [&](AnnotationLine& line) {
    boxes.push_back(layout == SequenceLayout::kVot ? read_vot(line) : read_rectangle(line, layout));
  });
  return boxes;
}

std::vector<bool> parse_absence(std::string_view text, std::string_view file) {
  std::vector<bool> absent;
  for_each_line(text, file, kMostPictures, [&](AnnotationLine& line) {
    const std::optional<double> value = line.next();
    if ((value != 0.0 && value != 1.0) || line.more()) {
      line.fail("one number is wanted, 1 where the target is absent, else 0");
    }
    absent.push_back(value == 1.0);
  });
  return absent;
}

}  // namespace pacer::dataset
