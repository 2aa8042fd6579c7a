// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <memory>
#include <opencv2/features2d.hpp>
#include <optional>

#include "core/frame.h"
#include "learning/exemplar/colour_table.h"

namespace pacer {

/// The balloons as OpenCV finds them: its maximally stable regions of colour pictures (Forssen's
/// MSCR, 2007), each named by the same colour table; the largest of a name.
class MserBalloons {
 public:
  struct Seen {
    Eigen::Vector2d centroid;
    double area = 0.0;
  };

  MserBalloons();

  [[nodiscard]] std::array<std::optional<Seen>, exemplar::kNames> find(const Frame& frame);

 private:
  cv::Ptr<cv::MSER> mser_;
  exemplar::ColourTable table_;
};

}  // namespace pacer
