// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <set>

#include "core/car.h"

namespace pacer::testing {

/// Every Car keeps this contract. A new one joins by naming a factory:
///   INSTANTIATE_TYPED_TEST_SUITE_P(Sim, CarContract, SimCarFactory);
/// where SimCarFactory{}() returns a std::unique_ptr<Car> good for ten to a hundred frames.
template <class Factory>
class CarContract : public ::testing::Test {
 protected:
  std::unique_ptr<Car> car_ = Factory{}();
};
TYPED_TEST_SUITE_P(CarContract);

TYPED_TEST_P(CarContract, FramesComeInOrderWithRisingTime) {
  const Frame* frame = this->car_->look();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->index, 0U);
  Seconds before = frame->time;
  for (int i = 1; i < 10; ++i) {
    frame = this->car_->look();
    ASSERT_NE(frame, nullptr);
    EXPECT_GT(frame->time, before);
    before = frame->time;
  }
}

TYPED_TEST_P(CarContract, FrameHoldsAsManyBytesAsItsSizeSays) {
  const Frame* frame = this->car_->look();
  ASSERT_NE(frame, nullptr);
  EXPECT_EQ(frame->rgb.size(), static_cast<std::size_t>(frame->size.width) *
                                   static_cast<std::size_t>(frame->size.height) * 3U);
}

TYPED_TEST_P(CarContract, SignalsFillTheirColumns) {
  ASSERT_NE(this->car_->look(), nullptr);
  std::size_t components = 0;
  std::set<std::string> names;
  for (const SignalColumn& column : this->car_->signal_columns()) {
    EXPECT_FALSE(column.components.empty()) << column.name;
    EXPECT_TRUE(names.insert(column.name).second) << column.name;
    components += column.components.size();
  }
  EXPECT_EQ(this->car_->signals().size(), components);
}

TYPED_TEST_P(CarContract, TheEndIsTheEnd) {
  for (int i = 0; i < 1000 && this->car_->look() != nullptr; ++i) {
  }
  EXPECT_EQ(this->car_->look(), nullptr);
  EXPECT_EQ(this->car_->look(), nullptr);
}

REGISTER_TYPED_TEST_SUITE_P(CarContract, FramesComeInOrderWithRisingTime,
                            FrameHoldsAsManyBytesAsItsSizeSays, SignalsFillTheirColumns,
                            TheEndIsTheEnd);

}  // namespace pacer::testing
