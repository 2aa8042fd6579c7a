// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/lag.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "core/check.h"
#include "learning/affordance/policy.h"
#include "learning/affordance/train.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::affordance {
namespace {

using pacer::testing::PatchDemonstration;
using pacer::testing::PatchPainter;
using pacer::testing::PatchStep;

AffordanceConfig small_config() {
  AffordanceConfig config;
  config.words.samples = 3000;
  config.words.iterations = 10;
  config.features.top = 0.25;
  config.features.max_size = 8.0;
  config.transactions.wanted = 8000;
  config.transactions.common_item_percent = 100.0;
  config.mining.support_percent = 0.1;
  config.mining.max_items = 4;
  config.selection.max_rules = 100;
  config.transactions.stretch = Seconds{0.5};
  return config;
}

/// A wandering patch that a teacher answers `late` frames after it has seen it.
PatchDemonstration late_answers(int late, int episodes = 4, int frames = 130) {
  cv::setNumThreads(1);  // the thread sanitizer cannot see into OpenCV's own threads
  std::vector<std::vector<PatchStep>> all;
  for (int e = 0; e < episodes; ++e) {
    std::vector<PatchStep> steps =
        pacer::testing::wander(frames, Random(17).fork("episode", static_cast<std::uint64_t>(e)));
    for (std::size_t i = steps.size(); i-- > 0;) {
      const std::size_t seen = i - std::min(i, static_cast<std::size_t>(late));
      steps[i].command = steps[seen].command;
    }
    all.push_back(std::move(steps));
  }
  return PatchDemonstration(std::move(all));
}

TEST(Lag, PutsEachPictureBesideTheCommandThatAnswersIt) {
  const PatchDemonstration demonstration(2, 20, 3);
  for (const int lag : {0, 1, 7, 19}) {
    const AnsweredDemonstration answered(demonstration, lag);
    for (std::size_t episode = 0; episode < 2; ++episode) {
      std::vector<Frame> frames;
      std::vector<Command> commands;
      const auto plain = demonstration.open(episode);
      while (const DemonstratedStep* step = plain->next()) {
        frames.push_back(*step->frame);
        commands.push_back(step->command);
      }
      const auto stream = answered.open(episode);
      std::size_t read = 0;
      while (const DemonstratedStep* step = stream->next()) {
        ASSERT_LT(read, frames.size());
        EXPECT_EQ(step->frame->index, frames[read].index);
        EXPECT_EQ(step->frame->rgb, frames[read].rgb);
        EXPECT_EQ(step->command, commands[read + static_cast<std::size_t>(lag)]);
        ++read;
      }
      EXPECT_EQ(read, frames.size() - static_cast<std::size_t>(lag));
    }
  }
  EXPECT_EQ(AnsweredDemonstration(demonstration, 20).open(0)->next(), nullptr);
}

TEST(Lag, IsFoundWhereTheTeacherIsLate) {
  for (const int late : {0, 3, 10}) {
    const FoundLag found = find_lag(late_answers(late), small_config(), Random(1));
    EXPECT_NEAR(found.frames, late, 1);
    ASSERT_EQ(found.explained.size(), 21U) << "0.8 s at 25 Hz";
    EXPECT_GT(found.explained[static_cast<std::size_t>(late)], 0.4);
    EXPECT_GT(found.pictures, 50U);
  }
}

TEST(Lag, DoesNotDependOnTheNumberOfThreads) {
  const PatchDemonstration demonstration = late_answers(4, 4, 80);
  const FoundLag one = find_lag(demonstration, small_config(), Random(1), {});
  const FoundLag two = find_lag(demonstration, small_config(), Random(1),
                                {.jobs = 2, .scenario = {}, .stop = {}, .progress = {}});
  EXPECT_EQ(one.explained, two.explained);
  EXPECT_EQ(one.frames, two.frames);
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
  AffordanceConfig config = small_config();
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
  AffordanceConfig config = small_config();
  config.transactions.lag = "found";
  const Training found = train(demonstration, config, Random(1));
  ASSERT_TRUE(found.report.found.has_value());
  EXPECT_EQ(found.model.config.transactions.given_lag(), found.report.lag);
  config.transactions.lag = found.model.config.transactions.lag;
  const Training given = train(demonstration, config, Random(1));
  EXPECT_FALSE(given.report.found.has_value());
  EXPECT_EQ(to_bytes(given.model), to_bytes(found.model));
}

TEST(Lag, CannotBeFoundInOneEpisode) {
  EXPECT_THROW((void)find_lag(PatchDemonstration(1, 60, 1), small_config(), Random(1)), UsageError);
}

TEST(Lag, IsANumberOfSecondsOrFound) {
  TransactionConfig config;
  for (const char* good : {"0", "0.12", "0.8", "found"}) {
    config.lag = good;
    EXPECT_NO_THROW(config.validate()) << good;
  }
  for (const char* bad : {"", "-0.04", "0.81", "nan", "inf", "0.1 s", "find", " 0.1"}) {
    config.lag = bad;
    EXPECT_THROW(config.validate(), std::invalid_argument) << bad;
  }
}

}  // namespace
}  // namespace pacer::affordance
