// SPDX-License-Identifier: Apache-2.0
#include "learning/affordance/model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "tests/learning/affordance/random_model.h"

namespace pacer::affordance {
namespace {

using pacer::testing::random_model;

std::string failure(std::string_view bytes) {
  try {
    (void)from_bytes(bytes, "the.model");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// The bytes as if a program had written them so: with the right checksum.
std::string resealed(std::string bytes) {
  constexpr std::size_t kHeader = 8 + 4 + 8;
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (std::size_t i = kHeader; i + 8 < bytes.size(); ++i) {
    hash = (hash ^ static_cast<std::uint8_t>(bytes[i])) * 0x100000001b3U;
  }
  for (std::size_t i = 0; i < 8; ++i) {
    bytes[bytes.size() - 8 + i] = static_cast<char>(hash >> (8 * i) & 0xffU);
  }
  return bytes;
}

TEST(ModelFile, ReadsBackToTheSameBytes) {
  const std::string bytes = to_bytes(random_model(300));
  const Model model = from_bytes(bytes, "the.model");
  EXPECT_EQ(to_bytes(model), bytes);
  EXPECT_EQ(model.matcher.rule_count(), 300U);
}

TEST(ModelFile, KeepsEverySetting) {
  Model model = random_model(3);
  model.config.mapping.ridge = 0.1;
  model.config.response.vote = "rule";
  model.config.response.loss.hold = Seconds{1.0 / 3.0};
  model.config.response.evidence.caution = 0.3;
  model.config.mining.grow_confident = true;
  model.config.transactions.lag = "0.12";
  model.frames_learnt = 12;
  model.frames_matched = 7;
  model.typical_witnesses = 2.5;
  const Model read = from_bytes(to_bytes(model), "the.model");
  EXPECT_EQ(read.config.mapping.ridge, 0.1);
  EXPECT_EQ(read.config.response.vote, "rule");
  EXPECT_EQ(read.config.response.loss.hold.count(), 1.0 / 3.0);
  EXPECT_EQ(read.config.response.evidence.caution, 0.3);
  EXPECT_EQ(read.typical_witnesses, 2.5);
  EXPECT_TRUE(read.config.mining.grow_confident);
  EXPECT_EQ(read.config.transactions.lag, "0.12");
  EXPECT_EQ(read.frames_learnt, 12U);
  EXPECT_EQ(read.frames_matched, 7U);
  EXPECT_EQ(read.scenario, model.scenario);
  EXPECT_EQ(read.fingerprint, model.fingerprint);
  EXPECT_EQ(read.rules, model.rules);
  EXPECT_EQ(read.mappings, model.mappings);
}

TEST(ModelFile, MoreWitnessesThanRulesAreRefused) {
  Model model = random_model(3);
  for (const double typical : {-1.0, 3.5, std::nan(""), HUGE_VAL}) {
    model.typical_witnesses = typical;
    EXPECT_NE(failure(to_bytes(model)).find("number of witnesses"), std::string::npos) << typical;
  }
}

TEST(ModelFile, WhiteningThatNothingUndoesIsRefused) {
  Model model = random_model(3);
  EXPECT_EQ(failure(to_bytes(model)), "");
  model.actions.whiten.col(1) = 2.0 * model.actions.whiten.col(0);
  EXPECT_NE(failure(to_bytes(model)).find("action whitening"), std::string::npos);
}

TEST(ModelFile, EveryTruncationIsRefused) {
  const std::string bytes = to_bytes(random_model(2));
  for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 37) {
    EXPECT_NE(failure(bytes.substr(0, size)), "") << size;
  }
  EXPECT_NE(failure(bytes + "x"), "");
}

TEST(ModelFile, EveryFlippedByteIsRefused) {
  std::string bytes = to_bytes(random_model(2));
  for (std::size_t i = 0; i < bytes.size(); i += i < 64 ? 1 : 53) {
    bytes[i] = static_cast<char>(bytes[i] ^ 0x40);
    EXPECT_NE(failure(bytes), "") << i;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x40);
  }
}

TEST(ModelFile, HostileBytesUnderAGoodChecksumAreRefusedOrHarmless) {
  const std::string bytes = to_bytes(random_model(5));
  Random random(9);
  int refused = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string hostile = bytes;
    const std::size_t at = 20 + random.below(bytes.size() - 28);
    for (std::size_t i = at; i < std::min(at + 8, bytes.size() - 8); ++i) {
      hostile[i] = static_cast<char>(random.chance(0.5) ? 0xff : random.below(256));
    }
    refused += failure(resealed(hostile)).empty() ? 0 : 1;
  }
  EXPECT_GT(refused, 0);
}

/// A model of SIFT and of ORB words.
Model mixed_model() {
  Model model = random_model(5);
  model.config.features.kinds = {"sift", "orb"};
  model.config.words.descriptor = 50;
  std::vector<DescriptorWords> kinds(model.vocabulary.kinds().begin(),
                                     model.vocabulary.kinds().end());
  std::vector<std::uint8_t> bits(50 * kDescriptorSize);
  Random random(4);
  for (std::uint8_t& byte : bits) byte = static_cast<std::uint8_t>(random.below(256));
  kinds.emplace_back(std::move(bits));
  const auto copy = [](std::span<const float> values) {
    return std::vector<float>(values.begin(), values.end());
  };
  model.vocabulary = Vocabulary(std::move(kinds), copy(model.vocabulary.scales()),
                                copy(model.vocabulary.orientations()));
  model.frequency.resize(static_cast<std::size_t>(ItemLayout(model.vocabulary).count()), 1);
  return model;
}

TEST(ModelFile, CarriesMixedFeatures) {
  const std::string bytes = to_bytes(mixed_model());
  const Model read = from_bytes(bytes, "the.model");
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.config.features.kinds, (std::vector<std::string>{"sift", "orb"}));
  ASSERT_EQ(read.vocabulary.kinds().size(), 2U);
  EXPECT_TRUE(read.vocabulary.kinds()[1].binary());
  EXPECT_EQ(read.vocabulary.descriptor_words(), 100);
  for (std::size_t size = 0; size < bytes.size(); size += 41) {
    EXPECT_NE(failure(bytes.substr(0, size)), "") << size;
  }
}

