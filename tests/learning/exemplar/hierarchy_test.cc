// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "learning/exemplar/search.h"
#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

using pacer::testing::random_exemplars;

TEST(Hierarchy, HasTheActionsOfEachNodeAsItsModel) {
  const Hierarchy hierarchy(random_exemplars(60, 5, 2, Random(1), 9), {});
  for (NodeId node = 0; node < hierarchy.tree().nodes().size(); ++node) {
    const auto members = hierarchy.tree().exemplars_of(node);
    EXPECT_EQ(hierarchy.has_model(node), members.size() > 1);
    if (members.size() < 2) continue;
    std::vector<double> rows;
    for (const std::uint32_t n : members) {
      const auto action = hierarchy.exemplars().action(n);
      rows.insert(rows.end(), action.begin(), action.end());
    }
    const Gaussian expected = fit_gaussian(rows, 2);
    const Gaussian model = hierarchy.action_model(node);
    EXPECT_LT((model.mean - expected.mean).norm(), 1e-12);
    EXPECT_LT((model.covariance - expected.covariance).norm(), 1e-12);
  }
}

TEST(Hierarchy, RegularisesThePerceptsOfEachNodeAsDocumented) {
  const Hierarchy hierarchy(random_exemplars(60, 5, 2, Random(2)), {});
  const double w = hierarchy.config().prior_weight;
  Eigen::MatrixXd sd = Eigen::MatrixXd::Zero(5, 5);
  for (Eigen::Index i = 0; i < 5; ++i) {
    sd(i, i) = 1.0 / hierarchy.prior().scale.inverse_sd[static_cast<std::size_t>(i)];
  }
  const Eigen::MatrixXd prior = sd * hierarchy.prior().covariance * sd;
  for (NodeId node = 0; node < hierarchy.tree().nodes().size(); ++node) {
    if (!hierarchy.has_model(node)) continue;
    std::vector<double> rows;
    for (const std::uint32_t n : hierarchy.tree().exemplars_of(node)) {
      const auto percept = hierarchy.exemplars().percept(n);
      rows.insert(rows.end(), percept.begin(), percept.end());
    }
    const double n = static_cast<double>(rows.size()) / 5.0;
    const Gaussian plain = fit_gaussian(rows, 5);
    const Gaussian model = hierarchy.percept_model(node);
    const Eigen::MatrixXd expected = (n * plain.covariance + w * prior) / (n + w);
    EXPECT_LT((model.mean - plain.mean).norm(), 1e-6);
    EXPECT_LT((model.covariance - expected).norm(), 1e-9 * expected.norm());

    std::vector<float> point(hierarchy.layout().padded());
    std::vector<float> scratch(hierarchy.layout().padded());
    hierarchy.standardise(hierarchy.exemplars().percept(7), point);
    const Eigen::Map<const Eigen::VectorXd> raw(hierarchy.exemplars().percept(7).data(), 5);
    EXPECT_NEAR(std::sqrt(hierarchy.squared_distance(
                    node, point.data(), std::numeric_limits<float>::infinity(), scratch.data())),
                model.distance(raw), 1e-3 * model.distance(raw) + 1e-3);
    EXPECT_NEAR(hierarchy.distance(node, hierarchy.exemplars().percept(7)), model.distance(raw),
                1e-9 * (1.0 + model.distance(raw)));
  }
}

TEST(Hierarchy, HasThePriorThatIsWorkedOutByHand) {
  // The mean is (0, 0), the variances are (0.5 * 0.01 + 0.5 * 9, 0.5 + 0.5 * 4): two pairs of
  // similar actions, whose percepts differ by (0.2, 2) and by (6, -4) in all.
  const Exemplars four(2, 1, {0.1, 1, -0.1, -1, 3, -2, -3, 2}, {0.0, 0.1, 0.9, 1.0});
  const HierarchyConfig config{.prior_scale = 0.5, .prior_floor = 0.2, .prior_group = 2};
  const PerceptPrior prior = Hierarchy(four, config).prior();
  const double vx = 4.505;
  const double vy = 2.5;
  EXPECT_NEAR(prior.scale.inverse_sd[0], 1.0 / std::sqrt(vx), 1e-12);
  EXPECT_NEAR(prior.scale.inverse_sd[1], 1.0 / std::sqrt(vy), 1e-12);
  // Scatter about each pair's mean: 2 (0.01, 0.1, 1) + 2 (9, -6, 4), of 4 - 2 degrees of freedom.
  const double xx = 9.01 / vx;
  const double xy = -5.9 / std::sqrt(vx * vy);
  const double yy = 5.0 / vy;
  EXPECT_NEAR(prior.covariance(0, 0), 0.5 * (0.2 + 0.8 * xx), 1e-12);
  EXPECT_NEAR(prior.covariance(0, 1), 0.5 * 0.8 * xy, 1e-12);
  EXPECT_NEAR(prior.covariance(1, 0), 0.5 * 0.8 * xy, 1e-12);
  EXPECT_NEAR(prior.covariance(1, 1), 0.5 * (0.2 + 0.8 * yy), 1e-12);

  // As one group, the four differ from the mean of all by as much, of 4 - 1 degrees.
  const HierarchyConfig one_group{.prior_scale = 0.5, .prior_floor = 0.2, .prior_group = 4};
  EXPECT_NEAR(Hierarchy(four, one_group).prior().covariance(1, 1),
              0.5 * (0.2 + 0.8 * 10.0 / 3.0 / vy), 1e-12);
}

