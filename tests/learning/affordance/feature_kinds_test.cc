// SPDX-License-Identifier: Apache-2.0
// Features of several kinds in one picture, their words, and models of them (6.8).
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <tuple>

#include "learning/affordance/features.h"
#include "learning/affordance/kmeans.h"
#include "learning/affordance/nearest.h"
#include "learning/affordance/vocabulary.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::affordance {
namespace {

Frame picture() {
  Frame frame;
  const pacer::testing::PatchPainter painter(3);
  painter.paint(pacer::testing::wander(1, Random(8)).front(), 0, frame);
  return frame;
}

Features features_of(const FeatureConfig& config, const Frame& frame) {
  FeatureExtractor extractor(config);
  Features features;
  extractor.extract(frame, features);
  return features;
}

using Row = std::tuple<float, float, float, float, std::vector<std::uint8_t>>;

std::multiset<Row> rows_of(const Features& features, std::uint8_t kind) {
  std::multiset<Row> rows;
  for (std::size_t i = 0; i < features.count(); ++i) {
    if (features.kinds[i] != kind) continue;
    const auto descriptor = features.descriptor(i);
    rows.emplace(features.poses.x[i], features.poses.y[i], features.poses.size[i],
                 features.poses.angle[i],
                 std::vector<std::uint8_t>(descriptor.begin(), descriptor.end()));
  }
  return rows;
}

class EveryKind : public ::testing::TestWithParam<std::string> {
 protected:
  FeatureConfig config() const {
    FeatureConfig config;
    config.top = 0.25;
    config.max_size = 6.5;
    config.kinds = {GetParam()};
    return config;
  }
};

TEST_P(EveryKind, KeepsTheRegionTheSizeAndTheBudget) {
  FeatureConfig modest = config();
  const Features all = features_of(modest, picture());
  ASSERT_GT(all.count(), 12U);
  EXPECT_TRUE(std::is_sorted(all.poses.x.begin(), all.poses.x.end()));
  ASSERT_EQ(all.kinds.size(), all.count());
  ASSERT_EQ(all.descriptors.size(), all.count() * kDescriptorSize);
  for (std::size_t i = 0; i < all.count(); ++i) {
    EXPECT_GE(all.poses.y[i], 29.5F);
    EXPECT_LE(all.poses.y[i], 119.5F);
    EXPECT_LE(all.poses.size[i], 6.5F);
    EXPECT_GT(all.poses.size[i], 0.5F);
    EXPECT_GE(all.poses.angle[i], 0.0F);
    EXPECT_LE(all.poses.angle[i], 6.2832F);
  }
  modest.budget = 10;
  EXPECT_LE(features_of(modest, picture()).count(), 12U) << "SIFT's place has several directions";
}

TEST_P(EveryKind, TheSamePictureGivesTheSameFeatures) {
  FeatureExtractor extractor(config());
  Features first;
  Features second;
  extractor.extract(picture(), first);
  Frame other = picture();
  std::ranges::reverse(other.rgb);
  extractor.extract(other, second);
  EXPECT_NE(rows_of(first, 0), rows_of(second, 0));
  extractor.extract(picture(), second);
  EXPECT_EQ(first.descriptors, second.descriptors);
  EXPECT_EQ(rows_of(first, 0), rows_of(second, 0));
}

TEST_P(EveryKind, SmallAndEmptyPicturesHaveFewOrNone) {
  FeatureExtractor extractor(config());
  for (const ImageSize size :
       {ImageSize{16, 32}, {17, 33}, {40, 40}, {64, 48}, {8, 8}, {320, 20}}) {
    Frame frame;
    frame.size = size;
    frame.rgb.assign(
        3 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 90);
    Features features;
    extractor.extract(frame, features);
    EXPECT_LE(features.count(), 1U) << "a picture of one colour is one blob at most";
    Random random(5);
    for (std::uint8_t& value : frame.rgb) value = static_cast<std::uint8_t>(random.below(256));
    extractor.extract(frame, features);
    EXPECT_LE(features.count(), 550U);
  }
}

INSTANTIATE_TEST_SUITE_P(Of, EveryKind, ::testing::Values("sift", "orb", "akaze", "brisk", "blob"),
                         [](const auto& kind) { return kind.param; });

TEST(MixedFeatures, AreThoseOfEachKindAlone) {
  FeatureConfig config;
  config.kinds = {"blob", "sift", "orb"};
  const Features mixed = features_of(config, picture());
  EXPECT_TRUE(std::is_sorted(mixed.poses.x.begin(), mixed.poses.x.end()));
  for (std::uint8_t kind = 0; kind < 3; ++kind) {
    FeatureConfig alone = config;
    alone.kinds = {config.kinds[kind]};
    const std::multiset<Row> rows = rows_of(features_of(alone, picture()), 0);
    EXPECT_GT(rows.size(), 3U);
    EXPECT_EQ(rows_of(mixed, kind), rows) << config.kinds[kind];
  }
}

TEST(MixedFeatures, UnknownKindsAndDoubleOnesAreRefused) {
  for (const std::vector<std::string>& kinds :
       {std::vector<std::string>{}, {"surf"}, {"sift", "sift"}, {"sift", ""}, {"SIFT"}}) {
    FeatureConfig config;
    config.kinds = kinds;
    EXPECT_THROW(config.validate(), std::invalid_argument);
  }
}

int naive_bits(const std::uint8_t* a, const std::uint8_t* b, std::size_t bytes) {
  int bits = 0;
  for (std::size_t bit = 0; bit < 8 * bytes; ++bit) {
    bits += ((a[bit / 8] ^ b[bit / 8]) >> (bit % 8) & 1) != 0 ? 1 : 0;
  }
  return bits;
}

std::vector<std::uint8_t> random_bytes(std::size_t count, Random random) {
  std::vector<std::uint8_t> bytes(count);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

TEST(KMajority, NoIterationRaisesTheCostAndItIsThatOfTheNearest) {
  constexpr std::size_t kBytes = 16;
  const std::vector<std::uint8_t> samples = random_bytes(500 * kBytes, Random(3));
  const KMajorityResult result =
      k_majority(samples, kBytes, {.clusters = 9, .iterations = 60}, Random(4));
  ASSERT_EQ(result.centres.size(), 9 * kBytes);
  for (std::size_t i = 1; i < result.cost.size(); ++i)
    EXPECT_LE(result.cost[i], result.cost[i - 1]);
  EXPECT_LT(result.cost.back(), result.cost.front());
  double cost = 0.0;
  for (std::size_t i = 0; i < 500; ++i) {
    int least = 1000;
    for (std::size_t c = 0; c < 9; ++c) {
      least =
          std::min(least, naive_bits(&samples[i * kBytes], &result.centres[c * kBytes], kBytes));
    }
    cost += least;
    EXPECT_EQ(nearest_by_bits(&samples[i * kBytes], result.centres, kBytes).bits,
              static_cast<std::uint32_t>(least));
  }
  EXPECT_EQ(result.cost.back(), cost);
}

TEST(KMajority, FindsTheStringsThatNoiseWasAddedTo) {
  constexpr std::size_t kBytes = 32;
  const std::vector<std::uint8_t> truth = random_bytes(5 * kBytes, Random(6));
  std::vector<std::uint8_t> samples;
  Random random(7);
  for (std::size_t i = 0; i < 300; ++i) {
    for (std::size_t b = 0; b < kBytes; ++b) {
      std::uint8_t byte = truth[i % 5 * kBytes + b];
      for (unsigned bit = 0; bit < 8; ++bit) {
        if (random.chance(0.1)) byte = static_cast<std::uint8_t>(byte ^ 1U << bit);
      }
      samples.push_back(byte);
    }
  }
  const KMajorityResult result =
      k_majority(samples, kBytes, {.clusters = 5, .iterations = 40, .restarts = 4}, Random(8));
  for (std::size_t t = 0; t < 5; ++t) {
    EXPECT_EQ(nearest_by_bits(&truth[t * kBytes], result.centres, kBytes).bits, 0U)
        << "a majority of 60 removes a tenth of noise";
  }
}

TEST(MixedFeatures, WordsAreTheNearestOfTheirOwnKind) {
  FeatureConfig config;
  config.kinds = {"sift", "orb"};
  const Features features = features_of(config, picture());
  const std::vector<FeatureKind> kinds = {FeatureKind::kSift, FeatureKind::kOrb};
  const Vocabulary vocabulary =
      build_vocabulary(features, kinds, {.descriptor = 12, .iterations = 5}, Random(6));
  ASSERT_EQ(vocabulary.descriptor_words(), 24);
  EXPECT_FALSE(vocabulary.kinds()[0].binary());
  EXPECT_TRUE(vocabulary.kinds()[1].binary());
  Words words;
  vocabulary.label(features, words);
  for (std::size_t i = 0; i < features.count(); ++i) {
    if (features.kinds[i] == 0) {
      EXPECT_LT(words.descriptor[i], 12);
      continue;
    }
    ASSERT_GE(words.descriptor[i], 12);
    const std::uint8_t* bits = vocabulary.kinds()[1].bits().data();
    const auto distance = [&](std::size_t word) {
      return naive_bits(features.descriptor(i).data(), bits + word * kDescriptorSize,
                        kDescriptorSize);
    };
    for (std::size_t word = 0; word < 12; ++word) {
      EXPECT_LE(distance(words.descriptor[i] - 12U), distance(word));
    }
  }
}

}  // namespace
}  // namespace pacer::affordance
