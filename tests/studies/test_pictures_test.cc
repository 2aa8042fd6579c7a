// SPDX-License-Identifier: Apache-2.0
#include "studies/test_pictures.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <opencv2/imgcodecs.hpp>

#include "core/check.h"

namespace pacer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

class TestPicturesTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / (std::string("pacer-pictures-") + test->name());
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void put(const std::string& name, int width = 120, int height = 110, int value = 50) const {
    fs::create_directories((folder_ / name).parent_path());
    ASSERT_TRUE(cv::imwrite((folder_ / name).string(),
                            cv::Mat(height, width, CV_8UC3, cv::Scalar::all(value))));
  }
  std::string refusal() const {
    try {
      (void)read_test_pictures(folder_);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder_;
};

TEST_F(TestPicturesTest, PicturesInAFolderAndBelowAreTakenInOrder) {
  put("b.png", 120, 110, 80);
  put("sequence/img/0001.jpg");
  put("a.JPG");
  std::ofstream(folder_ / "notes.txt") << "no picture";
  const TestPictures pictures = read_test_pictures(folder_);
  EXPECT_THAT(pictures.names, ElementsAre("a.JPG", "b.png", "sequence/img/0001.jpg"));
  ASSERT_EQ(pictures.grey.size(), 3U);
  EXPECT_EQ(pictures.grey[1](5, 5), 80);
  EXPECT_THAT(pictures.about, HasSubstr(folder_.string()));
}

TEST_F(TestPicturesTest, OfManyTwentyAreChosenEvenly) {
  for (int i = 0; i < 50; ++i) put(fmt::format("{:02}.png", i));
  const TestPictures pictures = read_test_pictures(folder_);
  ASSERT_EQ(pictures.names.size(), 20U);
  EXPECT_EQ(pictures.names[0], "00.png");
  EXPECT_EQ(pictures.names[1], "02.png");
  EXPECT_EQ(pictures.names[19], "47.png");
}

TEST_F(TestPicturesTest, LargePicturesAreReduced) {
  put("large.png", 2048, 1024);
  EXPECT_EQ(read_test_pictures(folder_).grey[0].size(), cv::Size(1024, 512));
}

TEST_F(TestPicturesTest, AFolderThatIsNotThereOrEmptyIsNamed) {
  EXPECT_THROW((void)read_test_pictures(folder_), UsageError);
  EXPECT_THAT(refusal(), HasSubstr(folder_.string() + ": no pictures"));
  fs::remove_all(folder_);
  EXPECT_THROW((void)read_test_pictures(folder_), UsageError);
  EXPECT_THAT(refusal(), HasSubstr(folder_.string() + ": there is no such folder"));
}

TEST_F(TestPicturesTest, APictureThatCannotBeReadOrIsTooSmallIsNamed) {
  put("small.png", 300, 99);
  EXPECT_THAT(refusal(), HasSubstr((folder_ / "small.png").string() + ": 300 x 99 pixels"));
  std::ofstream(folder_ / "broken.png") << "no picture";
  EXPECT_THAT(refusal(), HasSubstr((folder_ / "broken.png").string()));
}

}  // namespace
}  // namespace pacer
