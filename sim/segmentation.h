// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/frame.h"
#include "sim/lens.h"
#include "sim/renderer.h"
#include "sim/visibility.h"

namespace pacer::sim {

/// What one picture shows of one balloon: its rubber, neither string nor weight. Pixels: (0, 0) is
/// the top-left pixel's centre.
struct BalloonSight {
  int pixels = 0;   ///< that show it
  int covered = 0;  ///< that would, were it not for the interference
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();  ///< of `pixels`; zero where there are none
  Eigen::Vector2d low = Eigen::Vector2d::Zero();       ///< centre of the first column and row,
  Eigen::Vector2d high = Eigen::Vector2d::Zero();      ///< of the last of `pixels`
};

/// Both balloons in one picture, exactly.
struct BalloonSights {
  BalloonSight red;
  BalloonSight green;
  int spoilt_rows = 0;  ///< of the picture, that interference covers
};

/// What a pixel shows.
enum class Label : std::uint8_t { kOther = 0, kRed = 1, kGreen = 2 };

/// Tells which pixels of a camera's picture show the balloons: the same scene drawn in flat
/// colours and brought through the same lens, the nearest pixel of it for each of the picture. A
/// pixel that motion blurs shows what lies in the middle of the light's way over it: an edge is
/// where half of the light comes from either side.
class Segmentation {
 public:
  /// A model without balloons shows none. `lens` is the one that the picture is taken through.
  Segmentation(const mjModel& model, const Lens& lens);

  /// Of the picture whose shutter closes at the instant that `data` holds (as for
  /// `renderer.render()`, whose model it is) and in which all moved by `field`, MotionBlur's; with
  /// none, nothing did. Pixels in the `covered` rows do not show anything. Lives until the next
  /// call.
  [[nodiscard]] const BalloonSights& look(const mjModel& model, mjData& data, Renderer& renderer,
                                          std::span<const RowBand> covered = {},
                                          std::span<const Eigen::Vector2f> field = {});

  /// Of the last look: height x width, top row first, the interference left out of account.
  [[nodiscard]] std::span<const Label> labels() const noexcept { return labels_; }

 private:
  ImageSize size_;
  std::vector<Rgb> colours_;              // a geom of the model each
  std::vector<Eigen::Vector2f> sources_;  // for each pixel, where it lies in what was rendered
  Frame flat_;
  std::vector<Label> labels_;
  BalloonSights sights_;
};

}  // namespace pacer::sim
