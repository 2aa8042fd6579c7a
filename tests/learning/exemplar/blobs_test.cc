// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/blobs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/learning/exemplar/painted.h"

namespace pacer::exemplar {
namespace {

using namespace testing;  // NOLINT(google-build-using-namespace): painted.h

constexpr ImageSize kSize{160, 120};

std::vector<Blob> blobs_of(const Frame& frame) {
  BlobFinder finder;
  const auto found = finder.find(frame);
  return {found.begin(), found.end()};
}

/// The blob nearest to a place.
Blob near(const std::vector<Blob>& blobs, double x, double y) {
  return *std::ranges::min_element(
      blobs, {}, [&](const Blob& blob) { return (blob.centroid - Eigen::Vector2d(x, y)).norm(); });
}

/// Something to look at: patches, balls, noise.
Frame busy(std::uint64_t seed) {
  Frame frame = wall(kSize);
  Random random(seed);
  for (int i = 0; i < 12; ++i) {
    const Rgb colour{random.uniform(0, 255), random.uniform(0, 255), random.uniform(0, 255)};
    const int x = static_cast<int>(random.below(140)), y = static_cast<int>(random.below(100));
    if (i % 2 == 0) {
      fill_rectangle(frame, x, y, 8 + static_cast<int>(random.below(40)), 25, colour);
    } else {
      fill_ball(frame, x, y, random.uniform(4, 20), colour);
    }
  }
  add_noise(frame, 2.5, random.fork("noise"));
  return frame;
}

TEST(Blobs, MomentsAreThoseOfThePixelsSummedOneByOne) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Frame frame = busy(seed);
    BlobFinder finder;
    const auto blobs = finder.find(frame);
    ASSERT_GT(blobs.size(), 3U);
    for (std::size_t i = 0; i < blobs.size(); ++i) {
      double n = 0.0, x1 = 0.0, y1 = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
      Eigen::Vector3d colour = Eigen::Vector3d::Zero();
      const auto each = [&](const auto& visit) {
        for (std::size_t p = 0; p < finder.labels().size(); ++p) {
          if (finder.labels()[p] == static_cast<std::int32_t>(i)) {
            visit(static_cast<double>(p % 160), static_cast<double>(p / 160), 3 * p);
          }
        }
      };
      each([&](double x, double y, std::size_t at) {
        n += 1.0;
        x1 += x;
        y1 += y;
        colour += Eigen::Vector3d(frame.rgb[at], frame.rgb[at + 1], frame.rgb[at + 2]);
      });
      each([&](double x, double y, std::size_t) {
        xx += (x - x1 / n) * (x - x1 / n);
        xy += (x - x1 / n) * (y - y1 / n);
        yy += (y - y1 / n) * (y - y1 / n);
      });
      EXPECT_EQ(blobs[i].area, n);
      EXPECT_NEAR(blobs[i].centroid.x(), x1 / n, 1e-9);
      EXPECT_NEAR(blobs[i].centroid.y(), y1 / n, 1e-9);
      EXPECT_NEAR(blobs[i].xx, xx / n, 1e-7);
      EXPECT_NEAR(blobs[i].xy, xy / n, 1e-7);
      EXPECT_NEAR(blobs[i].yy, yy / n, 1e-7);
      EXPECT_TRUE(blobs[i].colour.isApprox(colour / n, 1e-12));
    }
  }
}

TEST(Blobs, APatchOnAWallIsABlobWithItsVeryPixels) {
  Frame frame = wall(kSize);
  fill_rectangle(frame, 40, 30, 24, 17, kRedRubber);
  const Blob patch = near(blobs_of(frame), 51.5, 38.0);
  EXPECT_EQ(patch.area, 24 * 17);
  EXPECT_EQ(patch.centroid, Eigen::Vector2d(51.5, 38.0));
  EXPECT_EQ(patch.box, Box::of_pixels(40, 30, 24, 17));
  EXPECT_EQ(patch.cut, Sides{});
  EXPECT_NEAR(patch.xx, (24.0 * 24.0 - 1.0) / 12.0, 1e-9);
}

TEST(Blobs, ANoisyEllipseKeepsItsMiddleAreaAndAxes) {
  Frame frame = wall(kSize);
  fill_ball(frame, 80.3, 60.6, 20.0, kGreenRubber);
  add_noise(frame, 3.0, Random(1));
  const Blob ball = near(blobs_of(frame), 80.3, 60.6);
  EXPECT_NEAR(ball.centroid.x(), 80.3, 0.3);
  EXPECT_NEAR(ball.centroid.y(), 60.6, 0.3);
  EXPECT_NEAR(ball.area, 3.1416 * 20.0 * 23.0, 60.0);
  EXPECT_NEAR(ellipse(ball).major, 23.0, 0.6);
  EXPECT_NEAR(ellipse(ball).minor, 20.0, 0.6);
  EXPECT_GT(fill(ball), 0.97);
}