TEST(Hierarchy, GrownOneByOneHasTheModelsOfOneThatIsBuilt) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    const Exemplars all = random_exemplars(90, 4, 2, Random(seed), seed % 2 == 0 ? 0 : 5);
    std::vector<std::size_t> first(40);
    for (std::size_t n = 0; n < first.size(); ++n) first[n] = n;
    Hierarchy grown(all.subset(first), {});
    for (std::size_t n = first.size(); n < all.size(); ++n) {
      const NodeId leaf = grown.learn(all.percept(n), all.action(n));
      ASSERT_TRUE(grown.tree().nodes()[leaf].leaf());
    }
    const Hierarchy built(all, {}, grown.prior());
    // Where the partition agrees: nodes of both that hold the same exemplars.
    const auto members = [](const Hierarchy& hierarchy, NodeId node) {
      const auto of = hierarchy.tree().exemplars_of(node);
      std::vector<std::uint32_t> sorted(of.begin(), of.end());
      std::ranges::sort(sorted);
      return sorted;
    };
    int agreed = 0;
    for (NodeId a = 0; a < built.tree().nodes().size(); ++a) {
      for (NodeId b = 0; b < grown.tree().nodes().size(); ++b) {
        if (!built.has_model(a) || members(built, a) != members(grown, b)) continue;
        ++agreed;
        ASSERT_TRUE(grown.has_model(b));
        const Gaussian expected = built.percept_model(a);
        EXPECT_LT((grown.percept_model(b).mean - expected.mean).norm(),
                  1e-9 * (1.0 + expected.mean.norm()));
        EXPECT_LT((grown.percept_model(b).covariance - expected.covariance).norm(),
                  1e-9 * expected.covariance.norm());
        EXPECT_LT((grown.action_model(b).covariance - built.action_model(a).covariance).norm(),
                  1e-12);
      }
    }
    EXPECT_GT(agreed, 10);
    // Whatever was learnt is recalled.
    Searcher searcher(grown);
    for (std::size_t n = 0; n < all.size(); ++n) {
      const Found& found = searcher.find(all.percept(n), 1000.0);
      EXPECT_TRUE(found.exact);
      EXPECT_TRUE(std::ranges::count(grown.tree().exemplars_of(found.best.node), n) == 1);
    }
  }
}

TEST(Hierarchy, WithOneExemplarAlwaysAnswersItsAction) {
  const Hierarchy hierarchy(Exemplars(2, 2, {1, 2}, {0.3, 0.4}), {});
  Searcher searcher(hierarchy);
  Random random(1);
  double action[2];
  for (const auto& percept : {std::vector<double>{1, 2}, std::vector<double>{9, 9}}) {
    const Found& found = searcher.find(percept);
    EXPECT_EQ(found.best.node, 0U);
    EXPECT_EQ(found.exact, percept[0] == 1.0);
    EXPECT_EQ(std::isinf(found.best.distance), !found.exact) << "there is nothing to compare with";
    hierarchy.respond(found.best.node, random, action);
    EXPECT_EQ(action[0], 0.3);
    EXPECT_EQ(action[1], 0.4);
  }
}

TEST(Hierarchy, OfEqualActionsAnswersThatActionToAnyPercept) {
  const Hierarchy hierarchy(Exemplars(1, 1, {1, 2, 4}, {0.1, 0.1, 0.1}), {});
  Searcher searcher(hierarchy);
  Random random(1);
  double action[1];
  const std::vector<double> percept = {2.5};
  hierarchy.respond(searcher.find(percept).best.node, random, action);
  EXPECT_EQ(action[0], 0.1);
}

