// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/hash.h"
#include "learning/baselines/nearest_model.h"
#include "learning/baselines/ridge_model.h"
#include "learning/baselines/supervised_model.h"
#include "learning/baselines/tracker_model.h"
#include "learning/exemplar/train.h"
#include "runs/model_description.h"
#include "runs/model_kinds.h"
#include "tests/learning/affordance/random_model.h"
#include "tests/learning/exemplar/disc_world.h"

namespace pacer {
namespace {

constexpr ImageSize kSize{.width = 160, .height = 120};

baselines::Origin origin() {
  return {.image_size = kSize,
          .frame_rate_hz = 25.0,
          .scenario = "car: simulated\n",
          .fingerprint = "0123abcd",
          .mean = {.steering = 0.1, .throttle = 0.2}};
}

std::vector<float> draw(std::size_t count, Random random) {
  std::vector<float> values(count);
  for (float& value : values) value = static_cast<float>(random.normal(0.0, 0.1));
  return values;
}

baselines::BoxDriving driving() {
  baselines::BoxDriving driving;
  driving.action.map << -0.01, 0.0, 0.0, 0.001, 0.8, 0.0, -0.002, -0.002, 0.0, 0.5;
  return driving;
}

std::string affordances() {
  affordance::Model model = testing::random_model(20);
  model.image_size = kSize;
  return to_bytes(model);
}

std::string exemplars() {
  return to_bytes(exemplar::train(testing::DiscDemonstration::any(3, 10, 3), {}).model);
}

std::string nearest() {
  baselines::NearestModel model;
  model.origin = origin();
  model.size = {.width = 8, .height = 6};
  model.neighbours = 3;
  model.pictures.pixels = 48;
  Random random(5);
  for (int i = 0; i < 20 * 48; ++i) {
    model.pictures.values.push_back(
        static_cast<std::int8_t>(static_cast<int>(random.below(255)) - 127));
  }
  for (int i = 0; i < 20; ++i) {
    model.commands.push_back(
        {.steering = random.uniform(-1.0, 1.0), .throttle = random.uniform(-1.0, 1.0)});
  }
  return to_bytes(model);
}

std::string ridge(baselines::PictureKind kind) {
  baselines::RidgeModel model;
  model.origin = origin();
  model.features = {.kind = kind, .size = {.width = 32, .height = 24}};
  model.ridge = 0.1;
  const std::size_t inputs = baselines::PictureFeatures(model.features, kSize).count();
  model.action = {.bias = {.steering = 0.1, .throttle = 0.2},
                  .steering = draw(inputs, Random(1)),
                  .throttle = draw(inputs, Random(2))};
  return to_bytes(model);
}

std::string supervised() {
  baselines::SupervisedModel model;
  model.origin = origin();
  model.detector.aspect = 1.3;
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    model.detector.weak.push_back(
        {.feature = static_cast<std::int32_t>(random.below(baselines::WaldBoost::kFeatures)),
         .polarity = random.chance(0.5) ? 1 : -1,
         .threshold = static_cast<float>(random.below(255)) + 0.5F,
         .weight = static_cast<float>(random.uniform(0.1, 0.5)),
         .least = static_cast<float>(-0.3 * std::sqrt(i))});
  }
  model.driving = driving();
  return to_bytes(model);
}

std::string tracker() {
  return to_bytes(baselines::TrackerModel{origin(), "LP-CASCADE", driving()});
}

/// A way to learn, with a small model learnt so.
struct Case {
  std::string method;
  std::string (*bytes)();
};

std::ostream& operator<<(std::ostream& out, const Case& one) { return out << one.method; }

/// Points at the same box in every first frame.
class FixedPointer final : public TargetPointer {
 public:
  std::optional<Box> point() override { return std::exchange(box_, std::nullopt); }

