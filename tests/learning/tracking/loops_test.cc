// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <vector>

#include "core/random.h"
#include "learning/tracking/learning_loops.h"
#include "learning/tracking/predictor_loops.h"
#include "learning/tracking/template_loops.h"

namespace pacer::tracking {
namespace {

/// With each kind of loops that this processor can run.
class Loops : public ::testing::TestWithParam<std::size_t> {
 protected:
  const PredictorLoops& predictor = predictor_loops(GetParam());
  const LearningLoops& learning = learning_loops(GetParam());
  const TemplateLoops& templates = template_loops(GetParam());
  Random random{7};

  std::vector<std::uint8_t> bytes(std::size_t count) {
    std::vector<std::uint8_t> values(count);
    for (auto& value : values) value = static_cast<std::uint8_t>(random.below(256));
    return values;
  }
  std::vector<float> floats(std::size_t count) {
    std::vector<float> values(count);
    for (auto& value : values) value = static_cast<float>(random.uniform(-1.0, 1.0));
    return values;
  }
  /// Differences in [-255, 255] of 2 `pairs` pixels in `samples` samples, as pair() packs them.
  std::vector<std::int32_t> differences(std::size_t pairs, std::size_t samples) {
    std::vector<std::int32_t> packed(pairs * samples);
    for (std::size_t p = 0; p < pairs; ++p) {
      const auto reference = bytes(2), first = bytes(samples), second = bytes(samples);
      learning.pair(reference.data(), first.data(), second.data(), samples, &packed[p * samples]);
    }
    return packed;
  }
  /// D of packed differences: pixels x samples.
  static Eigen::MatrixXd unpacked(const std::vector<std::int32_t>& packed, std::size_t pairs,
                                  std::size_t samples) {
    Eigen::MatrixXd all(2 * pairs, samples);
    for (std::size_t p = 0; p < pairs; ++p) {
      for (std::size_t n = 0; n < samples; ++n) {
        const std::int32_t pair = packed[p * samples + n];
        const auto low = static_cast<std::int16_t>(pair & 0xffff);
        all(static_cast<Eigen::Index>(2 * p), static_cast<Eigen::Index>(n)) = low;
        all(static_cast<Eigen::Index>(2 * p + 1), static_cast<Eigen::Index>(n)) = pair >> 16;
      }
    }
    return all;
  }
};
INSTANTIATE_TEST_SUITE_P(OfEachKind, Loops, ::testing::Range<std::size_t>(0, processor_kinds()));

TEST_P(Loops, PackDifferencesInPairs) {
  const std::vector<std::uint8_t> reference = {10, 250};
  std::vector<std::uint8_t> first(16, 10), second(16, 250);
  first[1] = 255;
  second[1] = 0;
  second[2] = 255;
  std::vector<std::int32_t> packed(16);
  learning.pair(reference.data(), first.data(), second.data(), 16, packed.data());
  const Eigen::MatrixXd d = unpacked(packed, 1, 16);
  EXPECT_EQ(d.col(0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(d.col(1), Eigen::Vector2d(-245, 250));
  EXPECT_EQ(d.col(2), Eigen::Vector2d(0, -5));
}

TEST_P(Loops, MakeTheGramMatrixExactly) {
  for (const std::size_t samples : {16U, 48U, 112U}) {
    const std::size_t pairs = 1 + random.below(90);
    const auto packed = differences(pairs, samples);
    const std::size_t stride = samples + 16;
    std::vector<float> products(samples * stride, -1.0F);
    learning.gram(packed.data(), pairs, samples, stride, products.data());
    const Eigen::MatrixXd d = unpacked(packed, pairs, samples);
    const Eigen::MatrixXd expected = d.transpose() * d;
    for (std::size_t i = 0; i < samples; ++i) {
      for (std::size_t j = i; j < samples; ++j) {
        ASSERT_EQ(products[i * stride + j],
                  static_cast<float>(
                      expected(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j))));
      }
    }
  }
}

TEST_P(Loops, SolveAsEigenDoesAndAlikeOnEveryProcessor) {
  for (const std::size_t size : {2U, 5U, 16U, 33U, 100U, 150U}) {
    const auto n = static_cast<Eigen::Index>(size);
    Eigen::MatrixXd a(n, n), b(n, 2);
    for (double& value : a.reshaped()) value = random.uniform(-1.0, 1.0);
    for (double& value : b.reshaped()) value = random.uniform(-30.0, 30.0);
    a = (a * a.transpose()).eval() + Eigen::MatrixXd::Identity(n, n);
    const std::size_t stride = padded(size + 2);
    std::vector<float> system(padded(size) * stride);
    for (std::size_t i = 0; i < size; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = i; j < size; ++j) {
        system[i * stride + j] = static_cast<float>(a(row, static_cast<Eigen::Index>(j)));
      }
      system[i * stride + size] = static_cast<float>(b(row, 0));
      system[i * stride + size + 1] = static_cast<float>(b(row, 1));
    }
    std::vector<float> plain_system = system;
    std::vector<float> solution(2 * padded(size)), plain = solution;
    learning.solve(system.data(), size, stride, solution.data());
    learning_loops(0).solve(plain_system.data(), size, stride, plain.data());
    EXPECT_EQ(solution, plain);
    const Eigen::MatrixXd expected = a.llt().solve(b);
    for (std::size_t i = 0; i < size; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      EXPECT_NEAR(static_cast<double>(solution[i]), expected(row, 0), 0.02);
      EXPECT_NEAR(static_cast<double>(solution[padded(size) + i]), expected(row, 1), 0.02);
    }
  }
}

TEST_P(Loops, CombineDifferencesAlikeOnEveryProcessor) {
  constexpr std::size_t kPairs = 40, kSamples = 112;
  const auto packed = differences(kPairs, kSamples);
  const auto weights = floats(2 * kSamples);
  std::vector<float> combined(4 * kPairs), plain = combined;
  learning.combine(packed.data(), kPairs, kSamples, weights.data(), combined.data());
  learning_loops(0).combine(packed.data(), kPairs, kSamples, weights.data(), plain.data());
  EXPECT_EQ(combined, plain);
  const Eigen::MatrixXd d = unpacked(packed, kPairs, kSamples);
  const Eigen::Map<const Eigen::Matrix<float, kSamples, 2>> w(weights.data());
  const Eigen::MatrixXd expected = d * w.cast<double>();
  for (std::size_t i = 0; i < 2 * kPairs; ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    EXPECT_NEAR(static_cast<double>(combined[i]), expected(row, 0), 0.01);
    EXPECT_NEAR(static_cast<double>(combined[2 * kPairs + i]), expected(row, 1), 0.01);
  }
}

TEST_P(Loops, ProjectAlikeOnEveryProcessor) {
  const auto rows = floats(2 * 160);
  const auto values = bytes(160);
  std::vector<float> sums(2), plain(2);
  predictor.project(rows.data(), values.data(), 160, sums.data());
  predictor_loops(0).project(rows.data(), values.data(), 160, plain.data());
  EXPECT_EQ(sums, plain);
  double expected = 0.0;
  for (std::size_t i = 0; i < 160; ++i) expected += static_cast<double>(rows[160 + i]) * values[i];
  EXPECT_NEAR(static_cast<double>(sums[1]), expected, 0.01);
}

TEST_P(Loops, ObserveAlikeOnEveryProcessor) {
  const auto image = bytes(60 * 80);
  const PixelView view{.data = image.data(), .width = 70, .height = 60, .step = 80};
  std::vector<std::int32_t> dx(304), dy(304);
  for (auto& offset : dx) offset = static_cast<std::int32_t>(random.below(200)) - 100;
  for (auto& offset : dy) offset = static_cast<std::int32_t>(random.below(200)) - 100;
  std::vector<std::uint8_t> values(304);
  predictor.observe(view, 35, 20, dx.data(), dy.data(), 304, values.data());
  for (std::size_t i = 0; i < 304; ++i) {
    const int x = std::clamp(35 + dx[i], 0, 69);
    const int y = std::clamp(20 + dy[i], 0, 59);
    ASSERT_EQ(values[i], image[static_cast<std::size_t>(y * 80 + x)]);
  }
}

TEST_P(Loops, MeasureSquaredDistancesExactly) {
  for (const std::size_t count : {16U, 1024U, 16384U}) {
    const auto a = bytes(count), b = bytes(count);
    std::uint32_t expected = 0;
    for (std::size_t i = 0; i < count; ++i) {
      expected += static_cast<std::uint32_t>((a[i] - b[i]) * (a[i] - b[i]));
    }
    EXPECT_EQ(templates.squared_distance(a.data(), b.data(), count), expected);
  }
  const std::vector<std::uint8_t> black(32768, 0), white(32768, 255);
  EXPECT_EQ(templates.squared_distance(black.data(), white.data(), 32768), 32768U * 65025U);
}

TEST_P(Loops, UpdateAMatrixRowByRow) {
  std::vector<float> first(32), second(32);
  std::vector<double> row(32), least(32, 10.0), at(32, -1.0);
  for (std::size_t i = 0; i < 32; ++i) {
    first[i] = static_cast<float>(random.below(1000));
    second[i] = static_cast<float>(random.below(1000));
    row[i] = static_cast<double>(i);
  }
  templates.add_scaled(3.0, first.data(), 32, row.data());
  templates.exchange(2.0F, second.data(), 3.0F, first.data(), 32, row.data());
  for (std::size_t i = 0; i < 32; ++i) {
    EXPECT_EQ(row[i], static_cast<double>(i) + 2.0 * static_cast<double>(second[i]));
    row[i] = static_cast<double>(i);
  }
  templates.lower(row.data(), 5.0, 32, least.data(), at.data());
  EXPECT_EQ(least[9], 9.0);
  EXPECT_EQ(at[9], 5.0);
  EXPECT_EQ(least[10], 10.0);
  EXPECT_EQ(at[10], -1.0);
}

}  // namespace
}  // namespace pacer::tracking