TEST(Hierarchy, OfAllZeroPerceptsStillAnswers) {
  const Hierarchy hierarchy(Exemplars(3, 1, std::vector<double>(12), {1, 2, 3, 4}), {});
  Searcher searcher(hierarchy);
  const Found& same = searcher.find(std::vector<double>(3));
  EXPECT_TRUE(same.exact);
  // Nothing ever varied, so nothing is known to matter.
  const Found& other = searcher.find(std::vector<double>{1, 2, 3});
  EXPECT_TRUE(other.matched);
  EXPECT_FALSE(other.exact);
  EXPECT_EQ(other.best.distance, 0.0F);
}

TEST(Hierarchy, LeavesOutANumberThatNeverVaried) {
  const Exemplars some = random_exemplars(40, 2, 1, Random(3));
  std::vector<double> percepts;
  for (std::size_t n = 0; n < some.size(); ++n) {
    percepts.insert(percepts.end(), {some.percept(n)[0], 7.0, some.percept(n)[1]});
  }
  const Hierarchy hierarchy(
      Exemplars(3, 1, percepts, {some.actions().begin(), some.actions().end()}), {});
  Searcher searcher(hierarchy);
  const Candidate usual = searcher.find(std::vector<double>{0.1, 7.0, 5.0}).best;
  EXPECT_EQ(searcher.find(std::vector<double>{0.1, 9.0, 5.0}).best, usual);
  const double distance = usual.distance;
  EXPECT_NEAR(hierarchy.distance(usual.node, std::vector<double>{0.1, 9.0, 5.0}), distance,
              1e-3 * (1.0 + distance));
}

TEST(Hierarchy, TakesNumbersOfAnyGreatness) {
  const Exemplars huge(2, 1, {1e100, 1e-100, -1e100, 2e-100, 0, 0}, {1, 2, 3});
  const Hierarchy hierarchy(huge, {});
  Searcher searcher(hierarchy);
  for (std::size_t n = 0; n < 3; ++n) EXPECT_TRUE(searcher.find(huge.percept(n), 100.0).exact);
  EXPECT_FALSE(searcher.find(std::vector<double>{1e100, 1e100}).exact);
}

TEST(Hierarchy, LearnsNumbersOfAnyGreatness) {
  const Exemplars usual = random_exemplars(60, 6, 2, Random(8));
  const Exemplars queries = random_exemplars(20, 6, 2, Random(9));
  for (const double greatness : {1e3, 1e6, 1e9, 1e12, 1e50, 1e100}) {
    Hierarchy hierarchy(usual, {});
    for (int n = 0; n < 30; ++n) {  // together and apart
      std::vector<double> percept(6, n % 2 == 0 ? greatness : -greatness);
      percept[static_cast<std::size_t>(n) % 6] *= n % 3 == 0 ? -1.0 : 1e-3;
      hierarchy.learn(percept, std::vector<double>{0.03 * n, 0.5});
    }
    Searcher searcher(hierarchy);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      const Found& found = searcher.find(queries.percept(q));
      EXPECT_TRUE(found.matched) << greatness;
      EXPECT_TRUE(std::isfinite(found.best.distance)) << greatness;
      EXPECT_TRUE(std::isfinite(hierarchy.distance(0, queries.percept(q)))) << greatness;
    }
  }
}

TEST(Hierarchy, LearnsWhatVariesAfterWhatHardlyDid) {
  for (const double hardly : {1e-12, 1e-7, 1e-5, 1e-3}) {
    const Exemplars some = random_exemplars(40, 2, 1, Random(3));
    std::vector<double> percepts;
    for (std::size_t n = 0; n < some.size(); ++n) {
      percepts.insert(percepts.end(),
                      {some.percept(n)[0], 100.0 + hardly * static_cast<double>(n % 3),
                       50.0 + hardly * static_cast<double>(n % 5)});
    }
    Hierarchy hierarchy(Exemplars(3, 1, percepts, {some.actions().begin(), some.actions().end()}),
                        {});
    const std::vector<double> percept = {0.2, 180.0, 90.0};
    hierarchy.learn(percept, std::vector<double>{0.5});
    EXPECT_TRUE(Searcher(hierarchy).find(percept, 1e6).exact) << hardly;
  }
}

TEST(Hierarchy, TheSameGeneratorGivesTheSameActions) {
  const Hierarchy hierarchy(random_exemplars(30, 3, 2, Random(4)), {});
  Random one(5);
  Random other(5);
  for (int n = 0; n < 10; ++n) {
    double a[2];
    double b[2];
    hierarchy.respond(0, one, a);
    hierarchy.respond(0, other, b);
    EXPECT_EQ(a[0], b[0]);
    EXPECT_EQ(a[1], b[1]);
  }
}

}  // namespace
}  // namespace pacer::exemplar
