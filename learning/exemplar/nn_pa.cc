// SPDX-License-Identifier: Apache-2.0
#include "learning/exemplar/nn_pa.h"

#include <limits>
#include <nanoflann.hpp>

#include "learning/exemplar/column_scale.h"

namespace pacer::exemplar {
namespace {

/// What each number is multiplied by: 1, or one over its standard deviation.
std::vector<double> scales(const Exemplars& exemplars, PerceptUnits units) {
  if (units == PerceptUnits::kStandardised) return scale_of(exemplars).inverse_sd;
  return std::vector<double>(exemplars.percept_size(), 1.0);
}

}  // namespace

NnPa::NnPa(const Exemplars& exemplars, PerceptUnits units)
    : exemplars_(exemplars), scale_(scales(exemplars, units)) {}

std::size_t NnPa::nearest(std::span<const double> percept) const {
  require_percept(percept, exemplars_.percept_size());
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < exemplars_.size(); ++n) {
    const std::span<const double> other = exemplars_.percept(n);
    double sum = 0.0;
    for (std::size_t i = 0; i < percept.size(); ++i) {
      const double apart = scale_[i] * (percept[i] - other[i]);
      sum += apart * apart;
    }
    if (sum < least) {
      least = sum;
      nearest = n;
    }
  }
  return nearest;
}

struct NnPaTree::Index {
  /// The percepts as nanoflann reads them.
  struct Points {
    std::vector<double> values;  // N x size
    std::size_t size;
    [[nodiscard]] std::size_t kdtree_get_point_count() const { return values.size() / size; }
    [[nodiscard]] double kdtree_get_pt(std::size_t n, std::size_t i) const {
      return values[n * size + i];
    }
    template <class Box>
    bool kdtree_get_bbox(Box& /*box*/) const {
      return false;  // it works it out
    }
  };
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Adaptor<double, Points>, Points,
                                                   -1, std::size_t>;

  std::vector<double> scale;
  Points points;
  Tree tree;

  Index(const Exemplars& exemplars, std::vector<double> scale_by)
      : scale(std::move(scale_by)),
        points{.values = {}, .size = exemplars.percept_size()},
        tree(static_cast<int>(points.size), points,
             nanoflann::KDTreeSingleIndexAdaptorParams(
                 16, nanoflann::KDTreeSingleIndexAdaptorFlags::SkipInitialBuildIndex)) {
    points.values.assign(exemplars.percepts().begin(), exemplars.percepts().end());
    for (std::size_t k = 0; k < points.values.size(); ++k) {
      points.values[k] *= scale[k % points.size];
    }
    tree.buildIndex();
  }
};

NnPaTree::NnPaTree(const Exemplars& exemplars, PerceptUnits units)
    : index_(std::make_unique<Index>(exemplars, scales(exemplars, units))) {}
NnPaTree::~NnPaTree() = default;
NnPaTree::NnPaTree(NnPaTree&&) noexcept = default;

std::size_t NnPaTree::nearest(std::span<const double> percept) const {
  require_percept(percept, index_->points.size);
  std::vector<double> point(percept.begin(), percept.end());
  for (std::size_t i = 0; i < point.size(); ++i) point[i] *= index_->scale[i];
  std::size_t nearest = 0;
  double squared = 0.0;
  index_->tree.knnSearch(point.data(), 1, &nearest, &squared);
  return nearest;
}

}  // namespace pacer::exemplar
