// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/train.h"

#include <gtest/gtest.h>

#include "core/check.h"
#include "learning/exemplar/search.h"
#include "tests/learning/exemplar/disc_world.h"

namespace pacer::exemplar {
namespace {

using testing::DiscDemonstration;
using testing::DiscStep;

/// The drift of a world's commands, worked out from them.
Eigen::Matrix2d drift_of(const DiscDemonstration& world) {
  std::vector<std::vector<Action>> episodes;
  for (const std::vector<DiscStep>& episode : world.episodes()) {
    episodes.emplace_back();
    for (const DiscStep& step : episode) {
      episodes.back().emplace_back(step.command.steering, step.command.throttle);
    }
  }
  return action_drift(episodes);
}

/// Says that its pictures have another size.
class OfAnotherSize final : public Demonstration {
 public:
  explicit OfAnotherSize(const DiscDemonstration& world) : world_(world) {}
  [[nodiscard]] std::size_t episode_count() const override { return world_.episode_count(); }
  [[nodiscard]] double frame_rate_hz() const override { return world_.frame_rate_hz(); }
  [[nodiscard]] ImageSize image_size() const override { return {.width = 320, .height = 240}; }
  [[nodiscard]] std::string fingerprint() const override { return world_.fingerprint(); }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override {
    return world_.open(episode);
  }

 private:
  const DiscDemonstration& world_;
};

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

TEST(ExemplarTraining, LeavesOutImpulsesWithInterferenceInThePicture) {
  std::vector<std::vector<DiscStep>> episodes = DiscDemonstration::any(2, 6, 9).episodes();
  episodes[0][0].snow = episodes[0][4].snow = episodes[1][5].snow = true;
  const DemonstratedExemplars found = exemplars_of(DiscDemonstration(episodes), {});
  EXPECT_EQ(found.report.disturbed, 3U);
  EXPECT_EQ(found.report.exemplars, 9U);
  EXPECT_EQ(found.first, (std::vector<std::size_t>{0, 4}));
  ASSERT_EQ(found.exemplars.size(), 9U);
  EXPECT_EQ(found.exemplars.action(0)[0], episodes[0][1].command.steering);
  EXPECT_EQ(found.exemplars.action(8)[0], episodes[1][4].command.steering);
}

TEST(ExemplarTraining, LooksAtPicturesAsAtThoseOfVideos) {
  DiscStep step;
  step.red = testing::Disc{.x = 60, .y = 40, .radius = 10};
  step.command = {.steering = 0.2, .throttle = 0.2};
  Frame frame;
  testing::paint(step, 0, frame);
  // A colour just too far from the disc's to be it in a plain picture: so is that of a video's.
  PerceptConfig config;
  int steps = 0;
  while (BalloonFinder(config).find(frame).red && ++steps < 100) {
    config.colours.red_balloon.green += 0.001;
  }
  ASSERT_LT(steps, 100);
  ASSERT_TRUE(BalloonFinder(of_videos(config)).find(frame).red);
  EXPECT_EQ(exemplars_of(DiscDemonstration({{step}}), config).report.red_seen, 1U);
}

TEST(ExemplarTraining, LearnsHowActionsChange) {
  const DiscDemonstration world = DiscDemonstration::any(3, 8, 7);
  EXPECT_LT((train(world, {}).model.drift - drift_of(world)).norm(), 1e-12);
}

TEST(ExemplarTraining, RefusesSettingsBeforeItReads) {
  const DiscDemonstration world = DiscDemonstration::any(1, 3, 1);
  TrainingOptions options;
  options.progress = [](std::string_view, double) { ADD_FAILURE() << "it has read"; };
  ExemplarConfig naming;
  naming.naming = "guess";
  EXPECT_THROW((void)train(world, naming, options), std::invalid_argument);
  ExemplarConfig hierarchy;
  hierarchy.hierarchy.tau = -1.0;
  EXPECT_THROW((void)train(world, hierarchy, options), std::invalid_argument);
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

TEST(ExemplarTraining, AGrownModelIsReadAsTheOneOfAllExemplars) {
  const Training first = train(DiscDemonstration::any(2, 8, 7), {});
  const Training grown = grow(first.model, DiscDemonstration::any(1, 5, 8));
  const Model read = from_bytes(to_bytes(grown.model), "grown");
  // In memory it has the units and the prior it had.
  EXPECT_EQ(grown.model.hierarchy.prior().scale.mean, first.model.hierarchy.prior().scale.mean);
  EXPECT_EQ(grown.model.hierarchy.prior().covariance, first.model.hierarchy.prior().covariance);
  // Read, it has those of all.
  const Hierarchy all(grown.model.hierarchy.exemplars(), {});
  EXPECT_EQ(read.hierarchy.prior().scale.mean, all.prior().scale.mean);
  EXPECT_EQ(read.hierarchy.prior().covariance, all.prior().covariance);
  EXPECT_NE(read.hierarchy.prior().covariance, grown.model.hierarchy.prior().covariance);
  // Whichever: what was learnt is recalled.
  for (const Hierarchy* one : {&grown.model.hierarchy, &read.hierarchy}) {
    Searcher searcher(*one);
    for (std::size_t n = 0; n < all.exemplars().size(); ++n) {
      EXPECT_TRUE(searcher.find(all.exemplars().percept(n), 1e6).exact);
    }
  }
}

TEST(ExemplarTraining, GrowsInHowActionsChange) {
  const DiscDemonstration first = DiscDemonstration::any(2, 8, 7);
  const DiscDemonstration more = DiscDemonstration::any(1, 5, 8);
  const Model model = train(first, {}).model;
  const Eigen::Matrix2d expected = (16.0 * drift_of(first) + 5.0 * drift_of(more)) / 21.0;
  EXPECT_LT((grow(model, more).model.drift - expected).norm(), 1e-12);
  EXPECT_GT((expected - drift_of(first)).norm(), 1e-3);
  // Single impulses tell of no change.
  EXPECT_EQ(grow(model, DiscDemonstration::any(3, 1, 8)).model.drift, model.drift);
}

TEST(ExemplarTraining, GrowsByPicturesOfItsSizeOnly) {
  const DiscDemonstration world = DiscDemonstration::any(1, 5, 8);
  const Model model = train(world, {}).model;
  EXPECT_NO_THROW((void)grow(model, world));
  EXPECT_THROW((void)grow(model, OfAnotherSize(world)), UsageError);
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
