// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <opencv2/core/utility.hpp>
#include <sstream>

#include "core/check.h"
#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/supervised_model.h"
#include "learning/baselines/tracker_model.h"
#include "tests/learning/baselines/marked_patch_world.h"

namespace pacer::baselines {
namespace {

using pacer::testing::MarkedPatchDemonstration;
using pacer::testing::PatchPainter;
using pacer::testing::PatchPointer;
using pacer::testing::PatchStep;
using pacer::testing::wander;

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    x += a[i];
    y += b[i];
    xx += a[i] * a[i];
    yy += b[i] * b[i];
    xy += a[i] * b[i];
  }
  return (xy - x * y / n) / std::sqrt((xx - x * x / n) * (yy - y * y / n));
}

/// How the policy's turn goes with the teacher's, along an unseen wandering before an unseen
/// background.
double turn_on_unseen(const PolicyModel& model) {
  const std::vector<PatchStep> steps = wander(150, Random(999));
  std::unique_ptr<TargetPointer> pointer;
  if (model.given_boxes() == GivenBoxes::kAtTheStart) {
    pointer = std::make_unique<PatchPointer>(steps.front());
  }
  const std::unique_ptr<Policy> policy = model.make(Random(1), std::move(pointer));
  const PatchPainter painter(1000);
  std::vector<double> wanted;
  std::vector<double> taught;
  Frame frame;
  Annotations annotations;
  std::uint64_t index = 0;
  for (const PatchStep& step : steps) {
    painter.paint(step, index++, frame);
    annotations.clear();
    wanted.push_back(policy->act({.frame = frame, .last = {}}, annotations).steering);
    taught.push_back(step.command.steering);
  }
  return correlation(wanted, taught);
}

TrainingOptions on(int jobs) {
  cv::setNumThreads(1);
  TrainingOptions options;
  options.jobs = jobs;
  options.scenario = "a scenario";
  return options;
}

const MarkedPatchDemonstration& world() {
  static const MarkedPatchDemonstration demonstration =
      MarkedPatchDemonstration::wandering(6, 150, 1);
  return demonstration;
}

/// Each way to learn, behind one interface: the bytes, and the model.
struct Learnt {
  std::string bytes;
  std::shared_ptr<const PolicyModel> model;
  TrainingReport report;
};

template <class Model, class Adaptor>
Learnt learnt(Model model, const TrainingReport& report) {
  std::string bytes = to_bytes(model);
  return {.bytes = std::move(bytes),
          .model = std::make_shared<const Adaptor>(std::make_shared<const Model>(std::move(model))),
          .report = report};
}

Learnt learn(const std::string& method, const MarkedDemonstration& from, int jobs) {
  TrainingReport report;
  const Random random = Random(3).fork("train");
  if (method == "nearest") {
    auto model = train_nearest(from, on(jobs), report);
    return learnt<NearestModel, NearestPolicyModel>(std::move(model), report);
  }
  if (method == "supervised") {
    auto model = train_supervised(from, {}, random, on(jobs), report);
    return learnt<SupervisedModel, SupervisedPolicyModel>(std::move(model), report);
  }
  if (method == "tracker") {
    auto model = train_tracker(from, {}, random, on(jobs), report);
    return learnt<TrackerModel, TrackerPolicyModel>(std::move(model), report);
  }
  const PictureKind kind = method == "ridge" ? PictureKind::kGrey : PictureKind::kHog;
  auto model = train_ridge(from, kind, on(jobs), report);
  return learnt<RidgeModel, RidgePolicyModel>(std::move(model), report);
}

