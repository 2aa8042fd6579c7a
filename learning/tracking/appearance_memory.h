// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "learning/tracking/appearance.h"

namespace pacer::tracking {

struct AppearanceMemoryConfig {
  int aspects = 12;        ///< remembered at most; the first is never forgotten
  double distrust = 0.05;  ///< likeness that an aspect loses for each one it was learnt through

  /// Throws std::invalid_argument, naming the field.
  void validate() const;
};

/// The aspects of a target so far. An aspect is learnt where another one put the target, mistakes
/// included: those that are fewer steps from the first are preferred, which is what stops drift.
class AppearanceMemory {
 public:
  explicit AppearanceMemory(const AppearanceMemoryConfig& config);

  /// Forgets everything, and makes room for aspects of `pixels` intensities.
  void clear(Eigen::Index pixels);
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] const Aspect& operator[](std::size_t index) const { return entries_[index].aspect; }

  /// The aspect that `seen` is most like, distrust taken off.
  [[nodiscard]] std::size_t match(const Eigen::VectorXf& seen) const;

  /// Marks an aspect as used: it did show the target.
  void use(std::size_t aspect);

  /// Learns what is in the middle of `patch`, where aspect `parent` put it; once the memory is
  /// full, in place of the one that has not been used for longest.
  void remember(AspectTrainer& trainer, const Patch& patch, std::size_t parent);

 private:
  struct Entry {
    Aspect aspect;
    int generation = 0;           // steps from the first
    std::uint64_t last_used = 0;  // uses of any, so far
  };

  AppearanceMemoryConfig config_;
  std::vector<Entry> entries_;  // as many as there may be: learning anew allocates nothing
  std::size_t size_ = 0;
  std::uint64_t uses_ = 0;
};

}  // namespace pacer::tracking
