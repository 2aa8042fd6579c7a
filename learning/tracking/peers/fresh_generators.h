// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

namespace pacer::tracking {

/// OpenCV's trackers draw from rand() and cv::theRNG(), which the whole process shares. Each gets
/// two of its own, lent for the time of a call, whatever else runs in turns with it. With seed 1
/// they are as when a program starts, so that its tracks are those of one. Nothing of ours draws
/// from either.
class FreshGenerators {
 public:
  explicit FreshGenerators(std::uint64_t seed);
  FreshGenerators(const FreshGenerators&) = delete;
  FreshGenerators& operator=(const FreshGenerators&) = delete;

  /// While it lives, the process draws from these; afterwards from its own, as it left them. One at
  /// a time, on one thread.
  class Loan {
   public:
    explicit Loan(FreshGenerators& generators);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;

   private:
    FreshGenerators& generators_;
    char* process_rand_;
    std::uint64_t process_cv_;
  };

 private:
  alignas(std::int32_t) std::array<char, 128> rand_{};  // as large as the C library's own
  std::uint64_t cv_;
};

}  // namespace pacer::tracking
