// SPDX-License-Identifier: Apache-2.0
#include "learning/tracking/peers/fresh_generators.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <opencv2/core.hpp>
#include <vector>

namespace pacer::tracking {
namespace {

std::vector<unsigned> draw() {
  return {static_cast<unsigned>(std::rand()), static_cast<unsigned>(std::rand()),
          cv::theRNG().next(), cv::theRNG().next()};
}

std::vector<unsigned> draw_from(FreshGenerators& generators) {
  const FreshGenerators::Loan loan(generators);
  return draw();
}

TEST(FreshGenerators, DrawAsAProgramThatStarts) {
  std::srand(1);
  cv::theRNG() = cv::RNG();
  const std::vector<unsigned> first = draw();
  const std::vector<unsigned> second = draw();
  FreshGenerators generators(1);
  EXPECT_EQ(draw_from(generators), first);
  EXPECT_EQ(draw_from(generators), second);
}

TEST(FreshGenerators, KeepApart) {
  FreshGenerators one(1);
  FreshGenerators other(1);
  const std::vector<unsigned> first = draw_from(one);
  const std::vector<unsigned> second = draw_from(one);
  EXPECT_EQ(draw_from(other), first);
  EXPECT_EQ(draw_from(other), second);
  EXPECT_NE(first, second);
}

TEST(FreshGenerators, DrawOtherwiseWithAnotherSeed) {
  FreshGenerators one(1);
  FreshGenerators other(2);
  const std::vector<unsigned> first = draw_from(one);
  const std::vector<unsigned> second = draw_from(other);
  EXPECT_NE(first[0], second[0]);
  EXPECT_NE(first[2], second[2]);
}

TEST(FreshGenerators, LeaveTheProcesssAsTheyWere) {
  const auto seed = [] {
    std::srand(77);
    cv::theRNG().state = 78;
  };
  seed();
  const std::vector<unsigned> undisturbed = draw();
  seed();
  FreshGenerators generators(1);
  static_cast<void>(draw_from(generators));
  {
    const FreshGenerators::Loan loan(generators);
    std::srand(5);  // as OpenCV's Boosting does
  }
  EXPECT_EQ(draw(), undisturbed);
}

}  // namespace
}  // namespace pacer::tracking
