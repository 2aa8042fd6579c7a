// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/train.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "core/check.h"
#include "learning/affordance/policy.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::affordance {
namespace {

using pacer::testing::PatchDemonstration;
using pacer::testing::PatchPainter;
using pacer::testing::PatchStep;

/// Quick settings for the small world of tests.
AffordanceConfig small_config() {
  AffordanceConfig config;
  config.words.samples = 4000;
  config.words.iterations = 10;
  config.features.top = 0.25;
  config.features.max_size = 8.0;
  config.transactions.wanted = 12000;
  config.transactions.common_item_percent = 100.0;  // a picture with little in it
  config.mining.support_percent = 0.1;
  config.mining.max_items = 4;
  config.selection.max_rules = 200;
  config.transactions.stretch = Seconds{0.5};
  return config;
}

const Training& trained() {
  // As the application has it; and the thread sanitizer cannot see into OpenCV's own threads.
  cv::setNumThreads(1);
  static const Training training =
      train(PatchDemonstration(6, 100, 5), small_config(), Random(1), {});
  return training;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double ma = 0.0, mb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ma += a[i] / n;
    mb += b[i] / n;
  }
  double ab = 0.0, aa = 0.0, bb = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    ab += (a[i] - ma) * (b[i] - mb);
    aa += (a[i] - ma) * (a[i] - ma);
    bb += (b[i] - mb) * (b[i] - mb);
  }
  return ab / std::sqrt(aa * bb);
}

struct Unseen {
  std::vector<double> turn, taught_turn, drive, taught_drive;
  int hits = 0, rules = 0, matched = 0, frames = 0;
};

/// Drives along an unseen wandering before an unseen background, without acting on it.
Unseen respond_to_unseen(const Model& model) {
  Unseen unseen;
  const std::shared_ptr<const Model> shared(&model, [](const Model*) {});
  AffordancePolicy policy(shared);
  Perception perception(model);
  const PatchPainter painter(1000);
  Frame frame;
  std::uint64_t index = 0;
  for (const PatchStep& step : pacer::testing::wander(150, Random(999))) {
    painter.paint(step, index++, frame);
    Annotations annotations;
    const Command command = policy.act({frame, {}}, annotations);
    ++unseen.frames;
    if (policy.configurations() == 0) continue;
    ++unseen.matched;
    unseen.turn.push_back(command.steering);
    unseen.drive.push_back(command.throttle);
    unseen.taught_turn.push_back(step.command.steering);
    unseen.taught_drive.push_back(step.command.throttle);
    perception.look(frame);
    for (const MatchedRule& rule : matched_rules(model, perception)) {
      const BoxMark box = step.box();
      std::size_t inside = 0;
      for (const PixelPoint& point : rule.points) {
        inside += point.x >= box.low.x && point.x <= box.high.x && point.y >= box.low.y &&
                  point.y <= box.high.y;
      }
      unseen.hits += 2 * inside >= rule.points.size() ? 1 : 0;
      ++unseen.rules;
    }
  }
  return unseen;
}

TEST(Train, TheActionIsTheTeachersOnUnseenPictures) {
  const Unseen unseen = respond_to_unseen(trained().model);
  EXPECT_GT(unseen.matched, unseen.frames * 8 / 10);
  EXPECT_GT(correlation(unseen.turn, unseen.taught_turn), 0.7);
  EXPECT_GT(correlation(unseen.drive, unseen.taught_drive), 0.5);
}

TEST(Train, RulesLieOnTheLeadWithoutBeingToldOfIt) {
  const Unseen unseen = respond_to_unseen(trained().model);
  ASSERT_GT(unseen.rules, 100);
  EXPECT_GT(static_cast<double>(unseen.hits), 0.7 * unseen.rules);
}

