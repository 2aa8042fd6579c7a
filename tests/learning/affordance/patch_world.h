// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/annotation.h"
#include "core/demonstration.h"
#include "core/random.h"

namespace pacer::testing {

/// One moment of a flat world: a textured patch, the lead, before textured background.
struct PatchStep {
  double x = 0.0, y = 0.0;  ///< pixels, the patch's middle
  double side = 0.0;        ///< pixels
  double pan = 0.0;         ///< pixels, of the background
  bool visible = true;
  Command command;  ///< what the teacher does: steers towards it, the faster the smaller it is

  [[nodiscard]] BoxMark box() const;
};

/// Smooth wanderings of the patch, all drawn from `random`.
[[nodiscard]] std::vector<PatchStep> wander(int frames, Random random);

/// Draws steps. The same patch in every world; the background is the `background`-th of many.
class PatchPainter {
 public:
  explicit PatchPainter(std::uint64_t background);
  ~PatchPainter();
  PatchPainter(PatchPainter&&) noexcept;
  void paint(const PatchStep& step, std::uint64_t index, Frame& frame) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

inline constexpr ImageSize kPatchImage{160, 120};
inline constexpr double kPatchRate = 25.0;

/// Episodes of a patch world, painted as they are read.
class PatchDemonstration final : public Demonstration {
 public:
  PatchDemonstration(int episodes, int frames, std::uint64_t seed);
  explicit PatchDemonstration(std::vector<std::vector<PatchStep>> episodes)
      : episodes_(std::move(episodes)) {}

  [[nodiscard]] std::size_t episode_count() const override { return episodes_.size(); }
  [[nodiscard]] double frame_rate_hz() const override { return kPatchRate; }
  [[nodiscard]] ImageSize image_size() const override { return kPatchImage; }
  [[nodiscard]] std::string fingerprint() const override { return "patch world"; }
  [[nodiscard]] std::unique_ptr<DemonstrationStream> open(std::size_t episode) const override;

 private:
  std::vector<std::vector<PatchStep>> episodes_;
};

}  // namespace pacer::testing
