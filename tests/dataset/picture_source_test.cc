// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "core/check.h"
#include "dataset/picture_header.h"
#include "dataset/sequence.h"
#include "dataset/video.h"
#include "tests/dataset/made_up_sequence.h"

namespace pacer::dataset {
namespace {

namespace fs = std::filesystem;
using ::testing::AllOf;
using testing::complaint;
using testing::encoded_picture;
using ::testing::HasSubstr;
using testing::Scratch;
using ::testing::StartsWith;
using testing::write_file;

constexpr const char* kExtensions[] = {".jpg", ".png", ".bmp", ".ppm", ".pgm"};

int type_for(const std::string& extension) { return extension == ".pgm" ? CV_8UC1 : CV_8UC3; }

/// Reads one picture, as a sequence of one.
cv::Mat read_one(const fs::path& file) {
  Sequence sequence;
  sequence.pictures = {file};
  cv::Mat picture;
  EXPECT_TRUE(read_pictures(sequence)->next(picture));
  return picture;
}

std::string complaint_about(const fs::path& file) {
  return complaint([&] { static_cast<void>(read_one(file)); });
}

TEST(PictureSource, ReadsEveryPictureOnceAndInOrder) {
  const Scratch scratch;
  Sequence sequence;
  for (const int width : {10, 20, 30}) {
    sequence.pictures.push_back(scratch / fmt::format("{}.png", width));
    write_file(sequence.pictures.back(), encoded_picture(".png", width));
  }
  const auto source = read_pictures(sequence);
  cv::Mat picture;
  for (const int width : {10, 20, 30}) {
    ASSERT_TRUE(source->next(picture));
    EXPECT_EQ(picture.cols, width);
  }
  EXPECT_FALSE(source->next(picture));
  EXPECT_FALSE(source->next(picture));
}

TEST(PictureSource, ReadsPicturesAsTheyAreStored) {
  const Scratch scratch;
  for (const int type : {CV_8UC1, CV_8UC3, CV_8UC4, CV_16UC1, CV_16UC3, CV_16UC4}) {
    write_file(scratch / "1.png", encoded_picture(".png", 24, 16, type));
    EXPECT_EQ(read_one(scratch / "1.png").type(), type);
  }
  for (const char* extension : kExtensions) {
    write_file(scratch / "1", encoded_picture(extension, 24, 16, type_for(extension)));
    EXPECT_EQ(read_one(scratch / "1").type(), type_for(extension)) << extension;
  }
  write_file(scratch / "1.ppm", encoded_picture(".ppm", 24, 16, CV_16UC3));
  EXPECT_EQ(read_one(scratch / "1.ppm").type(), CV_16UC3);
  write_file(scratch / "1.jpg", encoded_picture(".jpg", 24, 16, CV_8UC1));
  EXPECT_EQ(read_one(scratch / "1.jpg").type(), CV_8UC1);
}

TEST(PictureSource, ColoursAreBlueGreenRed) {
  const Scratch scratch;
  write_file(scratch / "1.png", encoded_picture(".png"));
  const cv::Mat picture = read_one(scratch / "1.png");
  EXPECT_EQ(picture.at<cv::Vec3b>(2, 20), cv::Vec3b(80, 100, 12));

  Frame frame{.size = {.width = 32, .height = 32}, .rgb = {}};
  for (int i = 0; i < 32 * 32; ++i) frame.rgb.insert(frame.rgb.end(), {200, 100, 30});
  VideoEncoder encoder(scratch / "v.mp4", frame.size, 25);
  for (int i = 0; i < 3; ++i) encoder.write(frame);
  encoder.close();
  const auto video = read_pictures(Sequence::open(scratch / "v.mp4"));
  cv::Mat shown;
  for (int i = 0; i < 3; ++i) {
    ASSERT_TRUE(video->next(shown));
    ASSERT_EQ(shown.type(), CV_8UC3);
    EXPECT_LT(cv::norm(shown.at<cv::Vec3b>(9, 9), cv::Vec3b(30, 100, 200), cv::NORM_INF), 6.0);
  }
  EXPECT_FALSE(video->next(shown));
}

TEST(PictureSource, APictureCutShortAnywhereIsNoticed) {
  for (const char* extension : kExtensions) {
    const std::string whole = encoded_picture(extension, 24, 16, type_for(extension));
    const auto header = read_picture_header(whole);
    ASSERT_TRUE(header && header->whole) << extension;
    EXPECT_EQ(header->width, 24);
    EXPECT_EQ(header->height, 16);
    for (std::size_t left = 0; left < whole.size(); ++left) {
      const auto cut = read_picture_header(whole.substr(0, left));
      EXPECT_FALSE(cut && cut->whole) << extension << " of " << whole.size() << " cut to " << left;
    }
  }
}

TEST(PictureSource, APictureCutShortIsNamed) {
  const Scratch scratch;
  const fs::path file = scratch / "0001.jpg";
  for (const char* extension : kExtensions) {
    const std::string whole = encoded_picture(extension, 24, 16, type_for(extension));
    for (const std::size_t left : {std::size_t{1}, std::size_t{30}, whole.size() - 1}) {
      write_file(file, whole.substr(0, left));
      EXPECT_THAT(complaint_about(file), StartsWith(file.string() + ": not a readable picture: "))
          << extension << " cut to " << left;
    }
  }
}

TEST(PictureSource, WhatIsNoPictureIsNamed) {
  const Scratch scratch;
  write_file(scratch / "1.jpg", "");
  EXPECT_THAT(complaint_about(scratch / "1.jpg"), HasSubstr("it is empty"));
  write_file(scratch / "1.jpg", "1,2,3,4\n");
  EXPECT_THAT(complaint_about(scratch / "1.jpg"), HasSubstr("neither a JPEG"));
  EXPECT_THAT(complaint_about(scratch / "2.jpg"), StartsWith((scratch / "2.jpg").string()));
  EXPECT_THAT(complaint_about(scratch.path()), StartsWith(scratch.path().string()));
}

// What it claims would be gigabytes; nothing of it is asked for.
TEST(PictureSource, APictureThatClaimsToBeHugeIsRefused) {
  const Scratch scratch;
  std::string png = encoded_picture(".png");
  png.replace(16, 8, std::string("\0\0\x7f\xff\0\0\x7f\xff", 8));
  std::string jpg = encoded_picture(".jpg");
  const std::size_t frame = jpg.find("\xff\xc0");
  ASSERT_NE(frame, std::string::npos);
  jpg.replace(frame + 5, 4, "\xff\xff\xff\xff");
  std::string bmp = encoded_picture(".bmp");
  bmp.replace(18, 8, std::string("\xff\xff\xff\x7f\xff\xff\xff\x7f", 8));
  for (const std::string& bytes : {png, jpg, bmp, std::string("P6\n# it is\n99999 99999\n255\n")}) {
    write_file(scratch / "1.png", bytes);
    EXPECT_THAT(complaint_about(scratch / "1.png"), HasSubstr(" pixels")) << bytes.substr(0, 4);
  }
  write_file(scratch / "1.pgm", "P5\n0 5\n255\n");
  EXPECT_THAT(complaint_about(scratch / "1.pgm"), HasSubstr("0 x 5 pixels"));
}

// OpenCV and libpng would print what is wrong with these.
TEST(PictureSource, ADamagedPictureIsNamedAndNothingIsPrinted) {
  const Scratch scratch;
  std::string png = encoded_picture(".png");
  png[png.size() / 2] = static_cast<char>(png[png.size() / 2] + 1);
  write_file(scratch / "1.png", png);
  std::string bmp = encoded_picture(".bmp");
  bmp[30] = 77;  // a packing that there is not
  write_file(scratch / "2.bmp", bmp);
  ::testing::internal::CaptureStderr();
  EXPECT_THAT(complaint_about(scratch / "1.png"), HasSubstr("cut short or damaged"));
  EXPECT_THAT(complaint_about(scratch / "2.bmp"), HasSubstr("neither a JPEG"));
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST(PictureSource, AfterAnUnreadablePictureTheNextIsRead) {
  const Scratch scratch;
  write_file(scratch / "1.png", "garbage");
  write_file(scratch / "2.png", encoded_picture(".png"));
  Sequence sequence;
  sequence.pictures = {scratch / "1.png", scratch / "2.png"};
  const auto source = read_pictures(sequence);
  cv::Mat picture;
  EXPECT_THROW(static_cast<void>(source->next(picture)), std::runtime_error);
  EXPECT_TRUE(source->next(picture));
}

TEST(PictureSource, ACameraThatIsNotThereIsNamedAndNothingIsPrinted) {
  ::testing::internal::CaptureStderr();
  EXPECT_THAT(complaint([] { static_cast<void>(open_camera(63)); }),
              AllOf(StartsWith("camera 63: "), HasSubstr("/dev/video63")));
  EXPECT_THROW(static_cast<void>(open_camera(-1)), UsageError);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace pacer::dataset
