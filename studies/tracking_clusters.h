// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "core/box.h"
#include "learning/tracking/medoidshift.h"
#include "learning/tracking/target_template.h"
#include "runs/report/page.h"

namespace pacer {

/// The templates of a target, clustered by medoidshift as LP-MED does: Figure 4.5.
class ClusteredTemplates {
 public:
  /// For a target of this size, through the first `pictures`; the templates of the last are kept.
  explicit ClusteredTemplates(const Box& target, std::size_t pictures = 400);

  /// The target as it is in the next picture, about the centre of `box`.
  void add(const cv::Mat1b& grey, const Box& box);
  /// Adds the distance matrix, in the order of time and sorted by cluster, and the largest
  /// clusters' modes.
  void add_to(report::Page& page) const;

 private:
  /// Points of one mode, in the order of time.
  struct Cluster {
    std::size_t mode = 0;
    std::vector<std::size_t> points;
  };
  [[nodiscard]] std::vector<Cluster> largest_first() const;
  [[nodiscard]] std::vector<std::uint8_t> draw(const std::vector<std::size_t>& order) const;

  tracking::TemplateGrid grid_;
  tracking::Medoidshift clusters_;
  std::vector<std::uint8_t> templates_;  // in the order of the clusters' points
  std::vector<std::size_t> pictures_;    // that each of them is from
  std::vector<double> distances_;
  std::size_t most_, seen_ = 0;
};

}  // namespace pacer
