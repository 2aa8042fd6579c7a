// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/lucas_kanade.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>
#include <stdexcept>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

/// The method with a template of 20 x 20 pixels, as in 3.2.1.
struct LucasKanades : ::testing::Test {
  const cv::Mat1b image = texture({200, 160}, 11, 8.0);
  const TemplateGrid grid{20.0, 20.0, 400};
  LucasKanade registration{{}, grid};

  std::vector<std::uint8_t> seen(const cv::Mat1b& picture, cv::Point at) const {
    std::vector<std::uint8_t> values(grid.length());
    grid.extract(picture, at, values.data());
    return values;
  }
  /// The pixel within `range` where the picture is most like a template.
  cv::Point best(const cv::Mat1b& picture, std::span<const std::uint8_t> wanted, cv::Point about,
                 int range) const {
    cv::Point found;
    double least = std::numeric_limits<double>::infinity();
    for (int y = -range; y <= range; ++y) {
      for (int x = -range; x <= range; ++x) {
        const cv::Point at = about + cv::Point(x, y);
        const double difference = distance(seen(picture, at), wanted);
        if (difference < least) {
          least = difference;
          found = at;
        }
      }
    }
    return found;
  }
};

TEST_F(LucasKanades, FindTheTemplateFromNearby) {
  Random random(1);
  for (int trial = 0; trial < 100; ++trial) {
    const cv::Point at(40 + static_cast<int>(random.below(120)),
                       40 + static_cast<int>(random.below(80)));
    registration.set_template(seen(image, at));
    const Eigen::Vector2d home(at.x, at.y);
    const Eigen::Vector2d from =
        home + Eigen::Vector2d(random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
    const Registration found = registration.align(image, from);
    EXPECT_LT((found.at - home).norm(), 1e-6);
    EXPECT_EQ(found.residual, 0.0);
    EXPECT_EQ(confidence(found), 1.0);
  }
}

TEST_F(LucasKanades, FindTheLeastDifferenceInAChangedPicture) {
  Random random(2);
  cv::Mat1b changed = image.clone();
  for (std::uint8_t& value : changed) {
    value = cv::saturate_cast<std::uint8_t>(value + random.normal(0.0, 2.0));
  }
  for (int trial = 0; trial < 30; ++trial) {
    const cv::Point at(40 + static_cast<int>(random.below(120)),
                       40 + static_cast<int>(random.below(80)));
    const std::vector<std::uint8_t> wanted = seen(image, at);
    registration.set_template(wanted);
    const Registration found = registration.align(changed, {at.x + 2.0, at.y - 2.0});
    const cv::Point expected = best(changed, wanted, at, 6);
    EXPECT_LT((found.at - Eigen::Vector2d(expected.x, expected.y)).norm(), 1.0);
  }
}

TEST_F(LucasKanades, FindAPartOfAPixel) {
  registration.set_template(seen(image, {100, 80}));
  const cv::Mat1b moved = part_of(image, {0.3, -0.4}, image.size());
  const Registration found = registration.align(moved, {100, 80});
  EXPECT_LT((found.at - Eigen::Vector2d(99.7, 80.4)).norm(), 0.1);
}

TEST_F(LucasKanades, StayWithinTheirBasin) {
  registration.set_template(seen(image, {100, 80}));
  const Registration found = registration.align(image, {140, 50});  // two sides away
  EXPECT_GT((found.at - Eigen::Vector2d(100, 80)).norm(), 5.0);
}

TEST_F(LucasKanades, TakeShorterStepsWhereLongOnesFail) {
  std::vector<std::uint8_t> faint = seen(image, {100, 80});
  const int grey = std::accumulate(faint.begin(), faint.end(), 0) / 400;
  for (std::uint8_t& value : faint) value = static_cast<std::uint8_t>(grey + (value - grey) / 4);
  registration.set_template(faint);  // steps are four times too long
  const Registration found = registration.align(image, {101, 79});
  const cv::Point expected = best(image, faint, {100, 80}, 4);
  EXPECT_LE((found.at - Eigen::Vector2d(expected.x, expected.y)).norm(), 1.0);
}

TEST_F(LucasKanades, NeverEndWorseThanTheyBegan) {
  Random random(3);
  for (int trial = 0; trial < 100; ++trial) {
    registration.set_template(seen(image, {100, 80}));
    const cv::Point from(static_cast<int>(random.below(200)), static_cast<int>(random.below(160)));
    const double before = distance(seen(image, from), seen(image, {100, 80}));
    const Registration found = registration.align(image, Eigen::Vector2d(from.x, from.y));
    EXPECT_LE(found.residual, before / 20.0 + 1e-9);
  }
}

TEST_F(LucasKanades, LeaveAFlatTemplateWhereItIs) {
  registration.set_template(std::vector<std::uint8_t>(grid.length(), 90));
  const Registration found = registration.align(image, {50.4, 60.2});
  EXPECT_LE((found.at - Eigen::Vector2d(50, 60)).norm(), 0.5);
}

TEST_F(LucasKanades, TakeTheGradientFromTheGridOfALargeTarget) {
  const TemplateGrid thin(80.0, 60.0, 300);
  LucasKanade coarse({}, thin);
  std::vector<std::uint8_t> values(thin.length());
  thin.extract(image, {100, 80}, values.data());
  coarse.set_template(values);
  EXPECT_LT((coarse.align(image, {103, 77}).at - Eigen::Vector2d(100, 80)).norm(), 0.5);
}

TEST_F(LucasKanades, RefuseSettingsWithoutSense) {
  EXPECT_THROW(LucasKanade({.most_steps = 0}, grid), std::invalid_argument);
  EXPECT_THROW(LucasKanade({.damping = 0.0}, grid), std::invalid_argument);
}

}  // namespace
}  // namespace pacer::tracking