TEST(Blobs, APatchMovedByWholePixelsKeepsItsSecondMoments) {
  const auto at = [](int x, int y) {
    Frame frame = wall(kSize);
    fill_ball(frame, x, y, 9.0, kRedRubber);
    return near(blobs_of(frame), x, y);
  };
  const Blob here = at(40, 40), there = at(40 + 32, 40 + 32);
  EXPECT_EQ(here.area, there.area);
  EXPECT_EQ(here.xx, there.xx);
  EXPECT_EQ(here.xy, there.xy);
  EXPECT_EQ(here.yy, there.yy);
  EXPECT_EQ(there.centroid - here.centroid, Eigen::Vector2d(32, 32));
}

TEST(Blobs, AMirroredPictureHasMirroredBlobs) {
  const Frame frame = busy(7);
  const std::vector<Blob> plain = blobs_of(frame), turned = blobs_of(mirrored(frame));
  EXPECT_EQ(plain.size(), turned.size());
  for (const Blob& blob : plain) {
    if (blob.area < 200) continue;
    const Blob twin = near(turned, 159.0 - blob.centroid.x(), blob.centroid.y());
    EXPECT_NEAR(twin.area, blob.area, 0.02 * blob.area);
    EXPECT_NEAR(twin.xy, -blob.xy, 0.05 * (blob.xx + blob.yy));
  }
}

TEST(Blobs, TheSameFrameGivesTheSameBlobsWhateverCameBefore) {
  BlobFinder finder;
  (void)finder.find(busy(1));
  (void)finder.find(wall({7, 5}));
  const auto again = finder.find(busy(2));
  const std::vector<Blob> fresh = blobs_of(busy(2));
  EXPECT_TRUE(std::ranges::equal(again, fresh));
}

TEST(Blobs, FramesOfOneColourAreOneBlobOfAnySize) {
  for (const Rgb& colour : {Rgb{0, 0, 0}, Rgb{255, 255, 255}, kRedRubber}) {
    for (const ImageSize size : {ImageSize{320, 240}, {97, 61}, {12, 1}, {1, 40}, {16, 9}}) {
      const std::vector<Blob> blobs = blobs_of(wall(size, colour));
      ASSERT_EQ(blobs.size(), 1U) << size.width << " x " << size.height;
      EXPECT_EQ(blobs[0].area, size.width * size.height);
      EXPECT_EQ(blobs[0].cut, (Sides{true, true, true, true}));
    }
  }
}

TEST(Blobs, FramesTooSmallForABlobHaveNone) {
  EXPECT_TRUE(blobs_of(wall({1, 1})).empty());
  EXPECT_TRUE(blobs_of(wall({11, 1})).empty());
  EXPECT_TRUE(blobs_of(Frame{}).empty());
}

TEST(Blobs, BytesThatDoNotFitTheSizeAreSaid) {
  Frame frame = wall({8, 8});
  frame.rgb.pop_back();
  EXPECT_THROW((void)blobs_of(frame), std::invalid_argument);
}

TEST(Blobs, NoiseHasNoBlobs) { EXPECT_LE(blobs_of(noise(kSize, Random(3))).size(), 2U); }

TEST(Blobs, ARampFromOneColourToAnotherDoesNotJoinThem) {
  Frame frame = wall(kSize, kRedRubber);
  for (int y = 0; y < 120; ++y) {
    for (int x = 78; x < 160; ++x) {
      const double share = std::min(1.0, (x - 77) / 4.0);
      Rgb mixed{};
      for (std::size_t c = 0; c < 3; ++c) {
        mixed[c] = (1.0 - share) * kRedRubber[c] + share * kWall[c];
      }
      put(frame, x, y, mixed);
    }
  }
  const std::vector<Blob> blobs = blobs_of(frame);
  EXPECT_NEAR(near(blobs, 39, 60).area, 78 * 120, 240);
  EXPECT_NEAR(near(blobs, 120, 60).area, 79 * 120, 240);
}

TEST(Blobs, ABadConfigNamesItsField) {
  try {
    BlobFinder finder({.homogeneous = 0});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("homogeneous"));
  }
}

}  // namespace
}  // namespace pacer::exemplar
