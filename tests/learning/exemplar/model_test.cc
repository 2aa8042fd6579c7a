// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/model.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <memory>
#include <system_error>

#include "learning/exemplar/best_first.h"
#include "learning/exemplar/policy.h"
#include "tests/learning/exemplar/painted.h"
#include "tests/learning/exemplar/random_exemplars.h"

namespace pacer::exemplar {
namespace {

Model random_model(std::size_t exemplars) {
  ExemplarConfig config;
  config.hierarchy.tau = 12.5;
  config.response.choose = "sample";
  return {.config = config,
          .image_size = {.width = 320, .height = 240},
          .scenario = "seed: 1",
          .fingerprint = "0123",
          .drift = Eigen::Matrix2d{{0.2, 0.01}, {0.01, 0.1}},
          .hierarchy = Hierarchy(pacer::testing::random_exemplars(exemplars, kPerceptSize,
                                                                  kActionSize, Random(exemplars)),
                                 config.hierarchy)};
}

std::string failure(std::string_view bytes) {
  try {
    (void)from_bytes(bytes, "the.model");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// Searches, responds and drives, as whoever reads the file will.
void use(const Model& model) {
  const Hierarchy& hierarchy = model.hierarchy;
  Searcher searcher(hierarchy);
  const NodeIndex index(hierarchy);
  BestFirstSearcher pruned(hierarchy, index);
  Random random(1);
  for (std::size_t n = 0; n < hierarchy.exemplars().size(); ++n) {
    const auto percept = hierarchy.exemplars().percept(n);
    for (const double tau : {1.0, 1e6}) {
      EXPECT_LT(searcher.find(percept, tau).best.node, hierarchy.tree().nodes().size());
      EXPECT_LT(pruned.find(percept, tau).best.node, hierarchy.tree().nodes().size());
    }
  }
  if (model.image_size != ImageSize{.width = 320, .height = 240}) return;
  ExemplarPolicy policy(std::make_shared<const Model>(model), Random(1));
  Frame frame = testing::wall(model.image_size);
  testing::fill_ball(frame, 100.0, 60.0, 30.0, testing::kRedRubber);
  testing::fill_ball(frame, 200.0, 60.0, 20.0, testing::kGreenRubber);
  for (int i = 0; i < 3; ++i) {
    Annotations annotations;
    const Command command = policy.act({.frame = frame, .last = {}}, annotations);
    EXPECT_LE(std::abs(command.steering), 1.0);
    EXPECT_LE(std::abs(command.throttle), 1.0);
  }
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
}

TEST(ModelFile, KeepsEverythingAndTheSameHierarchy) {
  const Model model = random_model(80);
  const Model read = from_bytes(to_bytes(model), "the.model");
  EXPECT_EQ(read.hierarchy.config(), model.hierarchy.config());
  EXPECT_EQ(read.config.response.choose, "sample");
  EXPECT_EQ(read.image_size, model.image_size);
  EXPECT_EQ(read.drift, model.drift);
  EXPECT_EQ(read.scenario, model.scenario);
  EXPECT_EQ(read.fingerprint, model.fingerprint);
  ASSERT_EQ(read.hierarchy.tree().nodes().size(), model.hierarchy.tree().nodes().size());
  for (NodeId node = 0; node < read.hierarchy.tree().nodes().size(); ++node) {
    ASSERT_EQ(read.hierarchy.has_model(node), model.hierarchy.has_model(node));
    if (!read.hierarchy.has_model(node)) continue;
    EXPECT_EQ(read.hierarchy.percept_model(node).covariance,
              model.hierarchy.percept_model(node).covariance);
  }
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
  int used = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::string hostile = bytes;
    const std::size_t at = 20 + random.below(bytes.size() - 28);
    for (std::size_t i = at; i < std::min(at + 8, bytes.size() - 8); ++i) {
      hostile[i] = static_cast<char>(random.chance(0.5) ? 0xff : random.below(256));
    }
    try {
      use(from_bytes(resealed(hostile), "the.model"));
      ++used;
    } catch (const std::runtime_error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 50);
  EXPECT_GT(used, 20);
}

TEST(ModelFile, NumbersOfAnyGreatnessAreHarmless) {
  Random random(10);
  for (int trial = 0; trial < 60; ++trial) {
    Model model = random_model(12);
    const Exemplars& usual = model.hierarchy.exemplars();
    std::vector<double> percepts(usual.percepts().begin(), usual.percepts().end());
    std::vector<double> actions(usual.actions().begin(), usual.actions().end());
    for (std::vector<double>* numbers : {&percepts, &actions}) {
      for (double& number : *numbers) {
        if (random.chance(0.1)) number = random.normal(0.0, 1.0) * std::pow(10.0, random.below(99));
      }
    }
    model.config.naming = trial % 2 == 0 ? "table" : "statistics";
    model.config.response.choose = trial % 3 == 0 ? "sample" : "consistent";
    model.hierarchy = Hierarchy(Exemplars(kPerceptSize, kActionSize, percepts, actions), {});
    use(from_bytes(to_bytes(model), "the.model"));
  }
}

TEST(ModelFile, IsOfPicturesThatThereCanBe) {
  Model model = random_model(2);
  for (const ImageSize size :
       {ImageSize{.width = 0, .height = 240}, ImageSize{.width = 320, .height = -1},
        ImageSize{.width = 1, .height = 2147483647}, ImageSize{.width = 2147483647, .height = 1},
        ImageSize{.width = 16385, .height = 16384}, ImageSize{.width = 20, .height = 340}}) {
    model.image_size = size;
    EXPECT_NE(failure(to_bytes(model)).find("image size"), std::string::npos) << size.width;
  }
  for (const ImageSize size :
       {ImageSize{.width = 16384, .height = 16384}, ImageSize{.width = 20, .height = 320}}) {
    model.image_size = size;
    EXPECT_EQ(failure(to_bytes(model)), "");
  }
}

TEST(ModelFile, HasADriftThatCanBeInverted) {
  Model model = random_model(2);
  const auto drift_of = [](double a, double b, double c, double d) {
    Eigen::Matrix2d drift;
    drift << a, b, c, d;
    return drift;
  };
  for (const Eigen::Matrix2d& drift :
       {drift_of(0.0, 0.0, 0.0, 0.1), drift_of(-0.1, 0.0, 0.0, -0.1),
        drift_of(0.1, 0.05, -0.05, 0.1), drift_of(1e-200, 0.0, 0.0, 1e-100),
        drift_of(1e200, 0.0, 0.0, 1e100), drift_of(std::nan(""), 0.0, 0.0, 0.1)}) {
    model.drift = drift;
    EXPECT_NE(failure(to_bytes(model)).find("drift"), std::string::npos) << drift;
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
  EXPECT_EQ(failure("PK\x03\x04"), "the.model: not an exemplar model");
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
}  // namespace pacer::exemplar
