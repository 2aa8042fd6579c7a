// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cctype>
#include <cmath>
#include <limits>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/box.h"
#include "core/random.h"
#include "learning/tracking/tracker.h"

namespace pacer::tracking {

/// For GoogleTest.
inline void PrintTo(const TrackerKind& kind, std::ostream* out) { *out << kind.name; }

}  // namespace pacer::tracking

namespace pacer::testing {

/// Every Tracker keeps this contract. A list of kinds joins it, once a program:
///   INSTANTIATE_TEST_SUITE_P(Peers, TrackerContract, ::testing::ValuesIn(tracking::peers()),
///                            tracker_name);
class TrackerContract : public ::testing::TestWithParam<tracking::TrackerKind> {
 protected:
  static constexpr ImageSize kSize{.width = 140, .height = 100};
  static constexpr double kSide = 40.0;

  static std::unique_ptr<tracking::Tracker> make(std::uint64_t seed = 1) {
    return GetParam().make(seed);
  }

  /// Where the square is in picture `i`: it moves by 2 and 1 pixels.
  static Box truth(int i) { return Box::of_pixels(30.0 + 2.0 * i, 25.0 + i, kSide, kSide); }

  /// Smooth noise, grey levels 30 to 225 or so.
  static cv::Mat3b texture(int width, int height, std::uint64_t seed) {
    Random random(seed);
    cv::Mat3b image(height, width);
    for (cv::Vec3b& pixel : image) {
      for (int i = 0; i < 3; ++i) pixel[i] = static_cast<std::uint8_t>(random.below(256));
    }
    cv::GaussianBlur(image, image, {}, 1.5);
    cv::normalize(image, image, 30, 225, cv::NORM_MINMAX);
    return image;
  }

  static tracking::Picture picture_of(const cv::Mat3b& image) {
    tracking::Picture picture;
    to_picture(image, picture);
    return picture;
  }

  /// A textured square on a texture that stands still.
  static std::vector<tracking::Picture> moving_square(int count, std::uint64_t seed = 7) {
    const cv::Mat3b background = texture(kSize.width, kSize.height, seed);
    const int side = static_cast<int>(kSide);
    const cv::Mat3b square = texture(side, side, seed + 1);
    std::vector<tracking::Picture> pictures;
    for (int i = 0; i < count; ++i) {
      cv::Mat3b image = background.clone();
      square.copyTo(image(cv::Rect(static_cast<int>(truth(i).left()),
                                   static_cast<int>(truth(i).top()), side, side)));
      pictures.push_back(picture_of(image));
    }
    return pictures;
  }

  /// Any box that holds a pixel of the picture: as far as it may be from what trackers like.
  static std::vector<Box> awkward_boxes() {
    const double right = kSize.width;
    const double bottom = kSize.height;
    std::vector<Box> boxes{// Half outside.
                           Box::of_pixels(-14, 20, 28, 28),
                           Box::of_pixels(right - 14, 20, 28, 28),
                           Box::of_pixels(40, -14, 28, 28),
                           Box::of_pixels(40, bottom - 14, 28, 28),
                           // All but a pixel outside.
                           Box::of_pixels(-27, -27, 28, 28),
                           Box::of_pixels(right - 1, bottom - 1, 28, 28),
                           // A pixel wide.
                           Box::of_pixels(50, 20, 1, 40),
                           Box::of_pixels(20, 50, 40, 1),
                           Box::of_pixels(60, 45, 1, 1),
                           Box::of_pixels(0, 0, 1, bottom),
                           // As large as the picture, and larger.
                           Box::of_pixels(1, 1, right - 2, bottom - 2),
                           Box::of_pixels(0, 0, right, bottom),
                           Box::of_pixels(-50, -40, 300, 200),
                           Box::of_pixels(30, -500, 28, 2000),
                           {1e7, 40, 2.1e7, 30}};
    Random random(11);
    for (int i = 0; i < 10; ++i) {
      const double width = random.uniform(1.0, 90.0);
      const double height = random.uniform(1.0, 70.0);
      boxes.push_back({random.uniform(-0.4 * width, right - 1.0 + 0.4 * width),
                       random.uniform(-0.4 * height, bottom - 1.0 + 0.4 * height), width, height});
    }
    return boxes;
  }

