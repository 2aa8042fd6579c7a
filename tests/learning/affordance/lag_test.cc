// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/lag.h"

#include <gtest/gtest.h>

#include <cmath>

#include "learning/affordance/policy.h"
#include "learning/affordance/train.h"
#include "tests/learning/affordance/late_world.h"

namespace pacer::affordance {
namespace {

using pacer::testing::lag_config;
using pacer::testing::late_answers;
using pacer::testing::PatchDemonstration;
using pacer::testing::PatchPainter;
using pacer::testing::PatchStep;

TEST(Lag, IsFoundWhereTheTeacherIsLate) {
  for (const int late : {0, 3, 10}) {
    const FoundLag found = find_lag(late_answers(late), lag_config(), Random(1));
    EXPECT_NEAR(found.frames, late, 1);
    ASSERT_EQ(found.explained.size(), 21U) << "0.8 s at 25 Hz";
    EXPECT_GT(found.explained[static_cast<std::size_t>(late)], 0.4);
    EXPECT_GT(found.pictures, 50U);
    EXPECT_TRUE(found.settled || found.rounds == 4);
  }
}

/// How far a model is from what the teacher would have done at once, in the mean.
double error_at_once(const Model& model) {
  AffordancePolicy policy(std::shared_ptr<const Model>(&model, [](const Model*) {}));
  const PatchPainter painter(1000);
  Frame frame;
  double sum = 0.0;
  int matched = 0;
  std::uint64_t index = 0;
  for (const PatchStep& step : pacer::testing::wander(150, Random(999))) {
    painter.paint(step, index++, frame);
    Annotations annotations;
    const Command command = policy.act({frame, {}}, annotations);
    if (policy.configurations() == 0) continue;
    sum += std::abs(command.steering - step.command.steering);
    ++matched;
  }
  return matched > 0 ? sum / matched : 1e9;
}

TEST(Lag, APolicyAnswersAtOnceWhatTheTeacherAnsweredLate) {
  const PatchDemonstration demonstration = late_answers(10);
  AffordanceConfig config = lag_config();
  const Training without = train(demonstration, config, Random(1));
  config.transactions.lag = "0.4";
  const Training with = train(demonstration, config, Random(1));
  EXPECT_LT(error_at_once(with.model), 0.7 * error_at_once(without.model));
  EXPECT_EQ(with.report.frames, without.report.frames - 4U * 10U)
      << "pictures without an answer are left out";
  EXPECT_EQ(without.report.lag, Seconds{});
  EXPECT_EQ(with.report.lag, Seconds{0.4});
}

TEST(Lag, FoundOrGivenMakesTheSameModel) {
  const PatchDemonstration demonstration = late_answers(3);
  AffordanceConfig config = lag_config();
  config.transactions.lag = "found";
  const Training found = train(demonstration, config, Random(1));
  ASSERT_TRUE(found.report.found.has_value());
  EXPECT_EQ(found.model.config.transactions.given_lag(), found.report.lag);
  config.transactions.lag = found.model.config.transactions.lag;
  const Training given = train(demonstration, config, Random(1));
  EXPECT_FALSE(given.report.found.has_value());
  EXPECT_EQ(to_bytes(given.model), to_bytes(found.model));
}

}  // namespace
}  // namespace pacer::affordance
