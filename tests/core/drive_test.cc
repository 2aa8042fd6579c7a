// SPDX-License-Identifier: Apache-2.0
#include "core/drive.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/contract/car_contract.h"
#include "tests/support/fake_car.h"

namespace pacer {
namespace {

using testing::FakeCar;

struct FullLeft final : Policy {
  Command act(const Observation&, Annotations&) override {
    return {.steering = 1.0, .throttle = 0.2};
  }
};
struct Throwing final : Policy {
  Command act(const Observation&, Annotations&) override {
    throw std::runtime_error("policy failed");
  }
};
struct Counting final : StepSink {
  explicit Counting(int most) : most_(most) {}
  bool write(const Frame&, const Step&) override { return ++steps < most_; }
  int steps = 0;

 private:
  int most_;
};

TEST(Drive, LeavesTheCarAtNeutralWhenTheRunEnds) {
  FakeCar car(5);
  FullLeft driver;
  Counting sink(100);
  const Channels channels;
  EXPECT_EQ(drive(car, driver, Limits{}, channels, sink), 5U);
  EXPECT_EQ(car.sent, channels.neutral());
}

TEST(Drive, LeavesTheCarAtNeutralWhenTheDriverThrows) {
  FakeCar car(5);
  Throwing driver;
  Counting sink(100);
  const Channels channels;
  EXPECT_THROW(drive(car, driver, Limits{}, channels, sink), std::runtime_error);
  EXPECT_EQ(car.sent, channels.neutral());
}

TEST(Drive, EndsWhenASinkAsksForIt) {
  FakeCar car(5);
  FullLeft driver;
  Counting one(2);
  Counting other(100);
  Sinks sinks({&one, &other});
  EXPECT_EQ(drive(car, driver, Limits{}, Channels{}, sinks), 2U);
  EXPECT_EQ(other.steps, 2) << "every sink sees every step";
}

TEST(Drive, EndsWhenAStopIsRequested) {
  FakeCar car(5);
  FullLeft driver;
  Counting sink(100);
  std::stop_source stop;
  stop.request_stop();
  EXPECT_EQ(drive(car, driver, Limits{}, Channels{}, sink, stop.get_token()), 0U);
}

struct FakeCarFactory {
  std::unique_ptr<Car> operator()() const { return std::make_unique<FakeCar>(20); }
};

}  // namespace

namespace testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Fake, CarContract, FakeCarFactory);
}
}  // namespace pacer
