// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "core/car.h"

namespace pacer::testing {

/// A car of a few grey 4 x 2 pictures at 25 frames a second, which remembers what it was sent.
class FakeCar final : public Car {
 public:
  explicit FakeCar(std::uint64_t frames) : frames_(frames) {}

  const Frame* look() override {
    if (next_ == frames_) return nullptr;
    frame_.index = next_;
    frame_.time = Seconds{static_cast<double>(next_++) / 25.0};
    frame_.size = {.width = 4, .height = 2};
    frame_.rgb.assign(24, 128);
    return &frame_;
  }
  void send(const Pulses& pulses) override { sent = pulses; }

  Pulses sent;

 private:
  std::uint64_t frames_;
  std::uint64_t next_ = 0;
  Frame frame_;
};

}  // namespace pacer::testing
