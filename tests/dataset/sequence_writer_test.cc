// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/check.h"
#include "dataset/files.h"
#include "dataset/sequence.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using testing::complaint;
using ::testing::HasSubstr;
using testing::Scratch;
using ::testing::SizeIs;
using testing::write_file;

/// A square of one colour runs over a ramp.
Frame made_up_frame(int index) {
  Frame frame{
      .index = static_cast<std::uint64_t>(index), .size = {.width = 64, .height = 48}, .rgb = {}};
  for (int y = 0; y < 48; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool inside = std::abs(x - 10 - 3 * index) < 6 && std::abs(y - 24) < 6;
      frame.rgb.push_back(inside ? 220 : static_cast<std::uint8_t>(2 * x));
      frame.rgb.push_back(inside ? 60 : static_cast<std::uint8_t>(2 * y));
      frame.rgb.push_back(80);
    }
  }
  return frame;
}

std::vector<std::optional<Box>> made_up_truth() {
  return {Box::of_pixels(0, 0, 11, 11), Box{.x = 13.123, .y = 24.5, .width = 0.75, .height = 11},
          std::nullopt, Box{.x = -4.5, .y = 60.25, .width = 1.0 / 3.0, .height = 100.0 / 7.0}};
}

void write_sequence(const fs::path& folder) {
  SequenceWriter writer(folder);
  int index = 0;
  for (const auto& box : made_up_truth()) writer.write(made_up_frame(index++), box);
  writer.close();
}

TEST(SequenceWriter, WhatItWritesIsReadBack) {
  const Scratch scratch;
  write_sequence(scratch / "Made");
  const Sequence sequence = Sequence::open(scratch / "Made");
  EXPECT_EQ(sequence.layout, SequenceLayout::kOtb);
  EXPECT_EQ(sequence.pictures.at(0), scratch / "Made/img/0001.jpg");
  ASSERT_THAT(sequence.targets, SizeIs(1));
  const auto truth = made_up_truth();
  ASSERT_THAT(sequence.targets[0].boxes, SizeIs(truth.size()));
  const auto source = read_pictures(sequence);
  cv::Mat picture;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const auto& box = sequence.targets[0].boxes[i];
    ASSERT_EQ(box.has_value(), truth[i].has_value());
    if (box) {
      EXPECT_NEAR(box->x, truth[i]->x, 1e-4);
      EXPECT_NEAR(box->y, truth[i]->y, 1e-4);
      EXPECT_NEAR(box->width, truth[i]->width, 1e-4);
      EXPECT_NEAR(box->height, truth[i]->height, 1e-4);
    }
    ASSERT_TRUE(source->next(picture));
    Frame sent = made_up_frame(static_cast<int>(i));
    double distance = 0.0;
    for (int y = 0; y < 48; ++y) {
      for (int x = 0; x < 64; ++x) {
        for (int c = 0; c < 3; ++c) {
          distance += std::abs(picture.at<cv::Vec3b>(y, x)[2 - c] -
                               sent.rgb[static_cast<std::size_t>((y * 64 + x) * 3 + c)]);
        }
      }
    }
    EXPECT_LT(distance / (64 * 48 * 3), 4.0);
  }
  EXPECT_FALSE(source->next(picture));
}

TEST(SequenceWriter, TheSameFramesGiveTheSameBytes) {
  const Scratch scratch;
  write_sequence(scratch / "one");
  write_sequence(scratch / "other");
  for (const char* file : {"groundtruth_rect.txt", "img/0001.jpg", "img/0004.jpg"}) {
    EXPECT_EQ(read_text(scratch / "one" / file), read_text(scratch / "other" / file));
  }
}

TEST(SequenceWriter, WritesOtbsLayout) {
  const Scratch scratch;
  write_sequence(scratch / "Made");
  EXPECT_THAT(read_text(scratch / "Made/groundtruth_rect.txt"),
              ::testing::StartsWith("1.0000,1.0000,11.0000,11.0000\n"));
  EXPECT_THAT(read_text(scratch / "Made/groundtruth_rect.txt"), HasSubstr("\nNaN,NaN,NaN,NaN\n"));
  std::size_t files = 0;
  for (const auto& each : fs::recursive_directory_iterator(scratch / "Made")) {
    files += each.is_regular_file() ? 1 : 0;
  }
  EXPECT_EQ(files, 5U) << "and nothing else";
}

TEST(SequenceWriter, HalfASequenceHasNoTruth) {
  const Scratch scratch;
  {
    SequenceWriter writer(scratch / "a/Made");
    writer.write(made_up_frame(0), std::nullopt);
    EXPECT_THAT(Sequence::open(scratch / "a/Made").targets, ::testing::IsEmpty());
    EXPECT_THROW(static_cast<void>(find_sequences(scratch / "a")), UsageError);
  }
  EXPECT_FALSE(fs::exists(scratch / "a/Made")) << "and leaves nothing behind";
  fs::create_directories(scratch / "b");
  { const SequenceWriter writer(scratch / "b"); }
  EXPECT_TRUE(fs::is_empty(scratch / "b")) << "the folder was not its own";
}

TEST(SequenceWriter, NeverMixesWithWhatIsThere) {
  const Scratch scratch;
  write_sequence(scratch / "Made");
  EXPECT_THAT(complaint([&] { SequenceWriter(scratch / "Made"); }), HasSubstr("not empty"));
  write_file(scratch / "file", "");
  EXPECT_THAT(complaint([&] { SequenceWriter(scratch / "file"); }), HasSubstr("not empty"));
  EXPECT_THAT(complaint([&] { SequenceWriter("/proc/nowhere/at/all"); }),
              HasSubstr("/proc/nowhere"));
}

TEST(SequenceWriter, RefusesWhatCouldNotBeReadBack) {
  const Scratch scratch;
  SequenceWriter writer(scratch / "Made");
  EXPECT_THROW(writer.close(), std::invalid_argument);
  EXPECT_THROW(writer.write(Frame{}, std::nullopt), std::invalid_argument);
  Frame frame = made_up_frame(0);
  frame.rgb.pop_back();
  EXPECT_THROW(writer.write(frame, std::nullopt), std::invalid_argument);
  for (const Box& box : {Box{.x = 1, .y = 1, .width = 0, .height = 1},
                         Box{.x = 2e6, .y = 1, .width = 1, .height = 1},
                         Box{.x = 1, .y = std::nan(""), .width = 1, .height = 1}}) {
    EXPECT_THROW(writer.write(made_up_frame(0), box), std::invalid_argument);
  }
  writer.write(made_up_frame(0), std::nullopt);
  frame = made_up_frame(1);
  frame.size = {.width = 48, .height = 64};
  EXPECT_THROW(writer.write(frame, std::nullopt), std::invalid_argument);
  writer.close();
  writer.close();
  EXPECT_THROW(writer.write(made_up_frame(0), std::nullopt), std::invalid_argument);
  EXPECT_THAT(Sequence::open(scratch / "Made").pictures, SizeIs(1))
      << "what was refused is not there";
}

}  // namespace
}  // namespace pacer::dataset