/// The small world has few rules, four of which agree in most frames: asked for two or three of
/// them, the policy knows the patch from the background that a single rule would have it act on.
TEST(Train, EvidenceTellsThePatchFromItsBackground) {
  const auto acted = [](double caution, bool visible) {
    auto model = std::make_shared<Model>(trained().model);
    model->config.response.evidence.caution = caution;
    model->config.response.evidence.keep = 0.5;
    AffordancePolicy policy(model);
    const PatchPainter painter(1001);
    Annotations annotations;
    Frame frame;
    std::uint64_t index = 0;
    int count = 0;
    for (PatchStep step : pacer::testing::wander(150, Random(77))) {
      step.visible = visible;
      painter.paint(step, index++, frame);
      (void)policy.act({frame, {}}, annotations);
      count += policy.configurations() > 0 ? 1 : 0;
    }
    return count;
  };
  constexpr double kCaution = 0.6;
  EXPECT_GT(trained().model.typical_witnesses, 3.0);
  const int careless = acted(0.0, false);
  EXPECT_GT(careless, 5) << "the background matches nothing: no test";
  EXPECT_LT(acted(kCaution, false), careless / 3);
  EXPECT_GT(acted(kCaution, true), 75);
}

TEST(Train, TheReportAddsUp) {
  const auto& [model, report] = trained();
  EXPECT_EQ(report.frames, 600U);
  EXPECT_LE(report.frames_counted, report.frames);
  std::uint64_t frames = 0, transactions = 0, kept = 0;
  for (const TrainingReport::Type& type : report.types) {
    frames += type.frames;
    transactions += type.transactions;
    kept += type.kept;
    EXPECT_LE(type.kept, type.selected);
    EXPECT_LE(type.selected, type.mined);
  }
  EXPECT_EQ(frames, report.frames_counted);
  EXPECT_EQ(transactions, report.transactions);
  EXPECT_EQ(kept, model.rules.size());
  EXPECT_LE(report.frames_matched, report.frames_counted);
}

TEST(Train, TwoThreadsLearnTheSameModelAsOne) {
  const PatchDemonstration demonstration(3, 40, 6);
  AffordanceConfig config = small_config();
  config.mining.min_stretches = 2;
  const std::string one = to_bytes(train(demonstration, config, Random(1), {}).model);
  double share = 0.0;
  const TrainingOptions two{
      .jobs = 2, .scenario = {}, .stop = {}, .progress = [&](auto, double s) { share = s; }};
  EXPECT_EQ(to_bytes(train(demonstration, config, Random(1), two).model), one);
  EXPECT_EQ(share, 1.0);
  EXPECT_NE(to_bytes(train(demonstration, config, Random(2), two).model), one);
}

/// One episode of `frames` steps that `change` has seen.
template <class Change>
PatchDemonstration changed(int frames, const Change& change) {
  std::vector<PatchStep> steps = pacer::testing::wander(frames, Random(3));
  for (PatchStep& step : steps) change(step);
  return PatchDemonstration({std::move(steps)});
}

TEST(Train, RefusesADemonstrationOfOneAction) {
  const auto still = changed(20, [](PatchStep& step) { step.command = {0.1, 0.2}; });
  EXPECT_THROW((void)train(still, small_config(), Random(1), {}), UsageError);
}

TEST(Train, RefusesADemonstrationWithoutFrames) {
  EXPECT_THROW((void)train(PatchDemonstration(std::vector<std::vector<PatchStep>>(1)),
                           small_config(), Random(1), {}),
               UsageError);
}

TEST(Train, RefusesADemonstrationTooShortForAnyRule) {
  const auto ten = changed(10, [](PatchStep&) {});
  EXPECT_THROW((void)train(ten, small_config(), Random(1), {}), NothingLearnt);
}

TEST(Train, LearnsFromNoMoreFramesHoweverLongTheRecording) {
  AffordanceConfig config = small_config();
  config.transactions.most_frames = 90;
  std::vector<double> features;
  for (const int frames : {60, 180}) {
    const auto [model, report] = train(PatchDemonstration(3, frames, 6), config, Random(1), {});
    EXPECT_EQ(report.frames, 3U * static_cast<unsigned>(frames));
    EXPECT_GT(report.frames_counted, 100U);
    EXPECT_EQ(report.frames_learnt, 90U);
    EXPECT_EQ(model.frames_learnt, 90U);
    EXPECT_LE(report.frames_matched, 90U);
    std::uint64_t of_types = 0;
    for (const TrainingReport::Type& type : report.types) of_types += type.frames;
    EXPECT_EQ(of_types, 90U);
    features.push_back(static_cast<double>(report.features));
  }
  EXPECT_NEAR(features[1], features[0], 0.2 * features[0]) << "as many pictures, as much in each";
}

