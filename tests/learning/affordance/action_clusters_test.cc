// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/action_clusters.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace pacer::affordance {
namespace {

/// Six clouds of commands, as in Figure 6.8.
std::vector<Command> six_kinds() {
  Random random(1);
  std::vector<Command> commands;
  for (int i = 0; i < 1200; ++i) {
    const double turn = 0.6 * (i % 3 - 1);
    const double drive = i % 2 == 0 ? 0.1 : 0.35;
    commands.push_back({turn + random.normal(0.0, 0.04), drive + random.normal(0.0, 0.015)});
  }
  return commands;
}

TEST(ActionClusters, NamesTheSixTypesOfTable61) {
  const ActionClusters clusters = cluster_actions(six_kinds(), {.types = 6}, Random(2));
  const std::vector<std::string> names = {"slow-left",     "fast-left",  "slow-straight",
                                          "fast-straight", "slow-right", "fast-right"};
  EXPECT_EQ(clusters.names, names);
  EXPECT_EQ(clusters.names[clusters.assign({0.6, 0.1})], "slow-left");
  EXPECT_EQ(clusters.names[clusters.assign({-0.6, 0.35})], "fast-right");
}

TEST(ActionClusters, WhitenedCommandsHaveUnitCovariance) {
  Random random(3);
  std::vector<Command> commands;
  for (int i = 0; i < 4000; ++i) {
    const double common = random.normal(0.0, 0.2);
    commands.push_back({common + random.normal(0.0, 0.05), 0.3 + 0.5 * common});
  }
  const ActionClusters clusters = cluster_actions(commands, {.types = 6}, Random(4));
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();
  for (const Command& command : commands) {
    const Eigen::Vector2d whitened =
        clusters.whiten * (Eigen::Vector2d(command.steering, command.throttle) - clusters.mean);
    covariance += whitened * whitened.transpose() / static_cast<double>(commands.size());
  }
  EXPECT_TRUE(covariance.isApprox(Eigen::Matrix2d::Identity(), 1e-9)) << covariance;
}

TEST(ActionClusters, EveryCentreIsOfItsOwnType) {
  const ActionClusters clusters = cluster_actions(six_kinds(), {.types = 6}, Random(2));
  for (int type = 0; type < clusters.count(); ++type) {
    const auto own = static_cast<ActionType>(type);
    EXPECT_EQ(clusters.assign(clusters.centre(own)), own);
  }
}

TEST(ActionClusters, OneCommandIsOneType) {
  const std::vector<Command> commands(50, Command{0.2, 0.3});
  const ActionClusters clusters = cluster_actions(commands, {.types = 6}, Random(5));
  EXPECT_EQ(clusters.count(), 1);
  EXPECT_NEAR(clusters.centre(0).steering, 0.2, 1e-6);
}

TEST(ActionClusters, NamesAreDistinctHoweverTheCentresLie) {
  Random random(6);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Command> centres(2 + random.below(12));
    for (Command& centre : centres) {
      centre = {random.uniform(-1.0, 1.0), random.chance(0.3) ? 0.0 : random.uniform(0.0, 1.0)};
    }
    const std::vector<std::string> names = action_names(centres);
    EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), centres.size());
  }
}

TEST(ActionClusters, AHandThatTremblesDoesOneThing) {
  Random random(5);
  std::vector<Command> commands;
  for (int i = 0; i < 300; ++i) {
    commands.push_back({0.3 + random.uniform(-0.006, 0.006), 0.2 + random.uniform(-0.006, 0.006)});
  }
  EXPECT_TRUE(cluster_actions(commands, {}, Random(1)).one_action());
  EXPECT_TRUE(cluster_actions({commands.data(), 1}, {}, Random(1)).one_action());
  for (std::size_t i = 0; i < 100; ++i) commands[i].throttle += 0.05;
  EXPECT_FALSE(cluster_actions(commands, {}, Random(1)).one_action());
}

}  // namespace
}  // namespace pacer::affordance
