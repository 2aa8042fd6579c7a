// SPDX-License-Identifier: Apache-2.0
#include "runs/report/draw.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <stdexcept>

#include "runs/report/picture.h"

namespace pacer::report {
namespace {

using Rgb = std::array<int, 3>;

Frame grey(ImageSize size, std::uint8_t level = 128) {
  return {
      .size = size,
      .rgb = std::vector<std::uint8_t>(
          static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 3, level)};
}

Rgb pixel(const Frame& frame, int x, int y) {
  const std::size_t at =
      3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(frame.size.width) +
           static_cast<std::size_t>(x));
  return {frame.rgb[at], frame.rgb[at + 1], frame.rgb[at + 2]};
}

bool is_green(const Rgb& rgb) { return rgb[1] > rgb[0] + 60 && rgb[1] > rgb[2] + 40; }
bool is_blue(const Rgb& rgb) { return rgb[2] > rgb[0] + 60; }

TEST(Draw, MagnifiesTheFrame) {
  Frame frame = grey({20, 10});
  frame.index = 7;
  Frame picture;
  draw(frame, Annotations{}, picture, 3);
  EXPECT_EQ(picture.size, (ImageSize{60, 30}));
  EXPECT_EQ(picture.rgb.size(), 60U * 30U * 3U);
  EXPECT_EQ(picture.index, 7U);
  EXPECT_EQ(pixel(picture, 30, 15), (Rgb{128, 128, 128}));
}

TEST(Draw, MarksStandWhereTheirPixelsAre) {
  Annotations annotations;
  annotations.points.push_back({.at = {10.0F, 5.0F}, .radius = 0.5F, .tone = Tone::kMatched});
  Frame picture;
  draw(grey({40, 40}), annotations, picture, 4);
  EXPECT_TRUE(is_green(pixel(picture, 42, 22)));  // the middle of 4 x 4 pixels from (40, 20)
  EXPECT_EQ(pixel(picture, 60, 22), (Rgb{128, 128, 128}));
}

TEST(Draw, MarksReadOnBlackAndOnWhite) {
  for (const int level : {0, 255}) {
    Annotations annotations;
    annotations.boxes.push_back({.low = {5, 5}, .high = {30, 30}, .tone = Tone::kNeutral});
    Frame picture;
    draw(grey({40, 40}, static_cast<std::uint8_t>(level)), annotations, picture);
    int different = 0;
    for (const std::uint8_t value : picture.rgb) different += std::abs(value - level) > 90 ? 1 : 0;
    EXPECT_GT(different, 150) << "on " << level;
  }
}

TEST(Draw, SurvivesMarksFromAnywhere) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  Annotations annotations;
  for (const float wild : {kNan, kInfinity, -kInfinity, 3e38F, -1e9F, 2e4F}) {
    annotations.points.push_back({.at = {wild, 5}, .radius = 2});
    annotations.points.push_back({.at = {5, 5}, .radius = wild});
    annotations.lines.push_back({.from = {1, wild}, .to = {5, 5}});
    annotations.boxes.push_back({.low = {wild, 0}, .high = {9, wild}});
  }
  annotations.label = "label \xFF\xFE \xE2\x82\xAC\n" + std::string(5000, 'x');
  Frame picture;
  draw(grey({32, 24}), annotations, Hud{.sent = {kNan, 1e300}}, picture);
  EXPECT_EQ(picture.size, drawn_size({32, 24}));
}

TEST(Draw, RejectsAFrameWhoseBytesDoNotFitItsSize) {
  Frame frame = grey({8, 8});
  frame.rgb.pop_back();
  Frame picture;
  EXPECT_THROW(draw(frame, Annotations{}, picture), std::invalid_argument);
  EXPECT_THROW((void)encode_png(frame), std::invalid_argument);
  EXPECT_THROW(draw(grey({8, 8}), Annotations{}, picture, 0), std::invalid_argument);
}

TEST(Draw, VideoPicturesHaveEvenSides) {
  const ImageSize size = drawn_size({161, 121}, 1);
  EXPECT_EQ(size.width % 2, 0);
  EXPECT_EQ(size.height % 2, 0);
  Frame picture;
  draw(grey({161, 121}), Annotations{}, Hud{}, picture, 1);
  EXPECT_EQ(picture.size, size);
}

TEST(Draw, SteeringLeftFillsTheLeftHalf) {
  const auto blue_of_half = [](double steering, bool left) {
    Frame picture;
    draw(grey({320, 240}), Annotations{}, Hud{.sent = {steering, 0.0}}, picture);
    const int middle = (picture.size.width * 36 / 100 + 10 + picture.size.width * 66 / 100) / 2;
    int count = 0;
    for (int x = middle - 90; x < middle + 90; ++x) {
      if ((x < middle) == left && is_blue(pixel(picture, x, 34))) ++count;
    }
    return count;
  };
  EXPECT_GT(blue_of_half(1.0, true), 80);
  EXPECT_LT(blue_of_half(1.0, false), 5);
  EXPECT_GT(blue_of_half(-1.0, false), 80);
}

TEST(ContactSheet, SetsPicturesInRows) {
  const std::vector<Tiled> pictures(5, {.frame = grey({64, 48}, 200), .caption = "one"});
  const Frame sheet = contact_sheet(pictures, 3, {64, 48});
  EXPECT_EQ(sheet.size.width, 3 * 72 + 8);
  EXPECT_EQ(sheet.size.height, 2 * (48 + 26 + 8) + 8);
  EXPECT_EQ(pixel(sheet, 8 + 32, 8 + 24), (Rgb{200, 200, 200}));
}

TEST(ContactSheet, FitsPicturesOfAnyShape) {
  const std::vector<Tiled> pictures = {{.frame = grey({300, 10})}, {.frame = grey({1, 200})}};
  EXPECT_EQ(contact_sheet(pictures, 2, {64, 48}).size.height, 48 + 2 * 8);
}

TEST(ContactSheet, RejectsNoPictures) {
  EXPECT_THROW((void)contact_sheet({}, 3), std::invalid_argument);
}

TEST(EncodePng, GivesTheSameBytesEachTime) {
  EXPECT_EQ(encode_png(grey({30, 20})), encode_png(grey({30, 20})));
}

}  // namespace
}  // namespace pacer::report