TEST(Train, MinesAsManyRulesAsAreWantedWhateverTheSupport) {
  const PatchDemonstration demonstration(3, 60, 6);
  AffordanceConfig config = small_config();
  config.mining.wanted_rules = 40;
  std::string bytes;
  for (const double support : {0.01, 5.0}) {
    config.mining.support_percent = support;
    const auto [model, report] = train(demonstration, config, Random(1), {});
    int full = 0;
    for (const TrainingReport::Type& type : report.types) {
      EXPECT_LE(type.mined, 40U);
      EXPECT_GT(type.support_percent, 0.0);
      EXPECT_EQ(type.capped, "") << "what was asked for is no cap";
      full += type.mined > 20 ? 1 : 0;
    }
    // In a world so small many rules have the same support, and come or stay away together.
    EXPECT_GE(full, 1);
    Model same = model;
    same.config.mining.support_percent = 1.0;
    if (bytes.empty()) bytes = to_bytes(same);
    EXPECT_EQ(to_bytes(same), bytes);
  }
}

TEST(Train, LearnsFromFeaturesOfOtherKindsAndMixedOnes) {
  for (const std::vector<std::string>& kinds :
       {std::vector<std::string>{"akaze"}, {"sift", "blob"}}) {
    AffordanceConfig config = small_config();
    config.features.kinds = kinds;
    config.words.descriptor = 30;
    const Training training = train(PatchDemonstration(4, 80, 5), config, Random(1), {});
    const Model model = from_bytes(to_bytes(training.model), "the.model");
    EXPECT_EQ(model.config.features.kinds, kinds);
    const Unseen unseen = respond_to_unseen(model);
    EXPECT_GT(unseen.matched, unseen.frames / 2) << kinds.back();
    EXPECT_GT(correlation(unseen.turn, unseen.taught_turn), 0.5) << kinds.back();
  }
}

/// As many episodes as of the small world, in which the patch is nowhere and the teacher drives as
/// if it were somewhere. Within a second such a drive is as good as any: what is in view goes by.
TEST(Train, WhatIsLearntWithoutATargetIsSaidToBeLittle) {
  std::vector<std::vector<PatchStep>> episodes;
  for (std::uint64_t e = 0; e < 6; ++e) {
    episodes.push_back(pacer::testing::wander(100, Random(5).fork("episode", e)));
    for (PatchStep& step : episodes.back()) step.visible = false;
  }
  AffordanceConfig config = small_config();
  config.transactions.stretch = Seconds{2.0};
  const Training training = train(PatchDemonstration(std::move(episodes)), config, Random(1), {});
  EXPECT_TRUE(training.report.knowledge.little()) << to_text(training.report.knowledge);
  EXPECT_FALSE(trained().report.knowledge.little()) << to_text(trained().report.knowledge);
}

TEST(Train, EndsWhenAStopIsRequested) {
  std::stop_source stop;
  stop.request_stop();
  const TrainingOptions options{
      .jobs = 1, .scenario = {}, .stop = stop.get_token(), .progress = {}};
  EXPECT_THROW((void)train(PatchDemonstration(1, 10, 1), small_config(), Random(1), options),
               TrainingStopped);
}

TEST(Train, APolicyHoldsItsLastActionOnlyAsLongAsItIsTold) {
  const auto model = std::make_shared<const Model>(trained().model);
  AffordancePolicy policy(model);
  const PatchPainter painter(2);
  Frame frame;
  Command last;
  std::uint64_t index = 0;
  Annotations annotations;
  for (const PatchStep& step : pacer::testing::wander(20, Random(31))) {
    painter.paint(step, index++, frame);
    annotations.clear();
    last = policy.act({frame, {}}, annotations);
  }
  ASSERT_GT(policy.configurations(), 0);
  EXPECT_FALSE(annotations.points.empty());
  EXPECT_EQ(annotations.boxes.size(), 1U);
  const Seconds seen = frame.time;
  frame.rgb.assign(frame.rgb.size(), 90);
  for (const double later : {0.1, 0.39, 0.41, 3.0}) {
    frame.time = seen + Seconds{later};
    const Command command = policy.act({frame, {}}, annotations);
    EXPECT_EQ(command, later < 0.4 ? last : Command{}) << later;
  }
}

}  // namespace
}  // namespace pacer::affordance