  /// Of every picture after the first; none where a library refuses to start.
  static std::vector<tracking::Track> follow_or_refuse(
      tracking::Tracker& tracker, const std::vector<tracking::Picture>& pictures,
      const Box& target) {
    try {
      tracker.start(pictures.front(), target);
    } catch (const std::invalid_argument&) {
      return {};
    }
    std::vector<tracking::Track> tracks;
    for (std::size_t i = 1; i < pictures.size(); ++i) tracks.push_back(tracker.update(pictures[i]));
    return tracks;
  }

  /// Of every picture after the first.
  static std::vector<tracking::Track> follow(tracking::Tracker& tracker,
                                             const std::vector<tracking::Picture>& pictures,
                                             const Box& target) {
    tracker.start(pictures.front(), target);
    std::vector<tracking::Track> tracks;
    for (std::size_t i = 1; i < pictures.size(); ++i) tracks.push_back(tracker.update(pictures[i]));
    return tracks;
  }

  static void expect_same(const std::vector<tracking::Track>& one,
                          const std::vector<tracking::Track>& other) {
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].box, other[i].box) << "picture " << i + 1;
      EXPECT_EQ(one[i].confidence, other[i].confidence) << "picture " << i + 1;
    }
  }

  static void expect_defined(const tracking::Track& track) {
    EXPECT_TRUE(is_proper(track.box)) << track.box.x << ", " << track.box.y << ", "
                                      << track.box.width << " x " << track.box.height;
    EXPECT_GE(track.confidence, 0.0);
    EXPECT_LE(track.confidence, 1.0);
  }
};

inline std::string tracker_name(const ::testing::TestParamInfo<tracking::TrackerKind>& info) {
  std::string name;
  for (const char c : info.param.name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
  }
  return name;
}

TEST_P(TrackerContract, ATexturedSquareIsFollowed) {
  const std::vector<tracking::Picture> pictures = moving_square(9);
  const std::unique_ptr<tracking::Tracker> tracker = make();
  const std::vector<tracking::Track> tracks = follow(*tracker, pictures, truth(0));
  for (std::size_t i = 0; i < tracks.size(); ++i) {
    expect_defined(tracks[i]);
    EXPECT_GT(tracks[i].confidence, 0.0) << "picture " << i + 1;
    EXPECT_GT(overlap(tracks[i].box, truth(static_cast<int>(i) + 1)), 0.5) << "picture " << i + 1;
  }
}

TEST_P(TrackerContract, TheSameSeedGivesTheSameTracks) {
  const std::vector<tracking::Picture> pictures = moving_square(6);
  expect_same(follow(*make(), pictures, truth(0)), follow(*make(), pictures, truth(0)));
}

TEST_P(TrackerContract, StartingAgainBeginsAnew) {
  const std::vector<tracking::Picture> pictures = moving_square(5);
  const std::vector<tracking::Track> fresh = follow(*make(), pictures, truth(0));
  const std::unique_ptr<tracking::Tracker> tracker = make();
  // Of another size, of another picture, and lost.
  const cv::Mat3b other = texture(100, 70, 3);
  static_cast<void>(follow(*tracker, {picture_of(other), picture_of(other)}, {60, 35, 40, 30}));
  const tracking::Picture black =
      picture_of(cv::Mat3b(kSize.height, kSize.width, cv::Vec3b(0, 0, 0)));
  static_cast<void>(follow(*tracker, {pictures[3], black}, truth(3)));
  expect_same(follow(*tracker, pictures, truth(0)), fresh);
}

TEST_P(TrackerContract, TwoInTurnsTrackAsEachAlone) {
  const std::vector<tracking::Picture> one = moving_square(5, 7);
  const std::vector<tracking::Picture> other = moving_square(5, 70);
  const std::unique_ptr<tracking::Tracker> first = make(1);
  const std::unique_ptr<tracking::Tracker> second = make(2);
  first->start(one[0], truth(0));
  second->start(other[0], truth(0));
  std::vector<tracking::Track> of_first;
  std::vector<tracking::Track> of_second;
  for (std::size_t i = 1; i < one.size(); ++i) {
    of_first.push_back(first->update(one[i]));
    of_second.push_back(second->update(other[i]));
  }
  expect_same(of_first, follow(*make(1), one, truth(0)));
  expect_same(of_second, follow(*make(2), other, truth(0)));
}

TEST_P(TrackerContract, NothingIsTrackedBeforeTheStart) {
  const std::unique_ptr<tracking::Tracker> tracker = make();
  EXPECT_THROW(static_cast<void>(tracker->update(moving_square(1)[0])), std::logic_error);
}

