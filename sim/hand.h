// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/command.h"
#include "core/random.h"

namespace pacer::sim {

/// The share of the way that a first-order lag of `constant` seconds goes in `elapsed`.
inline double lag_share(double elapsed, double constant) {
  return constant > 0.0 ? 1.0 - std::exp(-elapsed / constant) : 1.0;
}

/// One step of coloured noise (Ornstein and Uhlenbeck) of the given deviation; `constant` is its
/// correlation in seconds.
double coloured_noise(double value, double elapsed, double constant, double deviation,
                      Random& random);

/// How a scripted teacher's hand is unlike its wishes. Times in seconds, the rest in stick.
struct HandTraits {
  double smoothing;       ///< of its low-pass
  double steering_noise;  ///< deviation, coloured
  double throttle_noise;  ///< deviation, coloured
  double noise_time;      ///< correlation of the noise
  double steering_dead;   ///< smaller changes are not made
  double throttle_dead;   ///< likewise
};

/// A hand at the sticks: it is late, it trembles, and it does not bother with little.
class Hand {
 public:
  explicit Hand(const HandTraits& traits) : traits_(traits) {}

  /// Time goes on: to be called before move(). Draws twice from `random`.
  void tremble(double elapsed, Random& random);
  /// What the sticks show `elapsed` seconds on, the wish being `goal`; neutral is no wish, and
  /// nothing trembles.
  [[nodiscard]] Command move(const Command& goal, double elapsed);

 private:
  HandTraits traits_;
  Command tremor_, hand_, stick_;  // noise; smoothed wish; what the stick shows
};

/// What was perceived, until it is old enough to act on. `Percept` has a member `time`, in seconds.
template <class Percept>
class Reaction {
 public:
  /// One more, the newest. Of more than the ring holds the oldest is forgotten early.
  void perceive(const Percept& fresh) {
    if (count_ == kMost) {
      first_ = (first_ + 1) % kMost;
      --count_;
    }
    seen_[(first_ + count_++) % kMost] = fresh;
  }
  /// Takes out what is `time` or older; the latest of it, or `before` where there is none.
  [[nodiscard]] Percept act_on(double time, Percept before) {
    while (count_ > 0 && seen_[first_].time <= time + 1e-9) {
      before = seen_[first_];
      first_ = (first_ + 1) % kMost;
      --count_;
    }
    return before;
  }

 private:
  static constexpr std::size_t kMost = 64;
  std::array<Percept, kMost> seen_{};
  std::size_t first_ = 0, count_ = 0;
};

}  // namespace pacer::sim
