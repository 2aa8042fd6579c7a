// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/train.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "tests/learning/exemplar/disc_world.h"

namespace pacer::exemplar {
namespace {

using testing::DiscDemonstration;
using testing::DiscStep;

TEST(ExemplarTraining, EveryImpulseBecomesAnExemplar) {
  const DiscDemonstration world = DiscDemonstration::any(3, 7, 5);
  const DemonstratedExemplars found = exemplars_of(world, {});
  ASSERT_EQ(found.exemplars.size(), 21U);
  EXPECT_EQ(found.first, (std::vector<std::size_t>{0, 7, 14}));
  EXPECT_EQ(found.report.frames, 3U * 7U * 13U);
  std::size_t n = 0;
  for (const std::vector<DiscStep>& episode : world.episodes()) {
    for (const DiscStep& step : episode) {
      const auto percept = found.exemplars.percept(n);
      const auto action = found.exemplars.action(n++);
      EXPECT_DOUBLE_EQ(action[0], step.command.steering);
      EXPECT_DOUBLE_EQ(action[1], step.command.throttle) << "as it is once it has risen";
      EXPECT_NEAR(percept[1], step.red ? step.red->x : 0.0, 1.0) << n;
      EXPECT_NEAR(percept[10], step.green ? step.green->x : 0.0, 1.0) << n;
      EXPECT_EQ(percept[0] == 0.0, !step.red.has_value());
    }
  }
}

TEST(ExemplarTraining, TheSameDemonstrationGivesTheSameModel) {
  const DiscDemonstration world = DiscDemonstration::any(2, 10, 6);
  const Training one = train(world, {});
  const Training other = train(world, {});
  EXPECT_EQ(to_bytes(one.model), to_bytes(other.model));
  EXPECT_EQ(one.report.exemplars, 20U);
  EXPECT_EQ(one.report.nodes, one.model.hierarchy.tree().nodes().size());
  EXPECT_EQ(one.model.image_size, testing::kDiscImage);
}

TEST(ExemplarTraining, AModelGrowsByATeachersCorrections) {
  const DiscDemonstration first = DiscDemonstration::any(2, 8, 7);
  const DiscDemonstration more = DiscDemonstration::any(1, 5, 8);
  const Training grown = grow(train(first, {}).model, more);
  EXPECT_EQ(grown.model.hierarchy.exemplars().size(), 21U);
  EXPECT_EQ(grown.report.exemplars, 5U) << "those that were added";
  const DemonstratedExemplars corrections = exemplars_of(more, {});
  Searcher searcher(grown.model.hierarchy);
  for (std::size_t n = 0; n < corrections.exemplars.size(); ++n) {
    const Found& found = searcher.find(corrections.exemplars.percept(n), 1e6);
    EXPECT_TRUE(found.exact) << n;
  }
}

TEST(ExemplarTraining, AGrownModelIsReadAsItWasWritten) {
  const Training grown =
      grow(train(DiscDemonstration::any(2, 8, 7), {}).model, DiscDemonstration::any(1, 5, 8));
  const Model read = from_bytes(to_bytes(grown.model), "grown");
  EXPECT_EQ(read.hierarchy.exemplars().size(), 21U);
  EXPECT_EQ(to_bytes(read), to_bytes(grown.model));
}

TEST(ExemplarTraining, WithoutImpulsesThereIsNothingToLearn) {
  DiscStep parked;
  EXPECT_THROW((void)train(DiscDemonstration({{parked, parked}}), {}), UsageError);
  EXPECT_THROW((void)train(DiscDemonstration({}), {}), UsageError);
}

TEST(ExemplarTraining, EndsWhenItIsAskedTo) {
  std::stop_source stop;
  stop.request_stop();
  TrainingOptions options;
  options.stop = stop.get_token();
  EXPECT_THROW((void)train(DiscDemonstration::any(1, 3, 1), {}, options), TrainingStopped);
}

}  // namespace
}  // namespace pacer::exemplar