TEST(ModelFile, KindsOfFeatureThatItsWordsAreNotOfAreRefused) {
  const auto with = [](const std::vector<std::string>& kinds) {
    Model model = mixed_model();
    model.config.features.kinds = kinds;
    return failure(to_bytes(model));
  };
  EXPECT_EQ(with({"sift", "orb"}), "");
  EXPECT_EQ(with({"sift", "brisk"}), "") << "bits as well";
  for (const std::vector<std::string>& kinds : {std::vector<std::string>{"sift"},
                                                {"sift", "blob"},
                                                {"orb", "sift"},
                                                {"sift", "surf"},
                                                {"sift", "sift"},
                                                {},
                                                {"sift", "orb", "brisk"}}) {
    EXPECT_NE(with(kinds).find("the.model: a damaged"), std::string::npos);
  }
}

TEST(ModelFile, AnotherVersionSaysWhatToDo) {
  std::string bytes = to_bytes(random_model(1));
  bytes[8] = 77;
  EXPECT_NE(failure(bytes).find("version 77"), std::string::npos);
  EXPECT_NE(failure(bytes).find("train it again"), std::string::npos);
  EXPECT_EQ(failure(bytes).find("damaged"), std::string::npos);
}

TEST(ModelFile, AnotherKindOfFileIsNamed) {
  EXPECT_EQ(failure("PK\x03\x04"), "the.model: not an affordance model");
}

TEST(ModelFile, IsWrittenWholeOrNotAtAll) {
  const std::filesystem::path folder =
      std::filesystem::path(::testing::TempDir()) / ("pacer_model_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const Model model = random_model(4);
  save(model, folder / "a.model");
  EXPECT_EQ(to_bytes(load(folder / "a.model")), to_bytes(model));
  EXPECT_THROW(save(model, folder / "a.model" / "b.model"), std::runtime_error);
  EXPECT_THROW((void)load(folder / "none.model"), std::system_error);
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1)
      << "nothing is left aside";
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace pacer::affordance
