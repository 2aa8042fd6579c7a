// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/marking.h"
#include "tests/learning/affordance/patch_world.h"

namespace pacer::testing {

inline Box box_of(const PatchStep& step) {
  return {.x = step.x, .y = step.y, .width = step.side, .height = step.side};
}

/// A patch world in which somebody marked the patch where it is visible.
class MarkedPatchDemonstration final : public MarkedDemonstration {
 public:
  explicit MarkedPatchDemonstration(std::vector<std::vector<PatchStep>> episodes)
      : episodes_(episodes), plain_(std::move(episodes)) {}

  /// `frames` of wandering in each of `episodes`.
  static MarkedPatchDemonstration wandering(int episodes, int frames, std::uint64_t seed) {
    std::vector<std::vector<PatchStep>> steps;
    for (int e = 0; e < episodes; ++e) {
      steps.push_back(wander(frames, Random(seed).fork("episode", static_cast<std::uint64_t>(e))));
    }
    return MarkedPatchDemonstration(std::move(steps));
  }

  [[nodiscard]] const std::vector<std::vector<PatchStep>>& episodes() const { return episodes_; }
  [[nodiscard]] std::size_t episode_count() const override { return plain_.episode_count(); }
  [[nodiscard]] double frame_rate_hz() const override { return plain_.frame_rate_hz(); }
  [[nodiscard]] ImageSize image_size() const override { return plain_.image_size(); }
  [[nodiscard]] std::string fingerprint() const override { return plain_.fingerprint(); }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override {
    return plain_.open(episode);
  }
  [[nodiscard]] std::unique_ptr<MarkedStream> open_marked(std::size_t episode) const override {
    return std::make_unique<Stream>(episodes_.at(episode), open(episode));
  }

 private:
  class Stream final : public MarkedStream {
   public:
    Stream(const std::vector<PatchStep>& steps, std::unique_ptr<DemonstrationStream> plain)
        : steps_(steps), plain_(std::move(plain)) {}
    const MarkedStep* next() override {
      const DemonstratedStep* step = plain_->next();
      if (step == nullptr) return nullptr;
      step_.step = *step;
      step_.target.reset();
      if (steps_[index_].visible) step_.target = box_of(steps_[index_]);
      ++index_;
      return &step_;
    }

   private:
    const std::vector<PatchStep>& steps_;
    std::unique_ptr<DemonstrationStream> plain_;
    std::size_t index_ = 0;
    MarkedStep step_;
  };

  std::vector<std::vector<PatchStep>> episodes_;
  PatchDemonstration plain_;
};

/// Points at the patch of one step.
class PatchPointer final : public TargetPointer {
 public:
  explicit PatchPointer(const PatchStep& step) : box_(box_of(step)) {}
  std::optional<Box> point() override { return std::exchange(box_, std::nullopt); }

 private:
  std::optional<Box> box_;
};

}  // namespace pacer::testing
