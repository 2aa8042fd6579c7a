// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/flock.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "tests/learning/tracking/texture.h"

namespace pacer::tracking {
namespace {

using ::testing::DoubleNear;
using ::testing::Each;
using ::testing::ElementsAre;

const std::vector<Eigen::Vector2d> kThree = {{1, 0}, {3, 0}, {2, 6}};

TEST(Flocks, MoveByTheMean) { EXPECT_EQ(mean(kThree), Eigen::Vector2d(2, 2)); }

TEST(Flocks, MoveByTheWeightedMean) {
  EXPECT_EQ(weighted_mean(kThree, std::vector<double>{1, 1, 2}), Eigen::Vector2d(2, 3));
}

TEST(Flocks, WeighMembersByTheirErrors) {
  std::vector<double> weights(3);
  weigh(std::vector<double>{0, 1, 4}, weights);
  EXPECT_THAT(weights, ElementsAre(1.0, 0.75, 0.0));
}

TEST(Flocks, WeighEqualErrorsEqually) {
  std::vector<double> weights(3);
  weigh(std::vector<double>{2, 2, 2}, weights);
  EXPECT_THAT(weights, Each(1.0));
  weigh(std::vector<double>{0, 0, 0}, weights);
  EXPECT_THAT(weights, Each(1.0));
  const double almost = std::nextafter(1e-300, 0.0);  // of which no weight above 0 can be made
  weigh(std::vector<double>{almost, 1e-300, almost}, weights);
  EXPECT_GT(mean(kThree).x() + weighted_mean(kThree, weights).x(), 0.0);  // and not NaN
}

TEST(Flocks, MeasureErrorsFromTheirOutput) {
  std::vector<double> errors(3);
  measure_errors(kThree, {1, 0}, errors);
  EXPECT_THAT(errors, ElementsAre(0.0, 2.0, std::hypot(1.0, 6.0)));
}

TEST(Flocks, AreAsSureAsTheyAgree) {
  const std::vector<double> weights = {1, 3};
  EXPECT_EQ(agreement(std::vector<double>{0, 0}, weights), 1.0);
  EXPECT_EQ(agreement(std::vector<double>{20, 0}, weights), 0.5);
  EXPECT_GT(agreement(std::vector<double>{1e6, 1e6}, weights), 0.0);
}

TEST(Flocks, GiveEveryMemberItsPlaceBetweenPixels) {
  const cv::Mat1b image = texture({300, 300}, 2);
  MemberTrainer trainer({}, Random(1));
  for (int i = 0; i < 20; ++i) {
    FlockMember member = trainer.make();
    const Box target{.x = 150.3, .y = 140.8, .width = 40, .height = 60};
    trainer.learn(image, target, member);
    EXPECT_LE(std::abs(member.offset.x()), 20.5);
    EXPECT_LE(std::abs(member.offset.y()), 30.5);
    EXPECT_THAT(member.offset.x() + 150.3, DoubleNear(std::round(member.offset.x() + 150.3), 1e-9));
    // Seen from where the flock was, nothing has moved.
    EXPECT_LT(member.predict(image, {150.3, 140.8}).norm(), 1e-3);
  }
}

/// A flock, learnt at (150, 150) of a smooth texture.
struct LearntFlock : ::testing::Test {
  const cv::Mat1b image = texture({300, 300}, 5, 10.0);
  Flock flock{{}, 60, Random(3)};

  LearntFlock() { flock.learn(image, {.x = 150, .y = 150, .width = 60, .height = 60}); }
};

TEST_F(LearntFlock, IsCloserThanItsMembersAre) {
  const Eigen::Vector2d moved(11, -8);
  const Eigen::Vector2d output =
      flock.predict(image, Eigen::Vector2d(150, 150) + moved, Weighting::kEqual);
  double members = 0.0;
  for (const Eigen::Vector2d& one : flock.displacements()) members += (one + moved).norm() / 60.0;
  EXPECT_LT((output + moved).norm(), 0.5 * members);
  EXPECT_EQ(output, mean(flock.displacements()));
}

TEST_F(LearntFlock, WeighsByAgreementWithTheMean) {
  const Eigen::Vector2d from(160, 144);
  const Eigen::Vector2d equal = flock.predict(image, from, Weighting::kEqual);
  EXPECT_THAT(flock.weights(), Each(1.0));
  const Eigen::Vector2d weighted = flock.predict(image, from, Weighting::kAgreement);
  std::vector<double> errors(60), weights(60);
  measure_errors(flock.displacements(), equal, errors);
  weigh(errors, weights);
  EXPECT_THAT(flock.weights(), ::testing::ElementsAreArray(weights));
  EXPECT_EQ(weighted, weighted_mean(flock.displacements(), weights));
  measure_errors(flock.displacements(), weighted, errors);
  EXPECT_THAT(flock.errors(), ::testing::ElementsAreArray(errors));
}

TEST(Flocks, HaveAMember) { EXPECT_THROW(Flock({}, 0, Random(1)), std::invalid_argument); }

}  // namespace
}  // namespace pacer::tracking
