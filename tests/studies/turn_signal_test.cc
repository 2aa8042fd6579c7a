// SPDX-License-Identifier: Apache-2.0
#include "studies/turn_signal.h"

#include <gtest/gtest.h>

#include <cmath>

namespace pacer {
namespace {

std::vector<double> wave(std::size_t count, double phase) {
  std::vector<double> signal(count);
  for (std::size_t i = 0; i < count; ++i) {
    signal[i] = 0.6 * std::sin(0.05 * static_cast<double>(i) + phase);
  }
  return signal;
}

TEST(TurnSignal, OneFrameThatFiresElsewhereIsASpikeOfItsHeight) {
  std::vector<double> signal = wave(200, 0.0);
  const double before = signal[90];
  signal[90] = before - 1.2;
  const std::vector<double> found = spikes(signal);
  EXPECT_NEAR(found[90], 1.2, 0.1);
  for (std::size_t i = 0; i < found.size(); ++i) {
    if (i == 90) continue;
    EXPECT_LT(found[i], 0.2) << i;
  }
}

TEST(TurnSignal, AStepThatStaysIsNone) {
  std::vector<double> signal(100, -0.5);
  for (std::size_t i = 50; i < 100; ++i) signal[i] = 0.5;
  for (const double spike : spikes(signal)) EXPECT_EQ(spike, 0.0);
}

TEST(TurnSignal, IsMeasuredOverAllEpisodes) {
  SignalComparison same;
  same.add_episode(wave(150, 0.3), wave(150, 0.3));
  same.add_episode(wave(80, 1.0), wave(80, 1.0));
  EXPECT_NEAR(same.measures().correlation, 1.0, 1e-12);
  EXPECT_EQ(same.measures().rms_error, 0.0);

  SignalComparison opposite;
  std::vector<double> mirrored = wave(150, 0.3);
  for (double& value : mirrored) value = 0.2 - value;
  opposite.add_episode(mirrored, wave(150, 0.3));
  EXPECT_NEAR(opposite.measures().correlation, -1.0, 1e-12);
}

TEST(TurnSignal, ThatNeverMovesIsCorrelatedWithNothing) {
  SignalComparison still;
  still.add_episode(std::vector<double>(50, 0.25), wave(50, 0.0));
  EXPECT_EQ(still.measures().correlation, 0.0);
  EXPECT_EQ(still.measures().worst_spike, 0.0);
  EXPECT_GT(still.measures().rms_error, 0.2);
}

TEST(TurnSignal, OfNothingIsNothing) {
  EXPECT_TRUE(spikes({}).empty());
  EXPECT_EQ(SignalComparison().measures().rms_error, 0.0);
}

}  // namespace
}  // namespace pacer
