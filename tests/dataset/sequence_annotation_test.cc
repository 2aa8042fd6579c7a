// SPDX-License-Identifier: Apache-2.0
#include "dataset/sequence_annotation.h"

#include <gmock/gmock.h>

#include <cmath>

#include "core/random.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

using testing::complaint;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using enum SequenceLayout;

using Boxes = std::vector<std::optional<Box>>;

std::optional<Box> one(const std::string& line, SequenceLayout layout) {
  const Boxes boxes = parse_boxes(line, layout, "truth.txt");
  EXPECT_EQ(boxes.size(), 1U) << line;
  return boxes.at(0);
}

std::string complaint_about(const std::string& text, SequenceLayout layout = kOtb) {
  return complaint([&] { static_cast<void>(parse_boxes(text, layout, "truth.txt")); });
}

TEST(SequenceAnnotation, OtbAndGot10kCountPixelsFromOne) {
  EXPECT_EQ(one("1,1,24,16", kOtb), Box::of_pixels(0, 0, 24, 16));
  EXPECT_EQ(one("1,1,24,16", kGot10k), Box::of_pixels(0, 0, 24, 16));
}

TEST(SequenceAnnotation, VotCountsPixelsFromZero) {
  EXPECT_EQ(one("0,0,24,16", kVot), Box::of_pixels(0, 0, 24, 16));
}

TEST(SequenceAnnotation, TldNamesTheFirstAndTheLastPixel) {
  EXPECT_EQ(one("1,1,24,16", kTld), Box::of_pixels(0, 0, 24, 16));
  EXPECT_EQ(one("5,6,5,6", kTld), Box::of_pixels(4, 5, 1, 1));
}

TEST(SequenceAnnotation, CommasTabsAndBlanksMayBeMixed) {
  const Boxes boxes =
      parse_boxes("3,4,10,20\n3\t4\t10\t20\n3 4  10 20\n 3, 4,\t10 ,20\t\n", kOtb, "truth.txt");
  ASSERT_EQ(boxes.size(), 4U);
  for (const auto& box : boxes) EXPECT_EQ(box, Box::of_pixels(2, 3, 10, 20));
}

TEST(SequenceAnnotation, LineEndsOfAnySystemAndEmptyLinesAtTheEndArePassedOver) {
  EXPECT_EQ(parse_boxes("\xEF\xBB\xBF"
                        "3,4,10,20\r\n3,4,10,20\r\n\r\n\n  \n",
                        kOtb, "t")
                .size(),
            2U);
  EXPECT_EQ(parse_boxes("3,4,10,20\n3,4,10,20", kOtb, "t").size(), 2U);
  EXPECT_TRUE(parse_boxes("\n\n", kOtb, "t").empty());
}

TEST(SequenceAnnotation, BoxesMayLeaveTheImageAndLieBetweenPixels) {
  EXPECT_EQ(one("-10.5,-3,32.25,35", kOtb), Box::of_pixels(-11.5, -4, 32.25, 35));
  EXPECT_EQ(one("1e2,1,2,3", kOtb), Box::of_pixels(99, 0, 2, 3));
}

TEST(SequenceAnnotation, NanAndSidesOfNothingMeanAbsent) {
  for (const auto& line : {"NaN,NaN,NaN,NaN", "nan nan nan nan", "1,2,nan,4", "0,0,0,0", "5,5,0,7",
                           "5,5,7,0", "-1,-1,-1,-1"}) {
    for (const auto layout : {kOtb, kGot10k, kVot}) EXPECT_EQ(one(line, layout), std::nullopt);
  }
  EXPECT_EQ(one("NaN,NaN,NaN,NaN", kTld), std::nullopt);
  EXPECT_EQ(one("5,5,4,9", kTld), std::nullopt);
}

TEST(SequenceAnnotation, OfAPolygonTheUprightBoxIsTaken) {
  EXPECT_EQ(one("5,1,9,4,6,8,2,5", kVot), Box::of_pixels(2, 1, 8, 8));
  EXPECT_EQ(one("5.5,1.25,9.5,4,6,8.25,2,5", kVot)->x, 5.75) << "the middle of its corners";
  EXPECT_EQ(one("0,0,4,0,0,6", kVot), Box::of_pixels(0, 0, 5, 7)) << "three corners";
  EXPECT_EQ(one("nan,0,4,0,0,6,0,0", kVot), std::nullopt);
  EXPECT_EQ(one("3,3,3,3,3,3,3,3", kVot), std::nullopt);
}

TEST(SequenceAnnotation, VotsZeroIsAFrameThatNobodyAnnotated) {
  EXPECT_EQ(one("0", kVot), std::nullopt);
  EXPECT_THAT(complaint_about("1", kVot), HasSubstr("1 number;"));
}

TEST(SequenceAnnotation, OfAMaskTheBoxOfItsPixelsIsTaken) {
  // Two pixels off, one on in a window of 4 x 3 at (10, 20).
  EXPECT_EQ(one("m10,20,4,3,2,1", kVot), Box::of_pixels(12, 20, 1, 1));
  EXPECT_EQ(one("m10,20,4,3,0,12", kVot), Box::of_pixels(10, 20, 4, 3)) << "all of it";
  EXPECT_EQ(one("m 10, 20, 4, 3, 5, 2, 2, 2, 1", kVot), Box::of_pixels(11, 21, 2, 2));
  EXPECT_EQ(one("m10,20,4,3,3,2", kVot), Box::of_pixels(10, 20, 4, 2)) << "a run over a row's end";
  EXPECT_EQ(one("m10,20,4,3,12", kVot), std::nullopt);
  EXPECT_EQ(one("m0,0,0,0,0", kVot), std::nullopt);
}

