// SPDX-License-Identifier: Apache-2.0
#include "core/impulse.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "core/drive.h"
#include "core/random.h"
#include "tests/contract/policy_contract.h"
#include "tests/support/fake_car.h"

namespace pacer {
namespace {

constexpr ImpulseConfig kConfig{.move = Seconds{0.4}, .settle = Seconds{0.6}, .brake = 0.25};

/// Answers from a list, then with its last; remembers on which frames it was asked.
class Listed final : public Policy {
 public:
  explicit Listed(std::vector<Command> answers) : answers_(std::move(answers)) {}
  Command act(const Observation& observation, Annotations& annotations) override {
    asked.push_back(observation.frame.index);
    annotations.label = "seen";
    annotations.points.push_back({.at = {1.0F, 2.0F}});
    annotations.boxes.push_back({.low = {0.0F, 0.0F}, .high = {1.0F, 1.0F}});
    return answers_[std::min(asked.size(), answers_.size()) - 1];
  }
  [[nodiscard]] Driver driver() const override { return Driver::kTeacher; }
  std::vector<std::uint64_t> asked;

 private:
  std::vector<Command> answers_;
};

/// Remembers all steps, as a recording would.
struct Tape final : StepSink {
  bool write(const Frame& frame, const Step& step) override {
    frames.push_back(frame);
    wanted.push_back(step.wanted);
    sent.push_back(step.sent);
    marks.push_back(step.annotations);
    return true;
  }
  std::vector<Frame> frames;
  std::vector<Command> wanted, sent;
  std::vector<Annotations> marks;
};

/// `frames` of a drive by impulses at 25 frames a second.
Tape tape_of(Policy& policy, std::uint64_t frames, const ImpulseConfig& config = kConfig) {
  testing::FakeCar car(frames);
  ImpulsePolicy impulses(config, policy);
  Tape tape;
  drive(car, impulses, Limits{}, Channels{}, tape);
  return tape;
}

TEST(ImpulsePolicy, AsksOnlyWhileTheCarIsAtRest) {
  Listed policy({{.steering = 0.5, .throttle = 0.3}});
  tape_of(policy, 80);
  // 0.6 s of rest are 15 frames; from one question to the next it is a second, 25 frames.
  EXPECT_EQ(policy.asked, (std::vector<std::uint64_t>{15, 40, 65}));
}

TEST(ImpulsePolicy, HoldsTheCommandThenBrakesAndStands) {
  Listed policy({{.steering = 0.5, .throttle = 0.3}});
  const Tape tape = tape_of(policy, 41);
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(tape.wanted[i], Command{}) << i;
  for (std::size_t i = 15; i < 25; ++i) {
    EXPECT_EQ(tape.wanted[i], (Command{.steering = 0.5, .throttle = 0.3})) << i;
  }
  for (std::size_t i = 25; i < 40; ++i) {
    EXPECT_EQ(tape.wanted[i], (Command{.steering = 0.5, .throttle = -0.25})) << i;
  }
  EXPECT_EQ(tape.wanted[40].throttle, 0.3);
}

TEST(ImpulsePolicy, AsksAgainOnTheNextFrameAfterNeutral) {
  Listed policy({{}, {}, {.steering = 0.0, .throttle = 0.3}});
  tape_of(policy, 45);
  EXPECT_EQ(policy.asked, (std::vector<std::uint64_t>{15, 16, 17, 42}));
}

TEST(ImpulsePolicy, GoesAheadOnlyAndBadArithmeticIsNoImpulse) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Listed policy({{.steering = kNan, .throttle = kNan}, {.steering = 0.4, .throttle = -0.7}});
  const Tape tape = tape_of(policy, 40);
  EXPECT_EQ(policy.asked, (std::vector<std::uint64_t>{15, 16}));
  for (const Command& command : tape.wanted) EXPECT_EQ(command.throttle, 0.0);
  EXPECT_EQ(tape.wanted[16].steering, 0.4);
}

TEST(ImpulsePolicy, KeepsPointsAndLabelThroughTheImpulseAndBoxesOnTheirFrame) {
  Listed policy({{.steering = 0.5, .throttle = 0.3}});
  const Tape tape = tape_of(policy, 40);
  EXPECT_TRUE(tape.marks[14].label.empty());
  for (std::size_t i = 15; i < 40; ++i) {
    EXPECT_EQ(tape.marks[i].label, "seen") << i;
    EXPECT_EQ(tape.marks[i].points.size(), 1U) << i;
    EXPECT_EQ(tape.marks[i].boxes.size(), i == 15 ? 1U : 0U) << i;
  }
}

TEST(ImpulsePolicy, NamesTheDriverOfThePolicy) {
  Listed policy(std::vector<Command>(1));
  EXPECT_EQ(ImpulsePolicy(kConfig, policy).driver(), Driver::kTeacher);
}

TEST(ImpulsePolicy, RefusesAnImpulseWithoutDuration) {
  Listed policy(std::vector<Command>(1));
  EXPECT_THROW(ImpulsePolicy({.move = Seconds{0.0}}, policy), std::invalid_argument);
  EXPECT_THROW(ImpulsePolicy({.brake = 1.5}, policy), std::invalid_argument);
}

/// Plays a tape back, up to `length` steps.
class Playback final : public DemonstrationStream {
 public:
  Playback(const Tape& tape, std::size_t length) : tape_(tape), length_(length) {}
  const DemonstratedStep* next() override {
    if (next_ == length_) return nullptr;
    shown_ = tape_.frames[next_];
    // As a table of single precision has it.
    const auto single = [](double value) { return static_cast<double>(static_cast<float>(value)); };
    step_ = {.frame = &shown_,
             .command = {.steering = single(tape_.sent[next_].steering),
                         .throttle = single(tape_.sent[next_].throttle)}};
    ++next_;
    return &step_;
  }