/// All but the supervised one, which takes some seconds to learn.
class QuickBaseline : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(OfMethods, QuickBaseline,
                         ::testing::Values("nearest", "ridge", "ridge-hog", "tracker"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(QuickBaseline, LearnsTheSameBytesOnAnyNumberOfThreads) {
  const Learnt one = learn(GetParam(), world(), 1);
  const Learnt two = learn(GetParam(), world(), 2);
  EXPECT_TRUE(one.bytes == two.bytes);
  EXPECT_EQ(one.report.frames, 900U);
  EXPECT_EQ(one.report.episodes, 6U);
  EXPECT_EQ(one.model->method(), GetParam());
}

TEST_P(QuickBaseline, KeepsWhatItWasLearntFrom) {
  const Learnt one = learn(GetParam(), world(), 2);
  double steering = 0.0;
  for (const auto& episode : world().episodes()) {
    for (const PatchStep& step : episode) steering += step.command.steering / 900.0;
  }
  EXPECT_NEAR(one.model->mean_command().steering, steering, 1e-12);
  EXPECT_NE(one.bytes.find("patch world"), std::string::npos) << "the fingerprint";
  EXPECT_NE(one.bytes.find("a scenario"), std::string::npos);
}

TEST_P(QuickBaseline, RefusesADemonstrationOfNothing) {
  EXPECT_THROW((void)learn(GetParam(), MarkedPatchDemonstration({}), 1), UsageError);
  EXPECT_THROW((void)learn(GetParam(), MarkedPatchDemonstration({{}, {}}), 1), UsageError);
  std::vector<std::vector<PatchStep>> one_action = {wander(60, Random(1)), wander(60, Random(2))};
  for (auto& episode : one_action) {
    for (PatchStep& step : episode) step.command = {.steering = 0.1, .throttle = 0.2};
  }
  EXPECT_THROW((void)learn(GetParam(), MarkedPatchDemonstration(one_action), 1), UsageError);
}

class ChosenBaseline : public ::testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(OfMethods, ChosenBaseline,
                         ::testing::Values("nearest", "ridge", "ridge-hog"), [](const auto& test) {
                           std::string name = test.param;
                           std::erase(name, '-');
                           return name;
                         });

TEST_P(ChosenBaseline, HasTheSettingWithTheLeastErrorHeldOut) {
  const TrainingReport report = learn(GetParam(), world(), 2).report;
  ASSERT_GT(report.trials.size(), 8U);
  for (const Trial& trial : report.trials) {
    EXPECT_TRUE(std::isfinite(trial.error)) << trial.setting;
    EXPECT_GE(trial.error, report.trials[report.chosen].error) << trial.setting;
  }
  EXPECT_EQ(report.marked, 0U) << "none of these is given boxes";
}

/// Where nothing but the patch moves, a picture tells the command: measured are 0.18, 0.11 and
/// 0.03.
TEST_P(ChosenBaseline, PredictsWhatItDidNotSeeBeforeABackgroundThatStands) {
  std::vector<PatchStep> steps = wander(400, Random(1));
  for (PatchStep& step : steps) step.pan = 0.0;
  const TrainingReport report = learn(GetParam(), MarkedPatchDemonstration({steps}), 2).report;
  EXPECT_LT(report.trials[report.chosen].error, 0.3) << "of the commands' variance";
}

TEST(Nearest, OfOneNeighbourAnswersADemonstratedFrameWithItsOwnCommand) {
  TrainingReport report;
  NearestModel model = train_nearest(world(), on(2), report);
  model.neighbours = 1;
  NearestPolicy policy(std::make_shared<const NearestModel>(std::move(model)));
  Annotations annotations;
  for (std::size_t e = 0; e < world().episode_count(); ++e) {
    const auto stream = world().open(e);
    while (const DemonstratedStep* step = stream->next()) {
      EXPECT_EQ(policy.act({.frame = *step->frame, .last = {}}, annotations), step->command);
    }
  }
}

TEST(Nearest, ChoosesFromThePicturesThatItKeeps) {
  TrainingReport report;
  std::vector<double> told;
  TrainingOptions options = on(2);
  options.progress = [&](std::string_view stage, double share) {
    if (stage == "choosing") told.push_back(share);
  };
  const NearestModel model = train_nearest(world(), options, report, 100);
  EXPECT_EQ(model.commands.size(), 100U) << "every ninth of 900";
  EXPECT_EQ(model.pictures.size(), 100U);
  EXPECT_EQ(report.frames, 900U);
  EXPECT_EQ(told, (std::vector<double>{0.25, 0.5, 0.75, 1.0}));
  TrainingReport whole;
  (void)train_nearest(world(), on(2), whole);
  EXPECT_GT(report.trials[report.chosen].error, whole.trials[whole.chosen].error);
  TrainingReport threaded;
  EXPECT_EQ(to_bytes(train_nearest(world(), on(1), threaded, 100)), to_bytes(model));
}

TEST(TrackerBaseline, TurnsAsTheTeacherDoesOnAnUnseenWandering) {
  EXPECT_GT(turn_on_unseen(*learn("tracker", world(), 2).model), 0.95);
}

TEST(TrackerBaseline, NamesTheTrackerThatItsMapIsFittedTo) {
  TrainingReport report;
  TrackerModel model = train_tracker(world(), {}, Random(1), on(2), report);
  EXPECT_EQ(model.tracker, tracking::trackers().front().name);
  model.tracker = "LK";
  EXPECT_EQ(tracker_from_bytes(to_bytes(model), "the.model").tracker, "LK");
  model.tracker = "nobody's";
  EXPECT_THROW((void)tracker_from_bytes(to_bytes(model), "the.model"), std::runtime_error);
}

TEST(TrackerBaseline, TakesMarksOfNextToNothingForNone) {
  std::vector<std::vector<PatchStep>> episodes = {wander(60, Random(1)), wander(60, Random(2))};
  for (auto& episode : episodes) {
    for (std::size_t i = 0; i < 15; ++i) episode[i].side = i < 5 ? 0.5 : 11.0;
  }
  const TrainingReport report = learn("tracker", MarkedPatchDemonstration(episodes), 1).report;
  EXPECT_EQ(report.marked, 90U);
}

TEST(TrackerBaseline, IsShownItsTargetOnceAndWaitsForIt) {
  class Late final : public TargetPointer {
   public:
    explicit Late(int& asked) : asked_(asked) {}
    std::optional<Box> point() override {
      if (++asked_ < 3) return std::nullopt;
      return Box{.x = 80, .y = 60, .width = 40, .height = 40};
    }

   private:
    int& asked_;
  };
  const auto model = learn("tracker", world(), 2).model;
  int asked = 0;
  const auto policy = model->make(Random(1), std::make_unique<Late>(asked));
  const PatchPainter painter(1000);
  Frame frame;
  std::vector<std::string> labels;
  for (std::uint64_t i = 0; i < 8; ++i) {
    PatchStep step;
    step.x = 80;
    step.y = 60;
    step.side = 40;
    painter.paint(step, i, frame);
    Annotations annotations;
    (void)policy->act({.frame = frame, .last = {}}, annotations);
    labels.push_back(annotations.label);
  }
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(labels[0], "lost: stop");
  EXPECT_EQ(labels[1], "lost: stop");
  for (std::size_t i = 2; i < labels.size(); ++i) EXPECT_EQ(labels[i], "") << i;
}

/// Of one training, which takes some seconds.
class SupervisedBaseline : public ::testing::Test {
 protected:
  static const MarkedPatchDemonstration& little() {
    static const MarkedPatchDemonstration demonstration =
        MarkedPatchDemonstration::wandering(2, 30, 1);
    return demonstration;
  }
  static const Learnt& learnt() {
    static const Learnt one = learn("supervised", little(), 1);
    return one;
  }
};

TEST_F(SupervisedBaseline, TurnsAsTheTeacherDoesOnAnUnseenWandering) {
  EXPECT_GT(turn_on_unseen(*learnt().model), 0.8);
  EXPECT_EQ(learnt().report.marked, 60U);
}

TEST_F(SupervisedBaseline, LearnsTheSameBytesAgainAndPrintsNothing) {
  std::ostringstream said;
  std::streambuf* const old = std::cerr.rdbuf(said.rdbuf());
  const std::ios::fmtflags flags = std::cerr.flags();
  const std::streamsize precision = std::cerr.precision();
  const std::streamsize width = std::cerr.width();
  const Learnt again = learn("supervised", little(), 2);
  EXPECT_EQ(std::cerr.flags(), flags);
  EXPECT_EQ(std::cerr.precision(), precision);
  EXPECT_EQ(std::cerr.width(), width);
  std::cerr << "heard";
  std::cerr.rdbuf(old);
  EXPECT_TRUE(again.bytes == learnt().bytes);
  EXPECT_EQ(said.str(), "heard") << "nothing of the training, and all after it";
}

TEST_F(SupervisedBaseline, StopsBeforeTheDetectorIsTrained) {
  std::stop_source source;
  TrainingOptions options = on(1);
  options.stop = source.get_token();
  options.progress = [&](std::string_view stage, double) {
    EXPECT_NE(stage, "detections");
    if (stage == "detector") source.request_stop();
  };
  TrainingReport report;
  EXPECT_THROW((void)train_supervised(little(), {}, Random(1), options, report), TrainingStopped);
}

TEST_F(SupervisedBaseline, RefusesADemonstrationWithoutTheTarget) {
  std::vector<std::vector<PatchStep>> hidden = {wander(60, Random(1)), wander(60, Random(2))};
  for (auto& episode : hidden) {
    for (PatchStep& step : episode) step.visible = false;
  }
  EXPECT_THROW((void)learn("supervised", MarkedPatchDemonstration(hidden), 1), UsageError);
  EXPECT_THROW((void)learn("tracker", MarkedPatchDemonstration(hidden), 1), UsageError);
}

}  // namespace
}  // namespace pacer::baselines