 private:
  std::optional<Box> box_ = Box{.x = 80, .y = 60, .width = 40, .height = 30};
};

/// Grey, then noise, then noise that moves; a gap in time.
std::vector<Frame> frames(ImageSize size) {
  Random random(7);
  std::vector<Frame> frames(6);
  for (std::size_t i = 0; i < frames.size(); ++i) {
    Frame& frame = frames[i];
    frame.index = i < 4 ? i : i + 20;
    frame.time = Seconds{static_cast<double>(frame.index) / 25.0};
    frame.size = size;
    frame.rgb.assign(static_cast<std::size_t>(3 * size.width * size.height), 128);
    if (i == 1) {
      for (auto& value : frame.rgb) value = static_cast<std::uint8_t>(random.below(256));
    }
    if (i > 1) {
      frame.rgb = frames[i - 1].rgb;
      std::rotate(frame.rgb.begin(), frame.rgb.begin() + 6, frame.rgb.end());
    }
  }
  return frames;
}

std::vector<Command> drive(const PolicyModel& model, const std::vector<Frame>& frames) {
  std::unique_ptr<TargetPointer> pointer;
  if (model.given_boxes() == GivenBoxes::kAtTheStart) pointer = std::make_unique<FixedPointer>();
  const std::unique_ptr<Policy> policy = model.make(Random(1), std::move(pointer));
  std::vector<Command> commands;
  Command last;
  Annotations annotations;
  for (const Frame& frame : frames) {
    annotations.clear();
    last = policy->act({.frame = frame, .last = last}, annotations);
    commands.push_back(last);
  }
  return commands;
}

std::string failure(std::string_view bytes) {
  try {
    (void)read_model(bytes, "the.model");
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

/// The bytes as if a program had written them so: with the right checksum.
std::string resealed(std::string bytes) {
  constexpr std::size_t kHeader = 8 + 4 + 8;
  const std::uint64_t sum =
      fnv1a(std::string_view(bytes).substr(kHeader, bytes.size() - kHeader - 8));
  std::memcpy(bytes.data() + bytes.size() - 8, &sum, 8);
  return bytes;
}

class EveryModel : public ::testing::TestWithParam<Case> {};
INSTANTIATE_TEST_SUITE_P(
    OfEveryMethod, EveryModel,
    ::testing::Values(Case{"affordance", affordances}, Case{"exemplar", exemplars},
                      Case{"nearest", nearest},
                      Case{"ridge", [] { return ridge(baselines::PictureKind::kGrey); }},
                      Case{"ridge-hog", [] { return ridge(baselines::PictureKind::kHog); }},
                      Case{"supervised", supervised}, Case{"tracker", tracker}),
    [](const auto& test) {
      std::string name = test.param.method;
      std::erase(name, '-');
      return name;
    });

TEST_P(EveryModel, IsReadByWhatItsFirstBytesSay) {
  const LoadedModel loaded = read_model(GetParam().bytes(), "the.model");
  EXPECT_EQ(loaded.model->method(), GetParam().method);
  EXPECT_EQ(loaded.kind->file.magic.size(), 8U);
  const ModelDescription about = loaded.kind->describe(*loaded.model);
  EXPECT_TRUE(about.json.contains("fingerprint"));
  EXPECT_TRUE(about.text.ends_with("\n"));
  EXPECT_EQ(about.json.contains("given_boxes"), loaded.model->given_boxes() != GivenBoxes::kNone);
}

TEST_P(EveryModel, EveryTruncationIsRefusedInOneLineThatNamesTheFile) {
  const std::string bytes = GetParam().bytes();
  for (std::size_t size = 0; size < bytes.size(); size += size < 64 ? 1 : 1 + bytes.size() / 50) {
    const std::string why = failure(bytes.substr(0, size));
    EXPECT_TRUE(why.starts_with("the.model: ")) << size << ": " << why;
    EXPECT_EQ(why.find('\n'), std::string::npos);
  }
  EXPECT_NE(failure(bytes + "x"), "");
}

TEST_P(EveryModel, EveryFlippedByteIsRefused) {
  std::string bytes = GetParam().bytes();
  for (std::size_t i = 0; i < bytes.size(); i += i < 64 ? 1 : 1 + bytes.size() / 50) {
    bytes[i] = static_cast<char>(bytes[i] ^ 0x40);
    EXPECT_NE(failure(bytes), "") << i;
    bytes[i] = static_cast<char>(bytes[i] ^ 0x40);
  }
}

TEST_P(EveryModel, AnotherVersionSaysWhatToDo) {
  std::string bytes = GetParam().bytes();
  bytes[8] = 77;
  EXPECT_NE(failure(bytes).find("version 77"), std::string::npos);
  EXPECT_NE(failure(bytes).find("train it again"), std::string::npos);
}

TEST_P(EveryModel, HostileBytesUnderAGoodChecksumAreRefusedOrHarmless) {
  const std::string bytes = GetParam().bytes();
  Random random(9);
  int refused = 0;
  for (int trial = 0; trial < 150; ++trial) {
    std::string hostile = bytes;
    // The settings lie at the front and the back.
    const std::size_t span = std::min<std::size_t>(bytes.size() - 28, 400);
    const std::size_t from = random.below(span);
    const std::size_t at = trial % 2 == 0 ? 20 + from : bytes.size() - 9 - from;
    for (std::size_t i = at; i < std::min(at + 8, bytes.size() - 8); ++i) {
      hostile[i] = static_cast<char>(random.chance(0.5) ? 0xff : random.below(256));
    }
    hostile = resealed(hostile);
    std::shared_ptr<const PolicyModel> model;
    try {
      model = read_model(hostile, "the.model").model;
    } catch (const std::runtime_error& error) {
      ++refused;
      EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
      continue;
    }
    if (trial % 10 != 0) continue;
    std::vector<Frame> two = frames(kSize);
    two.resize(2);
    try {
      for (const Command& command : drive(*model, two)) EXPECT_EQ(command, clamped(command));
    } catch (const std::runtime_error&) {  // frames of another size, say
    }
  }
  EXPECT_GT(refused, 0);
}

TEST_P(EveryModel, DrivesTheSameEachTimeAndWithinTheStick) {
  const LoadedModel loaded = read_model(GetParam().bytes(), "the.model");
  const std::vector<Command> commands = drive(*loaded.model, frames(kSize));
  EXPECT_EQ(commands, drive(*loaded.model, frames(kSize)));
  for (const Command& command : commands) EXPECT_EQ(command, clamped(command));
  EXPECT_EQ(loaded.model->mean_command(), clamped(loaded.model->mean_command()));
}

TEST_P(EveryModel, RefusesFramesOfAnotherSize) {
  const LoadedModel loaded = read_model(GetParam().bytes(), "the.model");
  for (const ImageSize size : {ImageSize{320, 240}, {160, 119}, {8, 6}}) {
    EXPECT_THROW((void)drive(*loaded.model, frames(size)), std::runtime_error);
  }
}

TEST(ModelKinds, HaveFirstBytesOfTheirOwn) {
  std::set<std::string_view> magics;
  for (const auto& bytes : {affordances(), exemplars(), nearest(),
                            ridge(baselines::PictureKind::kGrey), supervised(), tracker()}) {
    EXPECT_TRUE(magics.insert(read_model(bytes, "a").kind->file.magic).second);
  }
}

TEST(ModelKinds, AnythingElseIsNoModel) {
  EXPECT_EQ(failure("PK\x03\x04"), "the.model: not a model; `pacer train` makes one");
  EXPECT_EQ(failure(""), "the.model: not a model; `pacer train` makes one");
}

TEST(ModelKinds, OnlyTheTrackerNeedsToBeShownItsTarget) {
  EXPECT_THROW((void)read_model(tracker(), "a").model->make(Random(1), nullptr),
               std::runtime_error);
  EXPECT_NO_THROW((void)read_model(supervised(), "a").model->make(Random(1), nullptr));
}

}  // namespace
}  // namespace pacer