 private:
  const Tape& tape_;
  std::size_t length_, next_ = 0;
  Frame shown_;
  DemonstratedStep step_;
};

struct Taken {
  std::uint64_t index;
  Command command;
};

std::vector<Taken> exemplars(const Tape& tape, std::size_t length) {
  ImpulseStream stream(std::make_unique<Playback>(tape, length));
  std::vector<Taken> taken;
  while (const ImpulseExemplar* exemplar = stream.next()) {
    taken.push_back({exemplar->frame->index, exemplar->command});
  }
  EXPECT_EQ(stream.next(), nullptr);
  return taken;
}

TEST(ImpulseStream, GivesBackWhatThePolicySawAndWanted) {
  Random random(4);
  std::vector<Command> answers;
  for (int i = 0; i < 40; ++i) {
    answers.push_back(
        {.steering = random.uniform(-1.0, 1.0), .throttle = random.uniform(0.01, 0.5)});
    if (random.chance(0.2)) answers.back() = {};
  }
  Listed policy(answers);
  const Tape tape = tape_of(policy, 1000);
  const std::vector<Taken> taken = exemplars(tape, tape.frames.size());
  std::size_t found = 0;
  for (std::size_t i = 0; i < policy.asked.size(); ++i) {
    const Command answer = answers[std::min(i, answers.size() - 1)];
    if (answer == Command{}) continue;
    ASSERT_LT(found, taken.size());
    EXPECT_EQ(taken[found].index, policy.asked[i]);
    EXPECT_NEAR(taken[found].command.steering, answer.steering, 1e-6);
    EXPECT_NEAR(taken[found].command.throttle, answer.throttle, 1e-6);
    ++found;
  }
  EXPECT_EQ(found, taken.size());
  EXPECT_GT(found, 25U);
}

TEST(ImpulseStream, ARecordingCutShortGivesOnlyImpulsesWhoseThrottleIsKnown) {
  Listed policy({{.steering = 0.5, .throttle = 0.3}, {.steering = -0.5, .throttle = 0.2}});
  const Tape tape = tape_of(policy, 80);
  for (std::size_t length = 0; length <= tape.frames.size(); ++length) {
    for (const Taken& taken : exemplars(tape, length)) {
      EXPECT_NEAR(taken.command.throttle, taken.index == 15 ? 0.3 : 0.2, 1e-6) << length;
    }
  }
  EXPECT_EQ(exemplars(tape, 15).size(), 0U);
  EXPECT_EQ(exemplars(tape, 17).size(), 0U);  // it still rises
  EXPECT_EQ(exemplars(tape, 22).size(), 1U);
}

TEST(ImpulseStream, AnEpisodeWithoutImpulsesGivesNone) {
  Listed policy(std::vector<Command>(1));
  EXPECT_TRUE(exemplars(tape_of(policy, 50), 50).empty());
  EXPECT_TRUE(exemplars(Tape{}, 0).empty());
}

/// Owns what it drives by impulses.
class OwningImpulses final : public Policy {
 public:
  Command act(const Observation& observation, Annotations& annotations) override {
    return impulses_.act(observation, annotations);
  }
  [[nodiscard]] Driver driver() const override { return impulses_.driver(); }

 private:
  Listed policy_{{{}, {.steering = 3.0, .throttle = 7.0}, {.steering = -1.0, .throttle = 0.2}}};
  ImpulsePolicy impulses_{{.move = Seconds{0.08}, .settle = Seconds{0.08}}, policy_};
};

struct ImpulseFactory {
  std::unique_ptr<Policy> operator()() const { return std::make_unique<OwningImpulses>(); }
};

}  // namespace
}  // namespace pacer

namespace pacer::testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Impulses, PolicyContract, ImpulseFactory);
}  // namespace pacer::testing