TEST_P(TrackerContract, APictureOfAnotherSizeIsRefusedAndTheNextOneFollowed) {
  const std::vector<tracking::Picture> pictures = moving_square(3);
  const std::unique_ptr<tracking::Tracker> tracker = make();
  tracker->start(pictures[0], truth(0));
  std::vector<tracking::Track> tracks{tracker->update(pictures[1])};
  EXPECT_THROW(
      static_cast<void>(tracker->update(picture_of(texture(kSize.width, kSize.height + 1, 3)))),
      std::invalid_argument);
  EXPECT_THROW(static_cast<void>(tracker->update(tracking::Picture())), std::invalid_argument);
  tracks.push_back(tracker->update(pictures[2]));
  expect_same(tracks, follow(*make(), pictures, truth(0)));
}

TEST_P(TrackerContract, ABoxWithNothingInItIsRefused) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  const tracking::Picture picture = moving_square(1)[0];
  const std::unique_ptr<tracking::Tracker> tracker = make();
  for (const Box& box : std::vector<Box>{Box::of_pixels(-28, 10, 28, 28),
                                         Box::of_pixels(kSize.width, 10, 28, 28),
                                         Box::of_pixels(10, -300, 28, 28),
                                         Box::of_pixels(10, kSize.height, 28, 28),
                                         {60, 40, 0, 10},
                                         {60, 40, 10, -10},
                                         {60, 40, 0.9, 10},
                                         {nan, 40, 10, 10},
                                         {60, 40, 10, nan},
                                         {60, 40, infinite, 10},
                                         {60, 40, 1e300, 10}}) {
    EXPECT_THROW(tracker->start(picture, box), std::invalid_argument)
        << box.x << ", " << box.y << ", " << box.width << " x " << box.height;
  }
}

TEST_P(TrackerContract, AnyOtherBoxIsFollowedLostOrRefused) {
  const std::vector<tracking::Picture> pictures = moving_square(3);
  const std::unique_ptr<tracking::Tracker> tracker = make();
  for (const Box& box : awkward_boxes()) {
    for (const tracking::Track& track : follow_or_refuse(*tracker, pictures, box)) {
      expect_defined(track);
      if (::testing::Test::HasFailure()) {
        FAIL() << "a box of " << box.width << " x " << box.height << " at " << box.left() << ", "
               << box.top();
      }
    }
  }
}

TEST_P(TrackerContract, SmallPicturesAreFollowedLostOrRefused) {
  for (const ImageSize size : {ImageSize{.width = 1, .height = 1},
                               {.width = 2, .height = 40},
                               {.width = 40, .height = 3},
                               {.width = 9, .height = 9},
                               {.width = 17, .height = 12}}) {
    const cv::Mat3b image = texture(size.width + 1, size.height, 5);
    const cv::Rect view(0, 0, size.width, size.height);
    for (const int side : {1, 5, 9}) {
      const std::unique_ptr<tracking::Tracker> tracker = make();
      for (const tracking::Track& track : follow_or_refuse(
               *tracker, {picture_of(image(view)), picture_of(image(view + cv::Point(1, 0)))},
               Box::of_pixels(0, 0, side, side))) {
        expect_defined(track);
      }
    }
  }
}

TEST_P(TrackerContract, ATargetThatIsHiddenOrHasNoTextureHasADefinedTrack) {
  const cv::Size size(kSize.width, kSize.height);
  const tracking::Picture seen = moving_square(1)[0];
  std::vector<tracking::Picture> hidden{seen};
  hidden.push_back(picture_of(cv::Mat3b(size, cv::Vec3b(0, 0, 0))));
  hidden.push_back(picture_of(cv::Mat3b(size, cv::Vec3b(255, 255, 255))));
  hidden.push_back(picture_of(texture(size.width, size.height, 99)));
  hidden.push_back(seen);
  const std::unique_ptr<tracking::Tracker> tracker = make();
  Annotations annotations;
  for (const tracking::Picture& picture : {seen, hidden[1]}) {
    try {
      tracker->start(picture, truth(0));
    } catch (const std::invalid_argument&) {  // a library that wants texture
      continue;
    }
    for (const tracking::Picture& next : hidden) {
      expect_defined(tracker->update(next));
      tracker->annotate(annotations);
    }
  }
  for (const PointMark& mark : annotations.points) {
    EXPECT_TRUE(std::isfinite(mark.at.x) && std::isfinite(mark.at.y));
  }
  for (const BoxMark& mark : annotations.boxes) {
    EXPECT_LE(mark.low.x, mark.high.x);
    EXPECT_LE(mark.low.y, mark.high.y);
  }
}

}  // namespace pacer::testing