// The bounding box of a mask that is drawn, to hold the one that is not against.
TEST(SequenceAnnotation, AMasksBoxIsThatOfTheMaskDrawn) {
  const Random random(3);
  for (std::uint64_t trial = 0; trial < 500; ++trial) {
    Random dice = random.fork("mask", trial);
    const auto width = 1 + static_cast<int>(dice.below(9));
    const auto height = 1 + static_cast<int>(dice.below(9));
    cv::Mat1b drawn(height, width, std::uint8_t{0});
    std::string line = fmt::format("m-3,7,{},{}", width, height);
    int at = 0;
    for (bool on = false; at < width * height; on = !on) {
      const int run = std::min(static_cast<int>(dice.below(12)), width * height - at);
      for (int i = at; on && i < at + run; ++i) drawn(i / width, i % width) = 1;
      at += run;
      line += fmt::format(",{}", run);
    }
    int left = width, top = height, right = -1, bottom = -1;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        if (drawn(y, x) == 0) continue;
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
      }
    }
    const auto expected =
        right < 0
            ? std::nullopt
            : std::optional(Box::of_pixels(left - 3, top + 7, right - left + 1, bottom - top + 1));
    EXPECT_EQ(one(line, kVot), expected) << line;
  }
}

TEST(SequenceAnnotation, AMaskThatDoesNotFitItsWindowIsRefused) {
  EXPECT_THAT(complaint_about("m0,0,4,3,2,11", kVot), HasSubstr("run of pixels is 11"));
  EXPECT_THAT(complaint_about("m0,0,4", kVot), HasSubstr("ends before its height"));
  EXPECT_THAT(complaint_about("m0,0,4,1e9,3", kVot), HasSubstr("height"));
  EXPECT_THAT(complaint_about("m0,0,4,3,1.5", kVot), HasSubstr("whole number"));
  EXPECT_THAT(complaint_about("m0,0,4,3,-1", kVot), HasSubstr("whole number"));
  EXPECT_THAT(complaint_about("m0,0,4,nan", kVot), HasSubstr("whole number"));
}

TEST(SequenceAnnotation, TheFileAndTheLineAreNamed) {
  EXPECT_THAT(complaint_about("1,2,3,4\n1,2,3\n"), StartsWith("truth.txt:2: 3 numbers;"));
  EXPECT_THAT(complaint_about("1,2,3,4,5"), StartsWith("truth.txt:1: 5 numbers;"));
  EXPECT_THAT(complaint_about("1,2,3,4\n\n1,2,3,4"), StartsWith("truth.txt:2: is empty;"));
  EXPECT_THAT(complaint_about("1,2,3,4\n1,2,x3,4"), StartsWith("truth.txt:2: 'x3' is no number"));
  EXPECT_THAT(complaint_about("1,2,3px,4"), HasSubstr("'3px' is no number"));
  EXPECT_THAT(complaint_about("1,,3,4"), HasSubstr("comma with no number"));
  EXPECT_THAT(complaint_about(",1,2,3,4"), HasSubstr("comma with no number"));
  EXPECT_THAT(complaint_about("1,2,3,4,"), HasSubstr("ends with a comma"));
  EXPECT_THAT(complaint_about("1,2,3,4,5", kVot), HasSubstr("5 numbers;"));
  EXPECT_THAT(complaint_about("1,2,3", kTld), HasSubstr("x1,y1,x2,y2"));
}

TEST(SequenceAnnotation, NumbersThatNoPictureHasAreRefused) {
  for (const auto& line : {"inf,2,3,4", "1,-inf,3,4", "1,2,1e999,4", "1,2,3,1e7", "-2e6,2,3,4"}) {
    EXPECT_THAT(complaint_about(line), HasSubstr("outside of any picture")) << line;
  }
}

TEST(SequenceAnnotation, MoreLinesThanAnySequenceHasPicturesAreRefused) {
  std::string text;
  for (std::size_t i = 0; i <= kMostPictures; ++i) text += "0\n";
  EXPECT_THAT(complaint_about(text, kVot), StartsWith("truth.txt:1000001: one line too many"));
  text.resize(2 * kMostPictures);
  EXPECT_EQ(complaint_about(text, kVot), "");
}

TEST(SequenceAnnotation, WhatIsNoTextIsShownSafely) {
  EXPECT_THAT(complaint_about(std::string("1,2,\0\x1b[2J,4", 10)),
              HasSubstr("'??[2J' is no number"));
  EXPECT_THAT(complaint_about(std::string(1000, 'x')), HasSubstr("'xxxxxxxxxxxxxxxx' is no"));
}

TEST(SequenceAnnotation, AnAbsenceLabelIsZeroOrOne) {
  EXPECT_THAT(parse_absence("0\r\n1\n0\n", "a"), ElementsAre(false, true, false));
  for (const auto& text : {"0\n2\n", "0\nNaN", "0\n1 1", "0\nyes"}) {
    EXPECT_THAT(complaint([&] { static_cast<void>(parse_absence(text, "absence.label")); }),
                StartsWith("absence.label:2: "));
  }
}

}  // namespace
}  // namespace pacer::dataset
