// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <cstdint>

#include "core/drive.h"

namespace pacer {

/// A number that forked workers raise and their parent reads.
class SharedCounter {
 public:
  SharedCounter();  ///< throws std::system_error when the kernel has no page to spare
  ~SharedCounter();
  SharedCounter(const SharedCounter&) = delete;
  SharedCounter& operator=(const SharedCounter&) = delete;

  /// Returns what it was before.
  std::uint64_t add(std::uint64_t amount) noexcept {
    return value_->fetch_add(amount, std::memory_order_relaxed);
  }
  [[nodiscard]] std::uint64_t value() const noexcept {
    return value_->load(std::memory_order_relaxed);
  }

 private:
  std::atomic<std::uint64_t>* value_;
};

/// Counts steps.
class StepCounter final : public StepSink {
 public:
  explicit StepCounter(SharedCounter& counter) : counter_(counter) {}
  [[nodiscard]] bool write(const Frame&, const Step&) override {
    counter_.add(1);
    return true;
  }

 private:
  SharedCounter& counter_;
};

}  // namespace pacer
