// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/train.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/check.h"
#include "learning/affordance/policy.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::affordance {
namespace {

using pacer::testing::kPatchRate;
using pacer::testing::PatchDemonstration;
using pacer::testing::PatchPainter;
using pacer::testing::PatchStep;

/// Quick settings for the small world of tests.
AffordanceConfig small_config() {
  AffordanceConfig config;
  config.words.samples = 4000;
  config.words.iterations = 10;
  config.transactions.wanted = 12000;
  config.mining.support_percent = 0.1;
  config.mining.max_items = 4;
  config.selection.max_rules = 200;
  config.transactions.stretch = Seconds{0.5};
  return config;
}

const Training& trained() {
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

TEST(Train, TheTurnIsTheTeachersOnUnseenPictures) {
  const Unseen unseen = respond_to_unseen(trained().model);
  EXPECT_GT(unseen.matched, unseen.frames * 8 / 10);
  EXPECT_GT(correlation(unseen.turn, unseen.taught_turn), 0.7);
}

}  // namespace
}  // namespace pacer::affordance
