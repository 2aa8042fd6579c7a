// SPDX-License-Identifier: Apache-2.0
#include "core/constant_policy.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/contract/policy_contract.h"

namespace pacer {
namespace {

TEST(ConstantPolicy, AsksForItsCommandWithinTheStick) {
  Frame frame;
  Annotations annotations;
  ConstantPolicy policy({.steering = 0.2, .throttle = 7.0});
  EXPECT_EQ(policy.act({.frame = frame, .last = {}}, annotations),
            (Command{.steering = 0.2, .throttle = 1.0}));
}

TEST(NeutralPolicy, AsksForNothing) {
  Frame frame;
  Annotations annotations;
  EXPECT_EQ(NeutralPolicy().act({.frame = frame, .last = {.steering = 1.0}}, annotations),
            Command{});
}

struct NeutralFactory {
  std::unique_ptr<Policy> operator()() const { return std::make_unique<NeutralPolicy>(); }
};
struct NanFactory {  // a mean of no demonstrations
  std::unique_ptr<Policy> operator()() const {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    return std::make_unique<ConstantPolicy>(Command{.steering = nan, .throttle = nan});
  }
};

}  // namespace

namespace testing {
INSTANTIATE_TYPED_TEST_SUITE_P(Neutral, PolicyContract, NeutralFactory);
INSTANTIATE_TYPED_TEST_SUITE_P(Nan, PolicyContract, NanFactory);
}  // namespace testing
}  // namespace pacer
